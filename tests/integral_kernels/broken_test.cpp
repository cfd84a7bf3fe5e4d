// One constant changed, and check says so of the kernels that it reaches.
#include "casegen/check.h"
#include "tests/integral_kernels/rows.h"
#include "tests/support/broken_kernels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

struct Break {
    const char *name, *file, *from, *to;
    std::vector<const char*> reached; ///< kernels below integral/ that it makes wrong
};
void PrintTo(const Break& what, std::ostream* out) {
    *out << what.file << ": " << what.from << " -> " << what.to;
}

class broken : public ::testing::TestWithParam<Break> {};

TEST_P(broken, shows_in_what_it_reaches) {
    const testing::ChangedKernels changed(GetParam().file, GetParam().from, GetParam().to);
    std::vector<const Case*> cases;
    for (const char* name : GetParam().reached) cases.push_back(&find_case(fmt::format("integral/{}", name)));
    CheckOptions options;
    options.kernels = changed.folder();
    options.samples = 2000; // and all stiff ones
    options.device = testing::validated();
    options.jobs = 1;
    for (const CheckReport& report : check(cases, options))
        EXPECT_EQ(report.verdict, Verdict::wrong) << report.kernel->name << ": " << report.message;
}

INSTANTIATE_TEST_SUITE_P(
    constants, broken,
    ::testing::Values(
        Break{"a_cube",
              "integral/columns/radiance.glslh",
              "s * s * s / 1.5",
              "s * s * s / 1.501",
              {"mix/radiance", "columns_4/radiance", "columns_16/radiance"}},
        Break{"a_bent_sine",
              "integral/elementary/bent_sine.glsl",
              "z * (0.0595238095",
              "z * (0.0594",
              {"elementary/bent_sine", "mix/radiance"}},
        Break{"a_sign",
              "integral/columns/radiance.glslh",
              "even_cos * (P + Q)",
              "even_cos * (P - Q)",
              {"mix/radiance"}},
        Break{"a_cosine_s_cube",
              "integral/exact_theta/moments.glslh",
              "drop * drop / 6.0",
              "drop * drop / 6.01",
              {"exact_theta/b0", "exact_theta/b", "exact_theta/radiance"}},
        Break{"a_sine_s_square",
              "integral/exact_theta/moments.glslh",
              "to.y * from.y + from.y",
              "0.999 * to.y * from.y + from.y",
              {"exact_theta/b1", "exact_theta/b2", "exact_theta_8/b"}},
        Break{"a_slope",
              "integral/fit/lobe.glslh",
              "z * (0.1 +",
              "z * (0.10002 +",
              {"fit/r1", "fit/beta", "fit/alpha", "mix/radiance"}},
        Break{"a_squared_error", "integral/fit/l2.glsl", "7.61904762e-3", "7.61914762e-3", {"fit/l2"}},
        Break{"the_second_part_of_pi",
              "integral/elementary/sine_ahead.glslh",
              "4.837512969970703125e-4",
              "4.8375e-4",
              {"elementary/sin", "elementary/cos", "elementary/turn"}},
        Break{"the_third_part_of_pi",
              "integral/elementary/sine_ahead.glslh",
              "7.549789948768648e-8",
              "6.549789948768648e-8",
              {"elementary/sin", "elementary/cos", "elementary/turn"}},
        Break{"a_sine_s_series",
              "integral/elementary/sine_ahead.glslh",
              "8.33333333e-3) * z - 0.166666667",
              "8.334e-3) * z - 0.166666667",
              {"elementary/sin", "elementary/cos", "elementary/turn"}},
        Break{"an_exponential",
              "integral/elementary/exp.glsl",
              "2.12194440e-4",
              "2.12094440e-4",
              {"elementary/exp"}},
        Break{"a_mean_of_an_exponential",
              "integral/elementary/exprel.glsl",
              "4.16666667e-2",
              "4.2e-2",
              {"elementary/exprel", "fit/r0", "mix/radiance"}},
        Break{"a_sinc_s_deficit",
              "integral/elementary/sinc_deficit.glsl",
              "1.98412698e-4",
              "1.99e-4",
              {"elementary/sinc_deficit"}},
        Break{"a_third_wave",
              "integral/sinc/c5.glsl",
              "s + 2.0, t + p + q",
              "s + 2.001, t + p + q",
              {"sinc/c5", "sinc/b0", "sinc/b", "sinc/radiance"}},
        Break{"an_arc_s_end",
              "integral/interval/arc.glslh",
              "abs(s) <= peak * ends.y",
              "abs(s) <= 1.05 * peak * ends.y",
              {"interval/exact", "interval/versines"}},
        Break{"an_arc_s_height",
              "integral/interval/arc.glslh",
              "c * ends.x + abs(s) * ends.y",
              "c * ends.x + 1.0001 * abs(s) * ends.y",
              {"interval/exact"}},
        Break{"a_weight_of_4",
              "integral/gauss.glslh",
              "0.347854845",
              "0.347864845",
              {"mix/radiance", "columns_4/radiance", "centred_4/radiance"}},
        Break{"a_weight_of_8",
              "integral/gauss.glslh",
              "0.313706646",
              "0.313716646",
              {"mix/radiance", "columns_8/radiance", "exact_theta_8/b"}},
        Break{"a_weight_of_12",
              "integral/gauss.glslh",
              "0.249147046",
              "0.249157046",
              {"mix/radiance", "columns_12/radiance", "exact_theta/a0"}},
        Break{"a_node_of_16",
              "integral/gauss.glslh",
              "vec2(0.0950125098",
              "vec2(0.0951125098",
              {"columns_16/radiance"}},
        Break{"the_middle_of_an_interval",
              "integral/lit_cell.glslh",
              "0.5 * versines.x + 0.5 * versines.y",
              "0.5 * versines.x + 0.5001 * versines.y",
              {"mix/radiance", "exact_theta/radiance", "centred_8/radiance"}},
        Break{"the_other_pole",
              "integral/trigonometry.glslh",
              "-8.74227766e-8",
              "8.74227766e-8",
              {"cell/from_south"}}),
    [](const auto& instance) { return instance.param.name; });

