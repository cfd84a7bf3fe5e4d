// gnomon revectorize.
#include "casegen/csv.h"
#include "casegen/mask.h"
#include "runtime/files.h"
#include "runtime/image.h"
#include "tests/pipeline/cli.h"
#include "tests/support/environment.h"
#include "tests/support/smsr_chain.h"
#include "tests/support/techniques.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

namespace gnomon::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* shapes = "##......\n"
                               "..###...\n"
                               ".####..#\n"
                               ".#..##..\n"
                               "....###.\n"
                               ".#......\n";

/// The picture's pixels as '#' and '.'; anything but black and white fails.
std::string text_of(const Image& image) {
    std::string text;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Rgb pixel = image.at(x, y);
            EXPECT_TRUE(pixel == Rgb({0, 0, 0}) || pixel == Rgb({255, 255, 255})) << x << ' ' << y;
            text += pixel.r == 0 ? '#' : '.';
        }
        text += '\n';
    }
    return text;
}

std::string picture(const TemporaryFolder& folder, const std::string& mask, const Arguments& options) {
    const std::string image = folder.path() / "picture.png";
    run_well(Arguments{"revectorize", mask, "--out", image} + options);
    return text_of(read_png(image));
}

/// Case 6 cuts its texel along the diagonal, case 10 cuts a run of two along its own; points on the line are
/// lit.
TEST(Revectorize, DrawsKnownCases) {
    const TemporaryFolder folder;
    const std::string step = folder.write("step.txt", ".#\n##\n");
    EXPECT_EQ(picture(folder, step, {"--scale", "4", "--outside", "lit"}), "....####\n"
                                                                           "...#####\n"
                                                                           "..######\n"
                                                                           ".#######\n"
                                                                           "########\n"
                                                                           "########\n"
                                                                           "########\n"
                                                                           "########\n");
    const std::string run = folder.write("run.txt", "####\n...#\n....\n");
    EXPECT_EQ(picture(folder, run, {"--scale", "2", "--outside", "clamp", "--technique", "nsm"}),
              "########\n"
              "########\n"
              "......##\n"
              "......##\n"
              "........\n"
              "........\n");
}

TEST(Revectorize, DrawsWhatTheReferenceSaysForEverySurround) {
    const TemporaryFolder folder;
    const std::string path = folder.write("mask.txt", shapes);
    constexpr int scale = 8;
    std::vector<std::string> pictures;
    for (const auto& [name, outside] : {std::pair("clamp", Outside::clamp), std::pair("lit", Outside::lit),
                                        std::pair("shadow", Outside::shadow)}) {
        SCOPED_TRACE(name);
        Mask mask = load_mask(path);
        mask.outside = outside;
        const std::string image = folder.path() / "out.png";
        run_well({"revectorize", path, "--outside", name, "--scale", std::to_string(scale), "--out", image});
        const Image got = read_png(image);
        ASSERT_EQ(got.width, mask.width * scale);
        ASSERT_EQ(got.height, mask.height * scale);
        pictures.push_back(text_of(got));
        int compared = 0;
        for (int y = 0; y < got.height; ++y)
            for (int x = 0; x < got.width; ++x) {
                const glm::dvec2 p((x % scale + 0.5) / scale, (y % scale + 0.5) / scale);
                const auto reference = [&](glm::dvec2 offset) {
                    return reference::smsr_visibility_in_mask_space(mask, {x / scale, y / scale}, p + offset);
                };
                const double want = reference({0, 0});
                constexpr double hair = 1e-5;
                if (reference({hair, hair}) != want || reference({-hair, -hair}) != want ||
                    reference({hair, -hair}) != want || reference({-hair, hair}) != want)
                    continue;
                ++compared;
                EXPECT_EQ(got.at(x, y).r, want == 0 ? 0 : 255) << x << ' ' << y;
            }
        EXPECT_GT(compared, got.width * got.height * 9 / 10);
    }
    EXPECT_NE(pictures[0], pictures[1]);
    EXPECT_NE(pictures[1], pictures[2]);
}

TEST(Revectorize, ReadsAMaskAsTextAndAsAPicture) {
    const TemporaryFolder folder;
    const std::string text = folder.write("mask.txt", shapes);
    const Mask mask = load_mask(text);
    Image image(mask.width, mask.height);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            image.at(x, y) = mask.lit(x, y) ? Rgb{250, 240, 255} : Rgb{10, 0, 20};
    const std::string png = folder.path() / "mask.png";
    write_png(png, image);
    for (const char* technique : {"smsr", "nsm"})
        EXPECT_EQ(picture(folder, png, {"--technique", technique}),
                  picture(folder, text, {"--technique", technique}));
}

