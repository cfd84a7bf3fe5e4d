#include "tests/pipeline/cli.h"

#include "runtime/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::expect_refused;
using ::testing::HasSubstr;
using testing::operator+;
using testing::run_well;
using testing::TemporaryFolder;

TEST(eval, adds_result_and_reference_behind_the_input_s_columns) {
    const TemporaryFolder folder;
    const auto in = folder.write("in.csv", "note,along_x,p_y,p_x\n"
                                           "lit,0.25,0.5,0.75\n"
                                           "dark,0.75,0x1p-1,0.75\n"
                                           "outside,2,0.5,0.75\n"
                                           "hostile,nan,-inf,1e-45\n");
    const auto out = folder.path() / "out.csv";
    EXPECT_EQ(
        run_well({"eval", "smsr/case_09", "--in", in.string(), "--out", out.string(), "--reference"}).out,
        "");
    EXPECT_EQ(read_file(out), "note,along_x,p_y,p_x,result,reference\n"
                              "lit,0.25,0.5,0.75,0x1p+0,0x1p+0\n"
                              "dark,0.75,0x1p-1,0.75,0x0p+0,0x0p+0\n"
                              "outside,2,0.5,0.75,0x0p+0,undefined\n"
                              "hostile,nan,-inf,1e-45,0x1p+0,undefined\n");
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(eval, prints_without_out) {
    EXPECT_EQ(run_well({"eval", "smsr/case_09", "--at", "0.75,0.5,0.25"}).out,
              "p_x,p_y,along_x,result\n0.75,0.5,0.25,0x1p+0\n");
}

TEST(eval, takes_an_input_that_begins_with_a_minus) {
    EXPECT_EQ(run_well({"eval", "revectorize/shadow_test", "--at", "-0x1p+0,0,0.5"}).out,
              "receiver,bias,occluder,result\n-0x1p+0,0,0.5,1\n");
}

TEST(eval, takes_masks) {
    EXPECT_EQ(run_well({"eval", "smsr/visibility", "--at", "..#/###,lit,0,0,0.5,0.25", "--reference"}).out,
              "mask,outside,texel_x,texel_y,p_x,p_y,result,reference\n"
              "..#/###,lit,0,0,0.5,0.25,0x1p+0,0x1p+0\n");
}

TEST(eval, vectors_have_a_column_per_component) {
    EXPECT_EQ(run_well({"eval", "revectorize/traversal", "--at", "..#/###,lit,0,0,0,2", "--reference"}).out,
              "mask,outside,texel_x,texel_y,sides_x,sides_y,result_x,result_y,result_z,result_w,"
              "reference_x,reference_y,reference_z,reference_w\n"
              "..#/###,lit,0,0,0,2,-1,2,-1,1,-1,2,-1,1\n");
    EXPECT_EQ(run_well({"eval", "revectorize/dominance", "--at", "#../..#/.##,shadow,1,1,2,2"}).out,
              "mask,outside,texel_x,texel_y,sides_x,sides_y,result_x,result_y\n"
              "#../..#/.##,shadow,1,1,2,2,1,1\n");
}

TEST(eval, many_rows_keep_their_order) {
    const TemporaryFolder folder;
    std::string text = "receiver,bias,occluder\n", expected = "receiver,bias,occluder,result\n";
    for (int i = 0; i < 5000; ++i) {
        const std::string row = fmt::format("{},0,0.5", i / 5000.0);
        text += row + "\n";
        expected += fmt::format("{},{}\n", row, i <= 2500 ? 1 : 0);
    }
    const auto in = folder.write("in.csv", text);
    EXPECT_EQ(run_well({"eval", "revectorize/shadow_test", "--in", in.string()}).out, expected);
}

TEST(eval, overwrites_a_file_whole) {
    const TemporaryFolder folder;
    const auto out = folder.write("out.csv", std::string(10000, 'x'));
    run_well({"eval", "smsr/case_01", "--at", "0,0", "--out", out.string()});
    EXPECT_EQ(read_file(out), "p_x,p_y,result\n0,0,0x1p+0\n");
}

class eval_refuses : public ::testing::Test {
protected:
    void refuse(const testing::Arguments& arguments, const std::string& what) {
        expect_refused(folder_, testing::Arguments{"eval"} + arguments, what);
    }
    /// A CSV file with this text, and a result that must not come to be.
    void refuse_file(const std::string& kernel, const std::string& text, const std::string& what) {
        const std::string in = folder_.write("in.csv", text).string();
        const std::string out = (folder_.path() / "out.csv").string();
        refuse({kernel, "--in", in, "--out", out}, what);
        EXPECT_FALSE(std::filesystem::exists(out));
    }
    const TemporaryFolder folder_;
};

TEST_F(eval_refuses, unknown_kernels) { refuse({"smsr/case_9", "--at", "0,0,0"}, "smsr/case_09"); }

TEST_F(eval_refuses, malformed_files) {
    refuse_file("smsr/case_09", "p_x,p_y\n0,0\n", "no column \"along_x\"");
    refuse_file("smsr/case_09", "p_x,p_y,along_x\n0,0,zero\n", "in.csv: row 1, column along_x is \"zero\"");
    refuse_file("smsr/case_09", "p_x,p_y,along_x\n0,0\n", "line 2 has 2 cells");
    refuse_file("smsr/case_09", "p_x,p_y,along_x\n", "no rows");
    refuse_file("smsr/case_09", "", "empty");
    refuse_file("smsr/case_09", "p_x,p_y,along_x\n0,0,1e99\n", "float can hold");
    refuse_file("smsr/case_04", "p_x,p_y,along_y,side_x\n0,0,0,-1\n", "whole number");
    refuse_file("smsr/number", "mask,texel_x,texel_y\n##/#,0,0\n", "row 2 has 1 texels");
    refuse_file("smsr/number", "mask,texel_x,texel_y\n#?,0,0\n", "column 2 is '?'");
    refuse_file("smsr/number", "mask,outside,texel_x,texel_y\n#,dim,0,0\n", "\"dim\"");
}

TEST_F(eval_refuses, files_that_are_not_there_or_cannot_be_written) {
    refuse({"smsr/case_09", "--in", (folder_.path() / "none.csv").string()}, "none.csv");
    refuse({"smsr/case_09", "--in", folder_.path().string()}, "folder");
    refuse({"smsr/case_01", "--at", "0,0", "--out", "/nowhere/out.csv"}, "/nowhere");
    refuse({"smsr/case_01", "--at", "0,0", "--out", folder_.path().string()}, "folder");
}

TEST_F(eval_refuses, options_that_do_not_fit) {
    refuse({"smsr/case_01"}, "--in");
    refuse({"smsr/case_01", "--in", "a.csv", "--at", "0,0"}, "--at");
    refuse({"smsr/case_01", "--at", "0"}, "--at");
    refuse({"smsr/case_01", "--at", "0,0,0"}, "--at");
    refuse({"smsr/case_01", "--at", "0,0", "--device", "nonesuch"}, "nonesuch");
    refuse({}, "KERNEL");
}

TEST_F(eval_refuses, kernels_that_do_not_compile) {
    std::filesystem::create_directories(folder_.path() / "kernels/smsr");
    folder_.write("kernels/smsr/case_01.glsl", "float smsr_case_01(vec2 p) { return q; }\n");
    refuse({"smsr/case_01", "--at", "0,0", "--kernels", (folder_.path() / "kernels").string()},
           "kernels/smsr/case_01.glsl:1: ");
}

} // namespace
} // namespace gnomon