// --- Kernels that must fail

Case with_reason(const char* name, std::string fails) {
    Case c = find_case(name);
    c.fails = std::move(fails);
    return c;
}
CheckReport check_one(const Case& c) {
    CheckOptions options;
    options.kernels = testing::kernels_folder();
    options.samples = 500;
    options.device = testing::validated();
    return check(std::array{&c}, options).at(0);
}

TEST(expected_failures, are_told_from_passes_and_from_failures) {
    for (const char* name : {"integral/as_printed/b0", "integral/as_printed/c4"}) {
        const CheckReport report = check_one(find_case(name));
        EXPECT_EQ(report.verdict, Verdict::expected) << name;
        EXPECT_TRUE(is_good(report.verdict));
        EXPECT_EQ(check_one(with_reason(name, "")).verdict == Verdict::expected, false) << name;
        EXPECT_FALSE(is_good(check_one(with_reason(name, "")).verdict)) << name;
    }
}

TEST(expected_failures, a_kernel_that_must_fail_and_passes_is_no_good) {
    const CheckReport report =
        check_one(with_reason("integral/elementary/sin", "it is said to divide by zero"));
    EXPECT_EQ(report.verdict, Verdict::passes_wrongly);
    EXPECT_FALSE(is_good(report.verdict));
    EXPECT_NE(report.message.find("it is said to divide by zero"), report.message.npos) << report.message;
    EXPECT_EQ(report.failures, 0u);
    EXPECT_EQ(check_one(with_reason("integral/elementary/sin", "")).verdict, Verdict::pass);
}

} // namespace
} // namespace gnomon
