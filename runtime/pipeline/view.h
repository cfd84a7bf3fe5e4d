// Camera and light, and the frame that they make over a scene.
#pragma once

#include "runtime/gpu/device.h"
#include "runtime/pipeline/frame.h"
#include "runtime/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace gnomon {

struct Camera {
    glm::vec3 position{0};
    glm::vec3 direction{0, 0, -1}; ///< need not be unit
    float fov = 60;                ///< degrees, vertical
    float near = 0.1f, far = 100;  ///< world units along the direction
};

/// Directional unless it has a position.
struct Light {
    glm::vec3 direction{0.5f, -0.7f, 0.3f}; ///< the way light travels; need not be unit
    std::optional<glm::vec3> position{};    ///< of a perspective light, which looks along `direction`
    float fov = 90;                         ///< degrees, of a perspective light, in x and y
};

/// What a directional light's map covers.
enum class LightFit {
    seen_box, ///< across the light the part of the scene's box that the camera can see, along it the box
    camera_frustum, ///< the box, in the light's axes, of the camera frustum's eight corners, and no more
    visible_points, ///< across the light what the camera does see and faces the light; along it the scene's
                    ///< box
};

/// Which normal says whether a surface faces the light.
enum class Facing {
    triangle,       ///< its triangle's, turned towards the camera
    vertex_normals, ///< the interpolated vertex normal, as it is
};

struct ViewSettings {
    int width = 1024, height = 768;
    int shadow_map = 1024;      ///< texels on a side
    float bias = 0;             ///< world units along the light's axis; 0: chosen from the depth range …
    bool choose_bias = true;    ///< … unless this is false: then 0 is 0
    bool receiver_plane = true; ///< else the receiver's depth is taken as constant across texels
    LightFit light_fit = LightFit::seen_box;
    Facing facing = Facing::triangle;
    gpu::Cull cull_primary = gpu::Cull::none, cull_shadow_map = gpu::Cull::none;
    /// Where a shadow ray begins to hit, in world units from the surface itself. 0: chosen from the scene's
    /// diagonal, and the ray starts as far above the surface.
    float ray_begin = 0;
};

/// The conventions under which the thesis on CRSMA counted its pixels, which it mostly leaves unsaid: back
/// faces culled for the camera and front faces for the light, facing by vertex normals, no bias, shadow rays
/// from the surface itself that hit from 0.01 on, a map that covers the camera's frustum (docs/hybrid.md).
ViewSettings as_published(int width, int height, int shadow_map);

/// Throws Error naming the option: a direction that is zero or not finite, near or far out of order, a field
/// of view outside (0, 180), a size or shadow map outside 1 … 16384, a scene seen from inside out (near
/// beyond far).
void require_valid(const Camera& camera, const Light& light, const ViewSettings& settings);

/// A camera that sees the whole box from above a corner, and distances that suit it. `aspect` is the image's
/// width over its height.
Camera default_camera(const Box& box, float aspect);

/// The corners of the camera's frustum: near before far. `aspect` is the image's width over its height.
std::array<glm::vec3, 8> frustum_corners(const Camera& camera, float aspect);

/// What the stages need. What a directional light's map covers says `settings.light_fit`; texels need not be
/// square. A perspective light's reaches from `near` = 1/1000 of the scene's farthest corner to that corner.
/// Throws Error if a perspective light sees nothing of the box.
shared::Frame make_frame(const Camera& camera, const Light& light, const ViewSettings& settings,
                         const Box& box);

/// The frame of a directional light with its map moved: over what was from `lower` to `upper` in texels of
/// the old one, and a hair around.
shared::Frame refitted(const shared::Frame& frame, glm::vec2 lower, glm::vec2 upper);

} // namespace gnomon
