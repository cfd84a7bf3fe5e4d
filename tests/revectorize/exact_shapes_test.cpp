// Every technique against shapes whose light is known exactly: half-planes, wedges, circles, strips.
// docs/revectorization.md 5.2
//
// The edge band is every texel, lit or shadowed, with a neighbour on one of its four sides that differs.
// Errors are means over points in it.
#include "casegen/mask_families.h"
#include "casegen/random.h"
#include "casegen/symmetry.h"
#include "tests/support/techniques.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::ivec2;

constexpr int size = 64, margin = 20; // the map's border changes runs near it
constexpr int grid = 6;               // points per texel and axis

/// Lit where positive: for a line the distance along the steeper axis, else of the sign only.
using Field = std::function<double(dvec2)>;

struct Errors {
    double misclassified = 0; ///< light and dark told apart at one half, in percent of the band
    double bias = 0;          ///< light less true light
    double jump = 0;          ///< where two texels meet, at the middle of their border
    std::size_t borders = 0;
    double squared = 0; ///< against a ramp one texel wide about the edge, where the field is a distance
    std::size_t points = 0;
    double rmse() const { return std::sqrt(squared / static_cast<double>(points)); }
    void finish() {
        misclassified *= 100 / static_cast<double>(points);
        bias /= static_cast<double>(points);
        jump /= static_cast<double>(borders);
    }
};

Mask rasterised(const Field& field) {
    Mask mask(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) mask.set(x, y, field({x + 0.5, y + 0.5}) >= 0);
    return mask;
}

void add_errors(const testing::ReferenceTechnique& technique, const Field& field, Errors& errors) {
    const Mask mask = rasterised(field);
    for (int y = margin; y < size - margin; ++y)
        for (int x = margin; x < size - margin; ++x) {
            if (reference::discontinuity(mask, {x, y}) == glm::uvec2(0)) continue;
            errors.jump += std::abs(technique.visibility(mask, {x, y}, {1, 0.5}) -
                                    technique.visibility(mask, {x + 1, y}, {0, 0.5})) +
                           std::abs(technique.visibility(mask, {x, y}, {0.5, 1}) -
                                    technique.visibility(mask, {x, y + 1}, {0.5, 0}));
            errors.borders += 2;
            for (int i = 0; i < grid * grid; ++i, ++errors.points) {
                const dvec2 p((i % grid + 0.5) / grid, (i / grid + 0.5) / grid);
                const double value = technique.visibility(mask, {x, y}, p);
                const double distance = field(dvec2(x, y) + p);
                errors.misclassified += (value >= 0.5) != (distance >= 0) ? 1 : 0;
                errors.bias += value - (distance >= 0 ? 1 : 0);
                const double ramp = std::clamp(0.5 + distance, 0.0, 1.0);
                errors.squared += (value - ramp) * (value - ramp);
            }
        }
}

/// The field seen in one of the eight orientations of the square about the map's centre.
Field oriented(Field field, unsigned orientation) {
    return [field, orientation](dvec2 point) {
        dvec2 q = point - 0.5 * size;
        if ((orientation & 1u) != 0) std::swap(q.x, q.y);
        if ((orientation & 2u) != 0) q.x = -q.x;
        if ((orientation & 4u) != 0) q.y = -q.y;
        return field(q);
    };
}

const std::array slopes{1 / 32.0, 1 / 16.0, 0.1,     1 / 8.0, 1 / 6.0, 0.2,  0.25, 0.3,
                        1 / 3.0,  0.4,      1 / 2.0, 0.6,     2 / 3.0, 0.75, 0.9,  1.0};
const std::array techniques{testing::hard_test, testing::smsr, testing::rbsm_silhouette, testing::rsmss,
                            testing::rbsm_filter};

