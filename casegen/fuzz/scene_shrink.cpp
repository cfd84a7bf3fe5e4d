#include "casegen/fuzz/scene_shrink.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace gnomon::fuzz {
namespace {

float rounded(float value, int digits) {
    return std::bit_cast<float>(with_digits(std::bit_cast<std::uint32_t>(value), digits, true));
}

class Shrinker {
public:
    Shrinker(SceneInput scene, const StillFails& still_fails, std::size_t most)
        : scene_(std::move(scene)), still_fails_(still_fails), left_(most) {}

    SceneInput run() {
        for (bool better = true; better && left_ > 0;) {
            better = fewer_triangles();
            better = smaller_images() || better;
            better = rounder_numbers() || better;
        }
        return scene_;
    }

private:
    /// Takes the candidate if it is another scene and fails.
    bool take(SceneInput candidate) {
        if (left_ == 0) return false;
        const Input words = words_of(candidate);
        if (words.words == words_of(scene_).words) return false;
        --left_;
        if (!still_fails_(std::span(&words, 1)).front()) return false;
        scene_ = std::move(candidate);
        return true;
    }

    bool fewer_triangles() {
        bool better = false;
        for (std::size_t part = scene_.scene.triangles.size() / 2; part > 0; part /= 2)
            for (std::size_t begin = 0; begin < scene_.scene.triangles.size();) {
                const std::size_t end = std::min(begin + part, scene_.scene.triangles.size());
                if (end - begin < scene_.scene.triangles.size() &&
                    take(without_triangles(scene_, begin, end)))
                    better = true;
                else
                    begin = end;
            }
        return better;
    }

    bool smaller_images() {
        bool better = false;
        for (int ViewSettings::*side :
             {&ViewSettings::width, &ViewSettings::height, &ViewSettings::shadow_map})
            for (const int texels : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64}) {
                if (texels >= scene_.settings.*side) break;
                SceneInput candidate = scene_;
                candidate.settings.*side = texels;
                if (take(std::move(candidate))) {
                    better = true;
                    break;
                }
            }
        return better;
    }

    /// Every number of a scene that rounding may make simpler.
    static std::vector<float*> numbers(SceneInput& s) {
        std::vector<float*> all;
        for (glm::vec3& position : s.scene.positions)
            for (int axis = 0; axis < 3; ++axis) all.push_back(&position[axis]);
        for (glm::vec3* v : {&s.light.direction, &s.camera.direction, &s.camera.position})
            for (int axis = 0; axis < 3; ++axis) all.push_back(&(*v)[axis]);
        return all;
    }

    bool rounder_numbers() {
        bool better = false;
        for (int digits = 1; digits < 12; ++digits) { // all at once
            SceneInput candidate = scene_;
            for (float* number : numbers(candidate)) *number = rounded(*number, digits);
            if (take(std::move(candidate))) {
                better = true;
                break;
            }
        }
        const std::size_t count = numbers(scene_).size();
        for (std::size_t i = 0; i < count && left_ > 0; ++i) {
            const float value = *numbers(scene_)[i];
            for (const float simpler : {0.0f, std::round(value), rounded(value, 0), rounded(value, 2),
                                        rounded(value, 4), rounded(value, 8)}) {
                if (simpler == value) break; // the others are no simpler
                SceneInput candidate = scene_;
                *numbers(candidate)[i] = simpler;
                if (take(std::move(candidate))) {
                    better = true;
                    break;
                }
            }
        }
        return better;
    }

    SceneInput scene_;
    const StillFails& still_fails_;
    std::size_t left_;
};

} // namespace

SceneInput without_triangles(const SceneInput& scene, std::size_t begin, std::size_t end) {
    SceneInput result = scene;
    Scene& made = result.scene;
    made.positions.clear();
    made.normals.clear();
    made.triangles.clear();
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> moved(scene.scene.positions.size(), none);
    for (std::size_t t = 0; t < scene.scene.triangles.size(); ++t) {
        if (t >= begin && t < end) continue;
        glm::uvec3 triangle = scene.scene.triangles[t];
        for (int corner = 0; corner < 3; ++corner) {
            std::uint32_t& to = moved[triangle[corner]];
            if (to == none) {
                to = static_cast<std::uint32_t>(made.positions.size());
                made.positions.push_back(scene.scene.positions[triangle[corner]]);
                made.normals.emplace_back(0, 1, 0);
            }
            triangle[corner] = to;
        }
        made.triangles.push_back(triangle);
    }
    return result;
}

SceneInput shrink_scene(SceneInput scene, const StillFails& still_fails, std::size_t most) {
    return Shrinker(std::move(scene), still_fails, most).run();
}

} // namespace gnomon::fuzz
