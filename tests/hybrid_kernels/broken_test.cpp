// One thing changed, and check says so of the kernels that it reaches.
#include "casegen/check.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/device.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

struct Break {
    const char *name, *file, *from, *to;
    std::vector<const char*> reached;
};
void PrintTo(const Break& what, std::ostream* out) {
    *out << what.file << ": " << what.from << " -> " << what.to;
}

class broken_hybrid : public ::testing::TestWithParam<Break> {};

TEST_P(broken_hybrid, shows_in_what_it_reaches) {
    const testing::ChangedKernels changed(GetParam().file, GetParam().from, GetParam().to);
    std::vector<const Case*> cases;
    for (const char* name : GetParam().reached) cases.push_back(&find_case(name));
    CheckOptions options;
    options.kernels = changed.folder();
    options.samples = 4000;
    options.device = testing::validated();
    options.jobs = 1;
    for (const CheckReport& report : check(cases, options))
        EXPECT_EQ(report.verdict, Verdict::wrong) << report.kernel->name << ": " << report.message;
}

INSTANTIATE_TEST_SUITE_P(
    changes, broken_hybrid,
    ::testing::Values(Break{"the_printed_perpendicular",
                            "conservative/inward.glsl",
                            "vec2(-along.y, along.x)",
                            "vec2(-along.x, along.y)",
                            {"conservative/inward"}},
                      Break{"a_normal_that_looks_out",
                            "conservative/inward.glsl",
                            "(inside - a)) < 0.0",
                            "(inside - a)) > 0.0",
                            {"conservative/inward"}},
                      Break{"lines_that_divide_by_nothing",
                            "conservative/line_intersection.glsl",
                            "if (!(abs(area) > conservative_parallel * lengths)) return bounded(otherwise);",
                            "",
                            {"conservative/line_intersection"}},
                      Break{"an_obtuse_corner_by_bisector",
                            "conservative/lines.glslh",
                            "if (conservative_dot(u, w) < 0.0)",
                            "if (false)",
                            {"conservative/dilated", "conservative/eroded"}},
                      Break{"an_acute_corner_by_normals",
                            "conservative/lines.glslh",
                            "if (conservative_dot(u, w) < 0.0)",
                            "if (true)",
                            {"conservative/dilated", "conservative/eroded"}},
                      Break{"grown_for_shrunken",
                            "conservative/dilated.glsl",
                            "a, b, c, -lambda, corner",
                            "a, b, c, lambda, corner",
                            {"conservative/dilated"}},
                      Break{"a_box_that_does_not_grow",
                            "conservative/clip_box.glsl",
                            "max(a, max(b, c)) + lambda",
                            "max(a, max(b, c))",
                            {"conservative/clip_box"}},
                      Break{"a_box_without_its_border",
                            "conservative/in_clip_box.glsl",
                            "p.x <= box.z",
                            "p.x < box.z",
                            {"conservative/in_clip_box"}},
                      Break{"one_edge_that_may_turn_round",
                            "conservative/eroded_edges.glslh",
                            "conservative_dot(edges.before[0], edges.after[0]) > 0.0",
                            "conservative_dot(edges.before[0], edges.after[0]) < 0.0",
                            {"conservative/erodes", "conservative/erodes_as_published"}},
                      Break{"edges_shorter_than_lambda",
                            "conservative/erodes_as_published.glsl",
                            "2.0 * edges.lambda",
                            "1.0 * edges.lambda",
                            {"conservative/erodes_as_published"}},
                      Break{"the_whole_texel",
                            "conservative/tight_offset.glsl",
                            "0.5 * abs(normal.x)",
                            "abs(normal.x)",
                            {"conservative/tight_offset"}},
                      Break{"a_slope_s_sign",
                            "conservative/plane.glslh",
                            "(other.z - on_edge) / height",
                            "(on_edge - other.z) / height",
                            {"conservative/depth_at", "conservative/depth_bounds"}},
                      Break{"a_slope_where_there_is_none",
                            "conservative/plane.glslh",
                            "conservative_is_sliver(a.xy, b.xy, c.xy)",
                            "false",
                            {"conservative/depth_at", "conservative/depth_bounds"}},
                      Break{"depth_at_the_centre_only",
                            "conservative/depth_bounds.glsl",
                            "(rise + rounding)",
                            "rounding",
                            {"conservative/depth_bounds"}},
                      Break{"depth_beyond_the_corners",
                            "conservative/depth_bounds.glsl",
                            "clamp(bounds, range.x, range.y)",
                            "bounds",
                            {"conservative/depth_bounds"}},
                      Break{"a_missing_neighbour_that_faces_away",
                            "adjacency/away.glsl",
                            "if (conservative_is_sliver(a, b, c)) return 0;",
                            "",
                            {"adjacency/away"}},
                      Break{"the_wrong_neighbour",
                            "adjacency/away.glsl",
                            "adjacency_winding(v4, v5, v0)",
                            "adjacency_winding(v4, v3, v0)",
                            {"adjacency/away"}},
                      Break{"edges_exchanged",
                            "adjacency/polygon.glslh",
                            "int i = ((slot + 1) / 2) % 3, before = (i + 2) % 3;",
                            "int i = ((slot + 1) / 2) % 3, before = (i + 1) % 3;",
                            {"adjacency/shadowed_1", "adjacency/shadowed_2", "adjacency/shrunken"}},
                      Break{"a_cut_along_the_other_edge",
                            "adjacency/polygon.glslh",
                            "by_next = slot % 2 == 1 ? polygon.lambda : 0.0;",
                            "by_next = slot % 2 == 1 ? 0.5 * polygon.lambda : 0.0;",
                            {"adjacency/shadowed_2", "adjacency/shadowed_3", "adjacency/one_ring"}},
                      Break{"a_fan_s_last_triangle_forgotten",
                            "adjacency/polygon.glslh",
                            "triangle >= polygon.size - 2",
                            "triangle >= polygon.size - 3",
                            {"adjacency/shadowed_0", "adjacency/shadowed_2", "adjacency/shadowed_3"}},
                      Break{"a_corner_between_the_wrong_edges",
                            "adjacency/polygon.glslh",
                            "(away & 3u) == 3u ? 2u",
                            "(away & 6u) == 6u ? 2u",
                            {"adjacency/shadowed_2", "adjacency/shrunken", "adjacency/one_ring"}},
                      Break{"inner_corners_cut",
                            "adjacency/one_ring.glsl",
                            "adjacency_between(away) & ~inner",
                            "adjacency_between(away)",
                            {"adjacency/one_ring"}},
                      Break{"three_that_agree",
                            "certainty/beister.glsl",
                            "votes == 4 ? 1u",
                            "votes >= 3 ? 1u",
                            {"certainty/beister"}},
                      Break{"the_footprint_s_other_side",
                            "certainty/bilinear.glsl",
                            "p.x < 0.5, p.y < 0.5",
                            "p.x < 0.5, p.y > 0.5",
                            {"certainty/bilinear"}},
                      Break{"light_without_its_centre",
                            "certainty/crsm.glsl",
                            "big_centre != 0u && ",
                            "",
                            {"certainty/crsm"}}),
    [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace gnomon
