// From the G-buffer: where each pixel is in the shadow map, how deep, on which plane, and whether it faces the light.
// The plane is the triangle's own, turned towards the camera: interpolated normals would tilt it off the surface. They may
// however say what faces the light, unturned, as the thesis has it.   [hybrid.md, conventions 3]
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Positions { float positions[]; };
layout(std430, binding = 2) readonly buffer Triangles { uint indices[]; };
layout(std430, binding = 3) readonly buffer World { vec4 world_and_triangle[]; };
layout(std430, binding = 4) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = 5) writeonly buffer Receivers { Receiver receivers[]; };

vec3 corner(uint triangle, uint k) {
    uint v = 3u * indices[3u * triangle + k];
    return vec3(positions[v], positions[v + 1u], positions[v + 2u]);
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint index = pixel.y * frame.size.x + pixel.x;
    vec4 g = world_and_triangle[index];
    if (g.w == 0.0) {
        receivers[index] = Receiver(vec4(0.0, 0.0, 0.0, -1.0), vec4(0.0), vec4(0.0));
        return;
    }
    uint triangle = uint(g.w) - 1u;
    vec3 a = corner(triangle, 0u);
    vec3 normal = normalize(cross(corner(triangle, 1u) - a, corner(triangle, 2u) - a));
    if (dot(normal, frame.eye.xyz - g.xyz) < 0.0) normal = -normal;

    bool perspective = frame.light_origin.w == 1.0;
    vec3 to_light = perspective ? frame.light_origin.xyz - g.xyz : frame.light_origin.xyz;
    vec4 clip = frame.light * vec4(g.xyz, 1.0);
    // Behind a perspective light is beyond its map, though the division would mirror it in.
    vec2 position = clip.w > 0.0 ? (clip.xy / clip.w * 0.5 + 0.5) * float(frame.size.z) : vec2(-1.0);

    // The plane n.(X - P) = 0 seen from the light. Directional: X moves by texel_x per texel and axis per unit of depth, so
    // depth changes by -(n.texel_x) / (n.axis). Perspective: X = light + w (ray + x texel_x + y texel_y), so 1 / w is linear
    // and changes by (n.texel_x) / (n.(P - light)).
    float value, across;
    if (perspective) {
        value = 1.0 / dot(frame.axis.xyz, g.xyz - frame.light_origin.xyz);
        across = dot(normal, g.xyz - frame.light_origin.xyz);
    } else {
        value = dot(frame.light_depth, vec4(g.xyz, 1.0));
        across = -dot(normal, frame.axis.xyz);
    }
    vec2 slope = vec2(dot(normal, frame.texel_x.xyz), dot(normal, frame.texel_y.xyz)) / across;
    bool facing = dot(frame.rules.x == 1u ? normals[index].xyz : normal, to_light) > 0.0;
    bool flat_test = frame.size.w == 0u || across == 0.0;
    receivers[index] = Receiver(vec4(position, value, facing ? 1.0 : 0.0), vec4(flat_test ? vec2(0.0) : slope, 0.0, 0.0),
                                vec4(g.xyz + frame.range.w * normal, 0.0));
}
