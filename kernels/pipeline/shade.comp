// Phong: ambient, and diffuse and specular light as far as it is visible. Techniques differ in visibility only.
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 2) readonly buffer World { vec4 world_and_triangle[]; };
layout(std430, binding = 3) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = 4) readonly buffer Visibility { float visibility[]; };
layout(std430, binding = 5) writeonly buffer Colours { vec4 colours[]; };

const vec3 BACKGROUND = vec3(0.60, 0.70, 0.80);
const vec3 ALBEDO = vec3(0.80, 0.76, 0.70);
const float AMBIENT = 0.22;
const float SPECULAR = 0.15;
const float SHININESS = 24.0;

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint index = pixel.y * frame.size.x + pixel.x;
    if (receivers[index].map.w < 0.0) {
        colours[index] = vec4(BACKGROUND, 1.0);
        return;
    }
    vec3 world = world_and_triangle[index].xyz;
    vec3 to_eye = normalize(frame.eye.xyz - world);
    vec3 to_light = frame.light_origin.w == 1.0 ? normalize(frame.light_origin.xyz - world) : frame.light_origin.xyz;
    vec3 normal = normalize(normals[index].xyz);
    if (dot(normal, to_eye) < 0.0) normal = -normal;
    float diffuse = max(dot(normal, to_light), 0.0);
    float shine = diffuse > 0.0 ? pow(max(dot(reflect(-to_light, normal), to_eye), 0.0), SHININESS) : 0.0;
    float v = visibility[index];
    colours[index] = vec4(ALBEDO * (AMBIENT + v * diffuse) + vec3(v * SPECULAR * shine), 1.0);
}