Errors half_planes(const testing::ReferenceTechnique& technique, double slope) {
    Errors errors;
    Random random(91);
    for (unsigned orientation = 0; orientation < 8; ++orientation)
        for (int n = 0; n < 3; ++n) {
            const double offset = (n + random.unit()) / 3;
            add_errors(technique, oriented([=](dvec2 q) { return q.y - slope * q.x - offset; }, orientation),
                       errors);
        }
    errors.finish();
    return errors;
}

TEST(exact_shapes, half_planes_of_all_slopes) {
    std::array<Errors, techniques.size()> mean{};
    fmt::print("slope  ");
    for (const auto& technique : techniques) fmt::print("{:>30}", technique.name);
    fmt::print("\n       ");
    for (std::size_t i = 0; i < techniques.size(); ++i)
        fmt::print("{:>9}{:>7}{:>7}{:>7}", "wrong %", "bias", "rmse", "jump");
    fmt::print("\n");
    for (const double slope : slopes) {
        fmt::print("{:.4f} ", slope);
        for (std::size_t i = 0; i < techniques.size(); ++i) {
            const Errors errors = half_planes(techniques[i], slope);
            fmt::print("{:>9.2f}{:>7.3f}{:>7.3f}{:>7.4f}", errors.misclassified, errors.bias, errors.rmse(),
                       errors.jump);
            mean[i].misclassified += errors.misclassified / slopes.size();
            mean[i].bias += errors.bias / slopes.size();
            mean[i].squared += errors.rmse() * errors.rmse() / slopes.size();
            mean[i].jump += errors.jump / slopes.size();
            if (slope >= 1 / 16.0 && i > 0)
                EXPECT_LT(errors.jump, 1e-9) << techniques[i].name << " at " << slope;
        }
        fmt::print("\n");
    }
    fmt::print("mean   ");
    for (const Errors& m : mean)
        fmt::print("{:>9.2f}{:>7.3f}{:>7.3f}{:>7.4f}", m.misclassified, m.bias, std::sqrt(m.squared), m.jump);
    fmt::print("\n");
    const auto& [hard, smsr, silhouette, rsmss, filter] = mean;
    EXPECT_NEAR(hard.misclassified, 13.1, 0.8);
    EXPECT_NEAR(smsr.misclassified, 22.5, 1.5);
    EXPECT_NEAR(smsr.bias, -0.23, 0.03) << "half a texel of a band of two";
    EXPECT_LT(rsmss.misclassified, 6.5);
    EXPECT_NEAR(rsmss.bias, 0, 0.01);
    EXPECT_NEAR(std::sqrt(rsmss.squared), 0.094, 0.001);
    EXPECT_LT(rsmss.jump, 0.01) << "of the slope whose runs outgrow the walks";
    EXPECT_GT(hard.jump, 0.1);
    EXPECT_NEAR(filter.misclassified, rsmss.misclassified, 0.1) << "the same on half-planes";
    EXPECT_NEAR(silhouette.misclassified, smsr.misclassified, 0.1);
}

/// Share of points, in percent, at which the five shapes differ from the 31 cases.
double different(double slope) {
    std::size_t points = 0, differ = 0;
    Random random(93);
    for (unsigned orientation = 0; orientation < 8; ++orientation) {
        const double offset = random.unit();
        const Mask mask =
            rasterised(oriented([=](dvec2 q) { return q.y - slope * q.x - offset; }, orientation));
        for (int y = margin; y < size - margin; ++y)
            for (int x = margin; x < size - margin; ++x) {
                if (reference::discontinuity(mask, {x, y}) == glm::uvec2(0)) continue;
                for (int i = 0; i < grid * grid; ++i, ++points) {
                    const dvec2 p((i % grid + 0.5) / grid, (i / grid + 0.5) / grid);
                    const double cases = testing::rsmss.visibility(mask, {x, y}, p);
                    differ += std::abs(cases - testing::rbsm_filter.visibility(mask, {x, y}, p)) > 1 / 255.0
                                  ? 1
                                  : 0;
                }
            }
    }
    return 100.0 * static_cast<double>(differ) / static_cast<double>(points);
}