TEST(Revectorize, NsmIsTheMaskItself) {
    const TemporaryFolder folder;
    EXPECT_EQ(picture(folder, folder.write("m.txt", shapes), {"--technique", "nsm", "--scale", "1"}), shapes);
}

TEST(Revectorize, OneTexel) {
    const TemporaryFolder folder;
    for (const std::string technique : {"smsr", "nsm"}) {
        EXPECT_EQ(picture(folder, folder.write("dark.txt", "#"), {"--scale", "2", "--technique", technique}),
                  "##\n##\n");
        EXPECT_EQ(picture(folder, folder.write("lit.txt", "."), {"--scale", "2", "--technique", technique}),
                  "..\n..\n");
    }
    EXPECT_EQ(picture(folder, folder.write("hole.txt", "."), {"--scale", "2", "--outside", "shadow"}),
              "##\n##\n"); // shadow on four sides
}

TEST(Revectorize, SamplesAgreeWithTheReference) {
    const TemporaryFolder folder;
    const std::string path = folder.write("mask.txt", shapes);
    Mask mask = load_mask(path);
    std::string in = "# from a test\nname,py,x,y,px\n"; // further columns, any order
    for (int y = -1; y <= mask.height; ++y)
        for (int x = -1; x <= mask.width; ++x)
            for (const auto& [px, py] : {std::pair(0.3, 0.8), std::pair(0.9, 0.15)})
                in += fmt::format("s{}_{},{},{},{},{}\n", x + 1, y + 1, py, x, y, px);
    const std::string samples = folder.write("in.csv", in), out = folder.path() / "out.csv";
    for (const char* technique : {"smsr", "nsm"}) {
        run_well({"revectorize", path, "--technique", technique, "--samples", samples, "--out", out});
        const Csv csv = read_csv(out);
        EXPECT_EQ(csv.header, (std::vector<std::string>{"name", "py", "x", "y", "px", "case", "visibility"}));
        ASSERT_EQ(csv.rows.size(), static_cast<std::size_t>(2 * (mask.width + 2) * (mask.height + 2)));
        for (const std::vector<std::string>& row : csv.rows) {
            const glm::ivec2 texel(std::stoi(row[2]), std::stoi(row[3]));
            const glm::dvec2 p(std::stod(row[4]), std::stod(row[1]));
            const bool lit = mask.lit(texel.x, texel.y);
            if (technique == std::string("nsm")) {
                EXPECT_EQ(row[5], "0");
                EXPECT_EQ(row[6], lit ? "1" : "0") << row[0];
                continue;
            }
            const Case* c = lit ? smsr_case_of(reference::edge(mask, texel)) : nullptr;
            EXPECT_EQ(row[5], std::to_string(c ? c->number : 0)) << row[0];
            EXPECT_EQ(std::stod(row[6]), reference::smsr_visibility_in_mask_space(mask, texel, p)) << row[0];
        }
    }
    // Without --out the table is printed, the same.
    const Ran printed = run_well({"revectorize", path, "--technique", "nsm", "--samples", samples});
    EXPECT_EQ(printed.out, read_file(out));
}

/// Masks drawn by hand after the supplement's pictures.
TEST(Revectorize, NumbersTheWitnessesOfAllCases) {
    const TemporaryFolder folder;
    std::istringstream lines(read_file(fixtures_folder() / "witnesses" / "smsr.txt"));
    std::set<unsigned> seen;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || std::isdigit(static_cast<unsigned char>(line[0])) == 0) continue;
        std::istringstream words(line);
        unsigned number = 0;
        std::string outside, rows;
        words >> number >> outside >> rows;
        const std::size_t mark = rows.find('o'),
                          width = rows.find('/') == rows.npos ? rows.size() : rows.find('/');
        ASSERT_NE(mark, rows.npos) << line;
        const std::size_t x = mark % (width + 1), y = mark / (width + 1);
        rows[mark] = '.';
        std::ranges::replace(rows, '/', '\n');
        const Ran ran =
            run_well({"revectorize", folder.write("mask.txt", rows), "--outside", outside, "--samples",
                      folder.write("in.csv", fmt::format("x,y,px,py\n{},{},0.5,0.5\n", x, y))});
        const Csv csv = parse_csv(ran.out, line);
        EXPECT_EQ(csv.rows.at(0).at(csv.column("case")), std::to_string(number)) << line;
        seen.insert(number);
    }
    EXPECT_EQ(seen.size(), 12u);
}

