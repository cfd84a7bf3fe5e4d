// gnomon capture, and gnomon eval --expect, which replays its files.
#include "casegen/csv.h"
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon::testing {
namespace {

using ::testing::HasSubstr;

const Arguments small{"--size", "160x120", "--shadow-map", "128"};

/// A pixel of the demo scene in the default view that is of a case of smsr.
std::string edge_pixel(const TemporaryFolder& folder, const std::string& kernel) {
    const std::string out = folder.path() / "edge.csv";
    run_well(Arguments{"capture", "--case", kernel, "--most", "1", "--out", out} + small);
    const Csv csv = read_csv(out);
    std::filesystem::remove(out);
    return csv.rows[0][csv.column("pixel_x")] + ',' + csv.rows[0][csv.column("pixel_y")];
}

TEST(capture, of_a_pixel_is_what_eval_replays) {
    const TemporaryFolder folder;
    const std::string pixel = edge_pixel(folder, "smsr/case_09"), out = folder.path() / "pixel.csv";
    const Ran ran = run_well(Arguments{"capture", "--pixel", pixel, "--out", out, "--verify"} + small);
    EXPECT_THAT(ran.out,
                HasSubstr("smsr/visibility as smsr calls it in demo: 1 calls, at 1 of 1 pixels that do"));
    EXPECT_THAT(ran.out, HasSubstr("gnomon eval smsr/visibility --in '" + out + "' --expect captured"));
    EXPECT_THAT(ran.out, HasSubstr("alone, all 1 calls give the bits of the pipeline"));
    const Csv csv = read_csv(out);
    ASSERT_EQ(csv.rows.size(), 1u);
    EXPECT_EQ(csv.rows[0][csv.column("pixel_x")] + ',' + csv.rows[0][csv.column("pixel_y")], pixel);
    EXPECT_EQ(csv.rows[0][csv.column("captured")], csv.rows[0][csv.column("visibility")]);

    const Ran again = run_gnomon({"eval", "smsr/visibility", "--in", out, "--expect", "captured", "--out",
                                  folder.path() / "results.csv"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr("all 1 results are those of column captured"));
    const Csv results = read_csv(folder.path() / "results.csv");
    EXPECT_EQ(results.rows[0][results.column("result")], csv.rows[0][csv.column("captured")]);
}

TEST(capture, of_a_case_holds_its_own_inputs_at_all_its_pixels) {
    const TemporaryFolder folder;
    const std::string out = folder.path() / "case.csv", few = folder.path() / "few.csv";
    const Arguments command = Arguments{"capture", "--case", "rsmss/case_22", "--verify"} + small;
    const Ran ran = run_well(command + Arguments{"--out", out});
    EXPECT_THAT(ran.out, HasSubstr("rsmss/case_22 as rsmss calls it"));
    const Csv csv = read_csv(out);
    EXPECT_GT(csv.rows.size(), 20u);
    EXPECT_EQ(csv.header, (std::vector<std::string>{"p_x", "p_y", "along_x", "side_y", "pixel_x", "pixel_y",
                                                    "captured", "visibility"}));
    for (const std::vector<std::string>& row : csv.rows)
        EXPECT_EQ(row[csv.column("captured")], row[csv.column("visibility")]);

    run_well(command + Arguments{"--out", few, "--most", "7"});
    const Csv chosen = read_csv(few);
    EXPECT_EQ(chosen.rows.size(), 7u);
    for (const std::vector<std::string>& row : chosen.rows)
        EXPECT_NE(std::ranges::find(csv.rows, row), csv.rows.end());
    const std::string bytes = read_file(few);
    run_well(command + Arguments{"--out", few, "--most", "7"});
    EXPECT_EQ(read_file(few), bytes);
}

TEST(capture, of_any_kernel_that_a_pixel_meets) {
    const TemporaryFolder folder;
    const std::string pixel = edge_pixel(folder, "smsr/case_09"), out = folder.path() / "calls.csv";
    const auto captured = [&](const std::string& kernel) {
        run_well(Arguments{"capture", "--pixel", pixel, "--kernel", kernel, "--out", out, "--verify"} +
                 small);
        return read_csv(out);
    };
    EXPECT_EQ(captured("revectorize/walk").rows.size(), 4u);
    const Csv number = captured("smsr/number");
    EXPECT_EQ(number.rows[0][number.column("captured")], "9");
    const Csv own = captured("case"); // smsr/case_09
    EXPECT_EQ(own.rows[0][own.column("captured")], own.rows[0][own.column("visibility")]);
    EXPECT_EQ(own.header[2], "along_x");
    expect_refused(folder,
                   Arguments{"capture", "--pixel", pixel, "--kernel", "smsr/case_01", "--out",
                             folder.path() / "none.csv"} +
                       small,
                   "smsr calls smsr/case_01 at none of the 1 pixels");

    // Of all pixels only those that call it count: few pixels are of slots and bars.
    run_well(Arguments{"capture", "--technique", "rsmss", "--kernel", "revectorize/breach", "--most", "5",
                       "--out", out, "--verify"} +
             small);
    EXPECT_EQ(read_csv(out).rows.size(), 5u);
}

TEST(capture, under_a_reading_is_replayed_under_it) {
    const TemporaryFolder folder;
    const std::string out = folder.path() / "read.csv";
    const Ran ran = run_well(Arguments{"capture", "--technique", "rsmss", "--kernel", "rsmss/visibility",
                                       "--most", "500", "--reading", "isolated=flipped", "--reading",
                                       "bar=ramp", "--out", out, "--verify"} +
                             small);
    EXPECT_THAT(ran.out, HasSubstr("--reading isolated=flipped --reading bar=ramp"));
    EXPECT_THAT(ran.out, HasSubstr("alone, all 500 calls"));
}

TEST(capture, notices_a_kernel_that_answers_otherwise_alone) {
    // What one kernel leaves behind, another reads: alone it is not there.
    const ChangedKernels kernels("smsr/case_09.glsl", "return 1.0 - p.y",
                                 "if (left_behind > 0.0) return 0.5;\n    return 1.0 - p.y");
    const auto change = [&](const std::string& file, const std::string& from, const std::string& to) {
        std::string text = read_file(kernels.folder() / file);
        text.replace(text.find(from), from.size(), to);
        write_file(kernels.folder() / file, text);
    };
    change("smsr/case_09.glsl", "float smsr_case_09",
           "#include \"revectorize/sides.glslh\"\nfloat smsr_case_09");
    change("revectorize/sides.glslh", "const uint NEITHER", "float left_behind = 0.0;\nconst uint NEITHER");
    change("revectorize/traversal.glsl", "    return ivec4", "    left_behind = 1.0;\n    return ivec4");
    const TemporaryFolder folder;
    const std::string out = folder.path() / "case.csv";
    const Arguments command =
        Arguments{"--kernels", kernels.folder(), "capture", "--case", "smsr/case_09", "--out", out} + small;
    EXPECT_EQ(run_gnomon(command).exit_code, 0);
    const Ran ran = run_gnomon(command + Arguments{"--verify"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, HasSubstr("calls give other bits than in the pipeline; the first is row 1"));
    const Ran replayed = run_gnomon({"eval", "smsr/case_09", "--in", out, "--expect", "captured"});
    EXPECT_EQ(replayed.exit_code, 1);
    EXPECT_THAT(replayed.err, HasSubstr("results are not those of column captured; the first is row 1"));
}

TEST(capture, of_a_hybrid_is_what_eval_replays) {
    const TemporaryFolder folder;
    const std::string out = folder.path() / "calls.csv";
    const Ran ran =
        run_well(Arguments{"capture", "--kernel", "certainty/crsm", "--out", out, "--verify"} + small);
    EXPECT_THAT(ran.out, HasSubstr("calls, in hybrid/detect_crsm.comp\n"));
    const Csv all = read_csv(out);
    const std::vector<std::string>& row = all.rows[all.rows.size() / 2];
    const std::string pixel = row[all.column("pixel_x")] + ',' + row[all.column("pixel_y")];
    run_well(Arguments{"capture", "--technique", "crsm", "--pixel", pixel, "--out", out} + small);
    EXPECT_EQ(read_csv(out).rows, (std::vector<std::vector<std::string>>{row}));

    run_well(Arguments{"capture", "--technique", "crsm", "--kernel", "conservative/eroded", "--most", "40",
                       "--out", out} +
             small);
    const Ran again = run_gnomon({"eval", "conservative/eroded", "--in", out, "--expect", "captured"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr("all 40 results are those of column captured"));
}

TEST(capture, notices_a_hybrids_kernel_that_answers_otherwise_alone) {
    const ChangedKernels kernels("certainty/crsm.glsl", "return 2u;",
                                 "return gl_GlobalInvocationID.y > 60u ? 0u : 2u;");
    const TemporaryFolder folder;
    const Ran ran = run_gnomon(Arguments{"--kernels", kernels.folder(), "capture", "--kernel",
                                         "certainty/crsm", "--verify", "--out", folder.path() / "calls.csv"} +
                               small);
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, HasSubstr("calls give other bits than in the pipeline"));
}

TEST(capture, notices_a_kernel_that_depends_on_its_thread) {
    const ChangedKernels kernels("smsr/case_09.glsl", "return 1.0 - p.y",
                                 "if (gl_GlobalInvocationID.y > 3u) return 0.25;\n    return 1.0 - p.y");
    const TemporaryFolder folder;
    const Ran ran = run_gnomon(Arguments{"--kernels", kernels.folder(), "capture", "--case", "smsr/case_09",
                                         "--out", folder.path() / "case.csv"} +
                               small);
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, HasSubstr("some kernel is no function of its parameters"));
}

TEST(capture, says_what_cannot_be_captured) {
    const TemporaryFolder folder;
    const std::string out = folder.path() / "no.csv";
    const auto refused = [&](const Arguments& arguments, const std::string& what) {
        expect_refused(folder, Arguments{"capture", "--out", out} + small + arguments, what);
    };
    refused({}, "capture needs --pixel X,Y, or --case FAMILY/CASE, or --kernel KERNEL");
    refused({"--pixel", "160,3"}, "--pixel 160,3: the image is 160 x 120");
    refused({"--pixel", "3,-1"}, "--pixel 3,-1: the image is 160 x 120");
    refused({"--pixel", "3"}, "--pixel 3: X,Y is needed, two whole numbers");
    refused({"--pixel", "3,4,5"}, "--pixel 3,4,5: X,Y is needed");
    refused({"--pixel", "3,4junk"}, "--pixel 3,4junk: X,Y is needed");
    refused({"--pixel", "99999999999,4"}, "--pixel 99999999999,4: X,Y is needed");
    refused({"--pixel", "0,0"}, "--pixel 0,0: no surface is seen there");
    refused({"--case", "smsr/case_99"}, "no kernel matches \"smsr/case_99\"; near names");
    refused({"--case", "smsr/visibility"}, "--case smsr/visibility: not a numbered case");
    refused({"--case", "smsr/case_09", "--technique", "rsmss"}, "--case smsr/case_09: a case of smsr");
    refused({"--case", "smsr/case_09", "--pixel", "3,4"}, "--pixel and --case: give one");
    refused({"--kernel", "nobody/knows"}, "no kernel matches");
    refused({"--kernel", "column/plane", "--pixel", "80,60"},
            "column/plane is not called by smsr; what it calls can be captured: revectorize/shadow_test, ");
    refused({"--kernel", "rsmss/case_01", "--technique", "smsr"}, "rsmss/case_01 is not called by smsr");
    refused({"--kernel", "case"}, "--kernel case needs --pixel X,Y");
    refused({"--kernel", "case", "--technique", "nsm", "--pixel", "3,4"}, "nsm has no numbered cases");
    refused({"--technique", "auto", "--pixel", "3,4"}, "--technique: auto not in");
    refused({"--technique", "crsma", "--pixel", "0,0"}, "--pixel 0,0: no surface is seen there");
    refused({"--technique", "crsma", "--case", "smsr/case_09"}, "crsma has no numbered cases");
    refused({"--technique", "lists", "--pixel", "80,60"},
            "lists has no kernel that says all of a pixel: give --kernel as well");
    refused({"--technique", "lists", "--kernel", "column/hit"},
            "lists calls column/hit nowhere in this view");
    refused({"--technique", "traced", "--pixel", "80,60"}, "traced calls no kernel");
    refused({"--technique", "traced", "--kernel", "column/hit"}, "traced calls no kernel");
    refused({"--case", "smsr/case_09", "--most", "0"}, "--most");
    refused({"--case", "smsr/case_09", "--reading", "bar=ramp"}, "only --technique rsmss");
    expect_refused(folder, {"capture", "--kernel", "smsr/visibility", "--size", "1024x768", "--out", out},
                   "--most 50000 or less is possible");
    expect_refused(folder, {"capture", "--pixel", "3,4"}, "--out is required");
    expect_refused(folder, {"capture", "missing.obj", "--pixel", "3,4", "--out", out}, "missing.obj");
    expect_refused(folder, {"capture", "--pixel", "3,4", "--out", folder.path() / "none" / "a.csv"}, "none");
}

TEST(capture, says_where_no_kernel_is_asked_and_which_cases_there_are) {
    const TemporaryFolder folder;
    // One triangle, seen from behind its lit side; and a light that shines past it.
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string scene = folder.path() / "t.obj", out = folder.path() / "no.csv";
    const Arguments seen{"--camera-position", "0.3,0.3,3", "--camera-direction", "0,0,-1"};
    expect_refused(
        folder,
        Arguments{"capture", scene, "--pixel", "80,60", "--light-direction", "0,0,1", "--out", out} + seen +
            small,
        "--pixel 80,60: the surface there faces away from the light");
    expect_refused(folder,
                   Arguments{"capture", scene, "--pixel", "80,60", "--light-position", "1,0,1",
                             "--light-direction", "0,0,-1", "--light-fov", "10", "--out", out} +
                       seen + small,
                   "--pixel 80,60: the shadow map does not cover it");
    expect_refused(
        folder,
        Arguments{"capture", scene, "--case", "rsmss/case_17", "--light-direction", "0,0,-1", "--out", out} +
            seen + small,
        "no pixel of this view is of rsmss/case_17; it has pixels of the cases");
}

TEST(eval, expects_a_column_bit_for_bit) {
    const TemporaryFolder folder;
    const auto in =
        folder.write("in.csv", "p_x,p_y,along_x,want,word\n0.75,0.5,0.25,1,x\n0.75,0.5,0.75,0,x\n");
    const Arguments command{"eval",  "smsr/case_09",          "--in",    in.string(),
                            "--out", folder.path() / "o.csv", "--expect"};
    EXPECT_EQ(run_gnomon(command + Arguments{"want"}).exit_code, 0);
    folder.write("in.csv", "p_x,p_y,along_x,want\n0.75,0.5,0.25,1\n0.75,0.5,0.75,-0\n");
    const Ran ran = run_gnomon(command + Arguments{"want"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.err, HasSubstr("1 of 2 results are not those of column want; the first is row 2"));
    expect_refused(folder, command + Arguments{"wants"}, "no column \"wants\"");
    folder.write("in.csv", "p_x,p_y,along_x,want\n0.75,0.5,0.25,one\n");
    expect_refused(folder, command + Arguments{"want"}, "row 1, column want is \"one\"");
}

} // namespace
} // namespace gnomon::testing
