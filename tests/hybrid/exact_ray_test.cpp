// The truth of the soups, on triangles whose answer is plain.
#include "casegen/hybrid/exact_ray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gnomon::hybrid {
namespace {

constexpr std::array<glm::vec3, 3> flat{glm::vec3(-1, 2, -1), glm::vec3(2, 2, -1), glm::vec3(-1, 2, 2)};

bool up_from(glm::vec3 origin, float tmin = 0.1f, std::array<glm::vec3, 3> triangle = flat) {
    return meets(Ray{origin, {0, 1, 0}, tmin}, std::span<const glm::vec3, 3>(triangle));
}

TEST(exact_ray, meets_both_faces) {
    EXPECT_TRUE(up_from({0, 0, 0}));
    EXPECT_TRUE(up_from({0, 0, 0}, 0.1f, {flat[0], flat[2], flat[1]}));
    EXPECT_FALSE(up_from({0, 3, 0}));
}

TEST(exact_ray, ends_at_its_edges_to_the_last_bit) {
    EXPECT_TRUE(up_from({-1, 0, 0})); // the border belongs to the triangle
    EXPECT_FALSE(up_from({std::nextafter(-1.0f, -2.0f), 0, 0}));
    EXPECT_TRUE(up_from({0.5f, 0, 0.5f})); // on the long side, x + z = 1
    EXPECT_FALSE(up_from({0.5f, 0, std::nextafter(0.5f, 1.0f)}));
}

TEST(exact_ray, begins_behind_tmin_to_the_last_bit) {
    EXPECT_FALSE(up_from({0, 0, 0}, 2.0f));
    EXPECT_TRUE(up_from({0, 0, 0}, std::nextafter(2.0f, 0.0f)));
}

TEST(exact_ray, does_not_meet_what_it_lies_in) {
    EXPECT_FALSE(up_from({0, 0, 0}, 0.1f, {glm::vec3(-1, 1, 0), glm::vec3(1, 1, 0), glm::vec3(0, 2, 0)}));
}

} // namespace
} // namespace gnomon::hybrid