TEST(exact_shapes, five_shapes_are_the_cases_on_half_planes) {
    for (const double slope : slopes) EXPECT_EQ(different(slope), 0) << slope;
}

TEST(exact_shapes, wedges_circles_and_strips) {
    const std::vector<std::pair<const char*, std::function<Field(Random&)>>> shapes{
        {"circle",
         [](Random& random) -> Field {
             const double radius = 4 + 7 * random.unit(), x = random.unit(), y = random.unit();
             return [=](dvec2 q) { return std::hypot(q.x - x, q.y - y) - radius; };
         }},
        {"wedge",
         [](Random& random) -> Field {
             const double a = random.unit(), b = random.unit(), x = random.unit(), y = random.unit();
             return [=](dvec2 q) { return std::max(q.y - y - a * (q.x - x), q.x - x + b * (q.y - y)); };
         }},
        {"strip",
         [](Random& random) -> Field {
             const double slope = random.unit(), width = 1 + 2 * random.unit(), offset = random.unit();
             return [=](dvec2 q) { return std::abs(q.y - slope * q.x - offset) - 0.5 * width; };
         }},
    };
    fmt::print("{:<8}", "");
    for (const auto& technique : techniques) fmt::print("{:>30}", technique.name);
    fmt::print("\n");
    // Of hard test, smsr, rbsm-silhouette, rsmss, rbsm-filter: wrong in percent, bias, jump.
    const std::map<std::string, std::array<std::array<double, 3>, techniques.size()>> pinned{
        {"circle",
         {{{13.22, -0.008, 0.3552},
           {17.28, -0.150, 0.1141},
           {17.15, -0.148, 0.1141},
           {12.14, 0.098, 0.0000},
           {12.17, 0.099, 0.0018}}}},
        {"wedge",
         {{{13.55, 0.001, 0.3716},
           {21.66, -0.210, 0.0343},
           {21.62, -0.210, 0.0343},
           {6.75, 0.028, 0.0027},
           {6.98, 0.030, 0.0067}}}},
        {"strip",
         {{{14.55, 0.001, 0.3995},
           {24.74, -0.244, 0.0138},
           {24.60, -0.243, 0.0138},
           {8.61, 0.022, 0.0648},
           {11.28, 0.058, 0.0859}}}},
    };
    for (const auto& [name, make] : shapes) {
        fmt::print("{:<8}", name);
        std::array<Errors, techniques.size()> of{};
        for (std::size_t i = 0; i < techniques.size(); ++i) {
            Random random(92);
            for (unsigned n = 0; n < 24; ++n) add_errors(techniques[i], oriented(make(random), n % 8), of[i]);
            of[i].finish();
            const auto& [wrong, bias, jump] = pinned.at(name)[i];
            EXPECT_NEAR(of[i].misclassified, wrong, 0.006) << name << ' ' << techniques[i].name;
            EXPECT_NEAR(of[i].bias, bias, 0.0006) << name << ' ' << techniques[i].name;
            EXPECT_NEAR(of[i].jump, jump, 0.00006) << name << ' ' << techniques[i].name;
            fmt::print("{:>14.2f}{:>8.3f}{:>8.4f}", of[i].misclassified, of[i].bias, of[i].jump);
        }
        fmt::print("\n");
        const auto& [hard, smsr, silhouette, rsmss, filter] = of;
        EXPECT_LT(rsmss.misclassified, hard.misclassified) << name << ": filtering places the edge better";
        EXPECT_GT(smsr.misclassified, hard.misclassified) << name << ": half a texel of shadow is added";
        EXPECT_LT(smsr.bias, -0.1) << name;
        EXPECT_LT(rsmss.jump, 0.25 * hard.jump) << name;
        // A disc's flat caps are teeth: their ramp takes half a texel of shadow, and nothing gives it back.
        EXPECT_NEAR(rsmss.bias, std::string(name) == "circle" ? 0.1 : 0.025, 0.02) << name;
    }
}

} // namespace
} // namespace gnomon
