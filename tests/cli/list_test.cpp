// The verbs that only tell: list, describe, devices, --version, --help.
#include "casegen/catalogue.h"
#include "tests/pipeline/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace gnomon {
namespace {

using ::testing::HasSubstr;
using testing::run_well;
using ::testing::StartsWith;

TEST(list, names_every_kernel_once) {
    const std::string out = run_well({"list"}).out;
    std::size_t kernels = 0;
    for (const Case* c : find_cases("")) {
        EXPECT_THAT("\n" + out, HasSubstr("\n" + c->name + " ")) << c->name;
        EXPECT_THAT(out, HasSubstr(c->source)) << c->name;
        ++kernels;
    }
    EXPECT_EQ(std::ranges::count(out, '\n'), static_cast<std::ptrdiff_t>(kernels));
}

TEST(list, takes_a_glob_or_a_part_of_a_name) {
    for (const char* pattern : {"smsr/case_1?", "smsr/case_1"}) {
        const std::string out = run_well({"list", pattern}).out;
        EXPECT_EQ(std::ranges::count(out, '\n'), 3) << out;
        EXPECT_THAT(out, StartsWith("smsr/case_10 "));
    }
}

TEST(describe, shows_signature_columns_ranges_tolerance_source_comment_and_witness) {
    const std::string out = run_well({"describe", "smsr/case_09"}).out;
    EXPECT_THAT(out, StartsWith("float smsr_case_09(vec2 p, float along_x)\n"));
    for (const char* part : {"p_x,p_y,along_x", "0 to 1", "input within 5.96e-08", "SMSR case 9",
                             "whose only shadowed neighbour lies towards +y", "witness", "[texels]"})
        EXPECT_THAT(out, HasSubstr(part)) << part;
}

TEST(describe, works_for_every_kernel) {
    for (const Case* c : find_cases("")) {
        const std::string out = run_well({"describe", c->name}).out;
        EXPECT_THAT(out, HasSubstr(function_name(*c) + "(")) << c->name;
        for (const std::string& column : columns(*c)) EXPECT_THAT(out, HasSubstr(column)) << c->name;
        for (const Parameter& p : c->parameters) EXPECT_THAT(out, HasSubstr(p.meaning)) << c->name;
    }
}

TEST(devices, lists_lavapipe) { EXPECT_THAT(run_well({"devices"}).out, HasSubstr("llvmpipe")); }

TEST(program, tells_its_version) {
    EXPECT_THAT(run_well({"--version"}).out, AllOf(StartsWith("gnomon "), HasSubstr("glslang")));
}

TEST(program, helps) { EXPECT_THAT(run_well({"--help"}).out, HasSubstr("--help")); }

/// As the program tells whom it does not understand.
std::vector<std::string> verbs() {
    const std::string line = testing::run_gnomon({"no-such-verb"}).err;
    std::istringstream names(line.substr(line.rfind(':') + 1));
    std::vector<std::string> verbs;
    for (std::string name; names >> name;) verbs.push_back(name);
    return verbs;
}

TEST(program, helps_with_every_verb_alone_and_behind_an_option) {
    const std::vector<std::string> all = verbs();
    EXPECT_THAT(all, ::testing::IsSupersetOf({"check", "devices"}));
    for (const std::string& verb : all) {
        EXPECT_THAT(run_well({verb, "--help"}).out, HasSubstr("Usage: gnomon " + verb + " ")) << verb;
        EXPECT_THAT(run_well({"--validation", verb, "--help"}).out, HasSubstr("Usage: gnomon " + verb + " "))
            << verb;
    }
}

} // namespace
} // namespace gnomon
