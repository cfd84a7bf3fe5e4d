// Kernels that are wrong on purpose: the harness must say so, and say what is wrong.
#include "casegen/check.h"

#include "casegen/standalone.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon {
namespace {

using testing::BrokenKernels;
using ::testing::HasSubstr;
using ::testing::StartsWith;

CheckReport check_in(const std::filesystem::path& kernels, const std::string& kernel) {
    CheckOptions options;
    options.kernels = kernels;
    options.samples = 4000;
    options.device = testing::validated();
    options.jobs = 1;
    return check(std::array{&find_case(kernel)}, options).at(0);
}

CheckReport check_broken(const std::string& name, const std::string& kernel) {
    return check_in(BrokenKernels(name).folder(), kernel);
}

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

TEST(kernels_that_fail, a_copy_of_the_right_ones_passes) {
    const testing::TemporaryFolder folder;
    std::filesystem::copy(testing::kernels_folder(), folder.path(), std::filesystem::copy_options::recursive);
    EXPECT_EQ(check_in(folder.path(), "smsr/case_09").verdict, Verdict::pass);
}

TEST(kernels_that_fail, wrong_constant) {
    const CheckReport report = check_broken("wrong_constant", "smsr/case_02");
    EXPECT_EQ(report.verdict, Verdict::wrong);
    ASSERT_TRUE(report.worst);
    EXPECT_EQ(report.worst->got, std::vector{bits(1.0f)});
    EXPECT_EQ(report.worst->want[0], 0);
    EXPECT_EQ(report.worst->error, 1);
    EXPECT_TRUE(report.worst->in_domain);
    EXPECT_GT(report.failures, report.samples / 2); // the rest lies outside the domain
    EXPECT_LT(report.failures, report.samples);
}

TEST(kernels_that_fail, flipped_comparison) {
    const CheckReport report = check_broken("flipped_comparison", "smsr/case_09");
    EXPECT_EQ(report.verdict, Verdict::wrong);
    EXPECT_GT(report.failures, 1000u);
}

TEST(kernels_that_fail, flipped_comparison_shows_in_the_assembly_too) {
    const CheckReport report = check_broken("flipped_comparison", "smsr/visibility");
    EXPECT_EQ(report.verdict, Verdict::wrong);
    ASSERT_TRUE(report.worst && report.worst->mask);
}

TEST(kernels_that_fail, off_by_one_on_a_mask) {
    const BrokenKernels broken("off_by_one");
    for (const char* kernel : {"revectorize/walk", "revectorize/traversal"}) {
        const CheckReport report = check_in(broken.folder(), kernel);
        EXPECT_EQ(report.verdict, Verdict::wrong) << kernel;
        ASSERT_TRUE(report.worst && report.worst->mask) << kernel;
        EXPECT_EQ(report.worst->error, 1) << kernel;
    }
    EXPECT_EQ(check_in(broken.folder(), "revectorize/discontinuity").verdict, Verdict::pass);
}

TEST(kernels_that_fail, slightly_off) {
    const CheckReport report = check_broken("slightly_off", "revectorize/along");
    EXPECT_EQ(report.verdict, Verdict::wrong);
    ASSERT_TRUE(report.worst);
    EXPECT_NEAR(report.worst->error, 1e-3, 1e-5);
}

TEST(kernels_that_fail, nan_result) {
    const CheckReport report = check_broken("nan", "smsr/case_03");
    EXPECT_EQ(report.verdict, Verdict::wrong);
    ASSERT_TRUE(report.worst);
    EXPECT_EQ(report.worst->error, HUGE_VAL);
    EXPECT_EQ(format_result(*report.kernel, report.worst->got), "nan");
}

TEST(kernels_that_fail, nan_result_of_a_hostile_input) {
    const CheckReport report = check_broken("nan_from_hostile_input", "smsr/case_02");
    EXPECT_EQ(report.verdict, Verdict::wrong);
    ASSERT_TRUE(report.worst);
    EXPECT_FALSE(report.worst->in_domain);
    EXPECT_TRUE(std::isnan(std::bit_cast<float>(report.worst->input[0])));
}

TEST(kernels_that_fail, result_out_of_range_outside_the_domain) {
    const CheckReport report = check_broken("out_of_range", "smsr/case_01");
    EXPECT_EQ(report.verdict, Verdict::wrong);
    ASSERT_TRUE(report.worst);
    EXPECT_FALSE(report.worst->in_domain);
    EXPECT_EQ(report.worst->got, std::vector{bits(2.0f)});
    EXPECT_LT(report.failures, report.samples / 2);
}

TEST(kernels_that_fail, output_never_written) {
    const CheckReport report = check_broken("never_written", "smsr/case_01");
    EXPECT_EQ(report.verdict, Verdict::unwritten);
    EXPECT_THAT(report.message, HasSubstr("1 of "));
    ASSERT_TRUE(report.worst);
    EXPECT_EQ(report.worst->index, 100u);
    EXPECT_EQ(format_result(*report.kernel, report.worst->got), "nothing");
}

TEST(kernels_that_fail, writes_out_of_bounds) {
    for (const char* name : {"write_behind", "write_before"}) {
        const CheckReport report = check_broken(name, "smsr/case_01");
        EXPECT_EQ(report.verdict, Verdict::stray_write) << name;
        EXPECT_THAT(report.message, HasSubstr("overwritten")) << name;
    }
}

TEST(kernels_that_fail, a_write_outside_the_buffer_harms_nothing) {
    EXPECT_EQ(check_broken("write_far_away", "smsr/case_01").verdict, Verdict::pass);
}

TEST(kernels_that_fail, unstable_result) {
    const CheckReport report = check_broken("unstable", "smsr/case_01");
    EXPECT_EQ(report.verdict, Verdict::unstable);
    EXPECT_FALSE(report.message.empty());
}

TEST(kernels_that_fail, a_loop_that_the_driver_cuts_off_is_no_pass) {
    EXPECT_NE(check_broken("endless_but_cut_off", "smsr/case_01").verdict, Verdict::pass);
}

std::string compile_error(const std::string& name, const std::string& kernel = "smsr/case_09") {
    const CheckReport report = check_broken(name, kernel);
    EXPECT_EQ(report.verdict, Verdict::compile_error) << name;
    EXPECT_FALSE(report.worst) << name;
    return report.message;
}

TEST(kernels_that_fail, compile_errors_are_on_the_author_s_line) {
    EXPECT_THAT(compile_error("syntax_error"), StartsWith("kernels/smsr/case_09.glsl:5: ")); // met there
    EXPECT_THAT(compile_error("error_in_include", "smsr/case_04"),
                AllOf(StartsWith("kernels/revectorize/sides.glslh:4: "), HasSubstr("MINUS_BIT")));
    EXPECT_THAT(compile_error("error_after_include", "smsr/case_04"),
                AllOf(StartsWith("kernels/smsr/case_04.glsl:7: "), HasSubstr("smsr_case_13")));
    EXPECT_THAT(compile_error("missing_include"),
                AllOf(StartsWith("kernels/smsr/case_09.glsl:3: "), HasSubstr("smsr/nowhere.glsl")));
}

TEST(kernels_that_fail, a_wrong_signature_is_told_with_the_declared_one) {
    for (const char* name : {"wrong_signature", "wrong_name"})
        EXPECT_THAT(compile_error(name), AllOf(StartsWith("kernels/smsr/case_09.glsl:1: "),
                                               HasSubstr("float smsr_case_09(vec2 p, float along_x)")));
}

TEST(kernels_that_fail, invalid_spirv_is_told_as_such_and_by_names) {
    EXPECT_THAT(compile_error("invalid_spirv"),
                AllOf(StartsWith("kernels/smsr/case_09.glsl:1: glslang made invalid SPIR-V"),
                      HasSubstr("OpFAdd %float")));
}

TEST(kernels_that_fail, a_main_of_its_own_is_refused) {
    EXPECT_THAT(compile_error("own_main"), StartsWith("kernels/smsr/case_09.glsl:"));
}

TEST(kernels_that_fail, missing_file) {
    const BrokenKernels broken("wrong_constant");
    std::filesystem::remove(broken.folder() / "smsr/case_09.glsl");
    const CheckReport report = check_in(broken.folder(), "smsr/case_09");
    EXPECT_EQ(report.verdict, Verdict::compile_error);
    EXPECT_THAT(report.message, AllOf(HasSubstr("smsr/case_09.glsl"), HasSubstr("no such file")));
}

TEST(kernels_that_fail, one_does_not_stop_the_others) {
    const BrokenKernels broken("syntax_error");
    CheckOptions options;
    options.kernels = broken.folder();
    options.samples = 500;
    options.device = testing::validated();
    for (const CheckReport& report : check(find_cases("smsr/case_*"), options)) {
        const std::string& name = report.kernel->name;
        const bool includes_it = name == "smsr/case_09" || name == "smsr/case_05" || name == "smsr/case_08";
        EXPECT_EQ(report.verdict, includes_it ? Verdict::compile_error : Verdict::pass) << name;
    }
}

// The same detections without check() around them, on a main() written by hand.
class run_standalone_detects : public ::testing::Test {
protected:
    Outputs run(const std::string& statements) {
        const Case& c = find_case("smsr/case_01");
        Records records(c);
        for (std::size_t i = 0; i < 200; ++i) records.add(std::array{bits(0.5f), bits(0.25f)}, nullptr);
        // Offset of the results: behind as many guard words as the generated main() leaves.
        const std::string source = standalone_source(c);
        const std::string guard = source.substr(source.rfind("results[") + 8);
        const std::string text = "layout(local_size_x = 64) in;\n"
                                 "layout(std430, binding = 0) readonly buffer Inputs { uvec4 inputs[]; };\n"
                                 "layout(std430, binding = 1) buffer Results { uint results[]; };\n"
                                 "layout(push_constant) uniform Constants { uint count; };\n"
                                 "void main() {\n"
                                 "    uint i = gl_GlobalInvocationID.x;\n"
                                 "    if (i >= count) return;\n"
                                 "    uint ignored = inputs[i].x;\n"
                                 "    uint at = " +
                                 guard.substr(0, guard.find(' ')) + " + i;\n" + statements + "}\n";
        const glsl::Sources sources = kernel_sources(testing::kernels_folder());
        gpu::Kernel kernel = testing::shared_device().kernel(
            glsl::compile(sources, text, "by hand", glsl::Stage::compute), "by hand");
        return run_standalone(testing::shared_device(), kernel, c, records);
    }
};

TEST_F(run_standalone_detects, nothing_wrong) {
    const Outputs outputs = run("results[at] = ignored;\n");
    EXPECT_EQ(outputs.words, std::vector<std::uint32_t>(200, bits(0.5f)));
    EXPECT_EQ(std::ranges::count(outputs.unwritten, 1), 0);
    EXPECT_FALSE(outputs.stray_write);
    EXPECT_FALSE(outputs.unstable);
}

TEST_F(run_standalone_detects, results_that_are_not_written) {
    const Outputs outputs = run("if (i % 3u != 0u) results[at] = 0u;\n");
    for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(outputs.unwritten[i], i % 3 == 0 ? 1 : 0) << i;
    EXPECT_FALSE(outputs.stray_write);
    EXPECT_EQ(std::ranges::count(run("").unwritten, 1), 200);
}

TEST_F(run_standalone_detects, a_single_word_beside_the_results) {
    EXPECT_TRUE(run("results[at] = 0u; if (i == 0u) results[at - 1u] = 7u;\n").stray_write);
    EXPECT_TRUE(run("results[at] = 0u; if (i == count - 1u) results[at + 1u] = 7u;\n").stray_write);
    EXPECT_TRUE(run("results[at] = 0u; results[0] = 7u;\n").stray_write);
    EXPECT_TRUE(run("results[at] = 0u; results[results.length() - 1] = 7u;\n").stray_write);
}

TEST_F(run_standalone_detects, results_that_depend_on_what_was_there) {
    const Outputs outputs = run("results[at] = i == 3u ? results[at] >> 8 : 0u;\n");
    EXPECT_TRUE(outputs.unstable);
    EXPECT_FALSE(outputs.stray_write);
}

} // namespace
} // namespace gnomon
