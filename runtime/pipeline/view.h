// Camera and light, and the frame that they make over a scene.
#pragma once

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

struct ViewSettings {
    int width = 1024, height = 768;
    int shadow_map = 1024;      ///< texels on a side
    float bias = 0;             ///< world units along the light's axis; 0: chosen from the depth range
    bool receiver_plane = true; ///< else the receiver's depth is taken as constant across texels
};

/// Throws Error naming the option: a direction that is zero or not finite, near or far out of order, a field
/// of view outside (0, 180), a size or shadow map outside 1 … 16384, a scene seen from inside out (near
/// beyond far).
void require_valid(const Camera& camera, const Light& light, const ViewSettings& settings);

/// A camera that sees the whole box from above a corner, and distances that suit it. `aspect` is the image's
/// width over its height.
Camera default_camera(const Box& box, float aspect);

/// What the stages need. A directional light's map covers, across the light, the part of the scene's box that
/// the camera's frustum can see, and along it the whole box: everything that casts. A perspective light's
/// reaches from `near` = 1/1000 of the farthest corner to that corner. Throws Error if a perspective light
/// sees nothing of the box.
shared::Frame make_frame(const Camera& camera, const Light& light, const ViewSettings& settings,
                         const Box& box);

} // namespace gnomon