/// What the search found for every way through the 31 cases.
TEST(Revectorize, NumbersTheWitnessesOfAllBranchesOfRsmss) {
    const TemporaryFolder folder;
    std::istringstream lines(read_file(fixtures_folder() / "witnesses" / "rsmss_branches.txt"));
    std::map<std::pair<std::string, std::string>, std::vector<std::pair<unsigned, glm::ivec2>>> by_mask;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("//")) continue;
        std::istringstream words(line.substr(line.find(": ") + 2));
        std::string outside, rows;
        glm::ivec2 texel(0);
        char comma = 0;
        words >> outside >> texel.x >> comma >> texel.y >> rows;
        const auto number = static_cast<unsigned>(std::stoi(line.substr(std::string("rsmss/case_").size())));
        std::ranges::replace(rows, '/', '\n');
        by_mask[{rows, outside}].emplace_back(number, texel);
    }
    std::set<unsigned> seen;
    for (const auto& [mask, expected] : by_mask) {
        if (std::ranges::all_of(expected, [&](const auto& e) { return seen.contains(e.first); })) continue;
        std::string in = "x,y,px,py\n";
        for (const auto& [number, texel] : expected)
            in += fmt::format("{},{},0.25,0.625\n", texel.x, texel.y);
        const Ran ran = run_well({"revectorize", folder.write("mask.txt", mask.first), "--technique", "rsmss",
                                  "--outside", mask.second, "--samples", folder.write("in.csv", in)});
        const Csv csv = parse_csv(ran.out, mask.first);
        Mask parsed = parse_mask(mask.first, '\n', "witness");
        parsed.outside = parse_outside(mask.second, "witness");
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_EQ(csv.rows.at(i).at(csv.column("case")), std::to_string(expected[i].first)) << mask.first;
            EXPECT_NEAR(
                std::stod(csv.rows.at(i).at(csv.column("visibility"))),
                reference::rsmss_visibility_in_mask_space(parsed, expected[i].second, {0.25, 0.625}, 0), 1e-6)
                << mask.first;
            seen.insert(expected[i].first);
        }
    }
    EXPECT_EQ(seen.size(), 31u);
}

TEST(Revectorize, FiltersAndShapesAgreeWithTheirReferences) {
    const TemporaryFolder folder;
    const std::string path = folder.write("mask.txt", shapes);
    const Mask mask = load_mask(path);
    std::string in = "x,y,px,py\n";
    std::vector<glm::ivec2> texels;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            in += fmt::format("{},{},0.3,0.8\n", x, y);
            texels.emplace_back(x, y);
        }
    const std::string samples = folder.write("in.csv", in);
    for (const ReferenceTechnique& technique : {rsmss, rbsm_silhouette, rbsm_filter}) {
        const Ran ran = run_well({"revectorize", path, "--technique", technique.name, "--samples", samples});
        const Csv csv = parse_csv(ran.out, technique.name);
        std::size_t grey = 0;
        for (std::size_t i = 0; i < texels.size(); ++i) {
            const double got = std::stod(csv.rows.at(i).at(csv.column("visibility")));
            EXPECT_NEAR(got, technique.visibility(mask, texels[i], {0.3, 0.8}), 1e-6) << technique.name << i;
            grey += got > 0 && got < 1 ? 1 : 0;
        }
        EXPECT_EQ(grey > 0, technique.name != std::string("rbsm-silhouette")) << technique.name;
    }
}

TEST(Revectorize, ReadsTheDocumentAsAsked) {
    const TemporaryFolder folder;
    const std::string bar = folder.write("bar.txt", "...\n.#.\n.#.\n...\n");
    const std::string samples = folder.write("in.csv", "x,y,px,py\n1,1,0.25,0.5\n");
    const auto value = [&](const Arguments& readings) {
        const Ran ran =
            run_well(Arguments{"revectorize", bar, "--technique", "rsmss", "--samples", samples} + readings);
        return parse_csv(ran.out, "out").rows.at(0).back();
    };
    EXPECT_EQ(value({}), "0");
    EXPECT_EQ(value({"--reading", "bar=ramp"}), "0.75");
    EXPECT_EQ(value({"--reading", "bar=ramp", "--reading", "bar=dark"}), "0");
    expect_refused(folder,
                   {"revectorize", bar, "--technique", "rsmss", "--samples", samples, "--reading", "bar=no"},
                   "bar is one of dark, ramp");
    expect_refused(folder, {"revectorize", bar, "--samples", samples, "--reading", "bar=ramp"},
                   "only --technique rsmss");
    const std::string dot = folder.write("dot.txt", "...\n.#.\n...\n");
    EXPECT_EQ(picture(folder, dot, {"--technique", "nsm", "--scale", "1", "--reading", "isolated=flipped"}),
              "...\n...\n...\n");
}

TEST(Revectorize, WritesAPictureAndATableAtOnce) {
    const TemporaryFolder folder;
    const std::string path = folder.write("mask.txt", shapes);
    const std::string samples = folder.write("in.csv", "x,y,px,py\n0,0,0,1\n");
    const std::string image = folder.path() / "a.png", table = folder.path() / "b.csv";
    const Ran ran = run_well({"revectorize", path, "--samples", samples, "--out", table, "--out", image});
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(read_png(image).width, 8 * 16);
    EXPECT_EQ(read_csv(table).rows.size(), 1u);
}

TEST(Revectorize, RefusesBadMasks) {
    const TemporaryFolder folder;
    const std::string out = folder.path() / "out.png";
    const auto refused = [&](const std::string& mask, const std::string& what) {
        expect_refused(folder, {"revectorize", mask, "--out", out}, what);
    };
    refused(folder.path() / "missing.txt", "missing.txt");
    refused(folder.path(), "folder");
    refused(folder.write("ragged.txt", "##..\n#..\n"), "row 2");
    refused(folder.write("gap.txt", "##\n\n##\n"), "row 2");
    refused(folder.write("other.txt", "##x.\n"), "column 3");
    refused(folder.write("tab.txt", "##\t.\n"), "0x09");
    refused(folder.write("empty.txt", ""), "no texels");
    refused(folder.write("lines.txt", "\n\n\n"), "no texels");
    refused(folder.write("wide.txt", std::string(16385, '.')), "16384");
    Image image(20, 20, {255, 255, 255});
    const std::string whole = folder.path() / "whole.png";
    write_png(whole, image);
    const std::string bytes = read_file(whole);
    refused(folder.write("cut.png", bytes.substr(0, bytes.size() / 2)), "cut.png");
    refused(folder.write("signature.png", bytes.substr(0, 8)), "signature.png");
    std::string damaged = bytes;
    damaged[bytes.size() - 20] = static_cast<char>(damaged[bytes.size() - 20] ^ 0x55);
    refused(folder.write("damaged.png", damaged), "damaged.png");
}

TEST(Revectorize, RefusesBadSamples) {
    const TemporaryFolder folder;
    const std::string mask = folder.write("mask.txt", shapes);
    const std::string table = folder.path() / "out.csv", image = folder.path() / "out.png";
    const auto refused = [&](const std::string& text, const std::string& what) {
        const std::string in = folder.write("in.csv", text);
        expect_refused(folder, {"revectorize", mask, "--samples", in, "--out", table, "--out", image}, what);
    };
    refused("", "empty");
    refused("x,y,px,py\n", "no rows");
    refused("x,y,px\n1,1,0.5\n", "py");
    refused("x,x,px,py\n1,1,0.5,0.5\n", "two columns");
    refused("x,y,px,py\n1,1,0.5,half\n", "half");
    refused("x,y,px,py\n1,1.5,0.5,0.5\n", "whole number");
    refused("x,y,px,py\n1,99999999999,0.5,0.5\n", "whole number");
    refused("x,y,px,py\n1,1,0.5,1.5\n", "0 to 1");
    refused("x,y,px,py\n1,1,-0.1,0.5\n", "0 to 1");
    refused("x,y,px,py\n1,1,nan,0.5\n", "0 to 1");
    refused("x,y,px,py\n1,1,0.5\n", "cells");
    refused("x,y,px,py\n1,1,,0.5\n", "px");
    expect_refused(folder, {"revectorize", mask, "--samples", folder.path() / "absent.csv", "--out", image},
                   "absent.csv");
}

TEST(Revectorize, RefusesBadOptions) {
    const TemporaryFolder folder;
    const std::string mask = folder.write("mask.txt", shapes), out = folder.path() / "out.png";
    const std::string in = folder.write("in.csv", "x,y,px,py\n1,1,0.5,0.5\n");
    const std::vector<std::pair<Arguments, std::string>> all{
        {{mask}, "--out"},
        {{"--out", out}, "MASK"},
        {{mask, "--out", out, "--scale", "0"}, "--scale"},
        {{mask, "--out", out, "--scale", "-1"}, "--scale"},
        {{mask, "--out", out, "--scale", "10000"}, "--scale"},
        {{mask, "--out", out, "--scale", "99999999999999"}, "--scale"},
        {{mask, "--out", out, "--outside", "dark"}, "--outside"},
        {{mask, "--out", out, "--technique", "raytraced"}, "--technique"},
        {{mask, "--out", out, "--out", folder.path() / "b.png"}, "two files"},
        {{mask, "--out", folder.path() / "t.csv"}, "--samples"},
        {{mask, "--out", folder.path() / "absent" / "a.png"}, "absent"},
        {{mask, "--samples", in, "--out", out, "--out", folder.path() / "absent" / "t.csv"}, "absent"},
        {{mask, "--samples", in, "--out", folder.path() / "t.csv", "--out",
          folder.path() / "absent" / "a.png"},
         "absent"},
    };
    for (const auto& [options, what] : all) expect_refused(folder, Arguments{"revectorize"} + options, what);
}

} // namespace
} // namespace gnomon::testing
