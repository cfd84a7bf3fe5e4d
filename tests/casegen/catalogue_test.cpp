#include "casegen/catalogue.h"

#include "runtime/files.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using testing::kernels_folder;
using ::testing::Not;
using testing::TemporaryFolder;

/// What is in the folder but in no table, and the other way round.
std::vector<std::string> differences(const fs::path& kernels) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(kernels))
        if (entry.path().extension() == ".glsl")
            files.insert(fs::relative(entry.path(), kernels).replace_extension().generic_string());
    std::vector<std::string> found;
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (files.erase(c.name) == 0) found.push_back(c.name + " has no file");
    for (const std::string& name : files) found.push_back(name + " is in no table");
    return found;
}

TEST(catalogue, lists_the_folder_s_kernels_and_no_others) {
    EXPECT_THAT(differences(kernels_folder()), IsEmpty());
}

TEST(catalogue, a_forgotten_or_surplus_file_would_be_noticed) {
    const TemporaryFolder folder;
    fs::copy(kernels_folder(), folder.path(), fs::copy_options::recursive);
    fs::rename(folder.path() / "smsr/case_09.glsl", folder.path() / "smsr/case_99.glsl");
    EXPECT_THAT(differences(folder.path()),
                ElementsAre("smsr/case_09 has no file", "smsr/case_99 is in no table"));
}

TEST(catalogue, every_kernel_file_defines_its_function_and_begins_with_what_it_computes) {
    for (const Case* c : find_cases("")) {
        const std::string text = read_file(kernels_folder() / (c->name + ".glsl"));
        EXPECT_TRUE(text.starts_with("// ")) << c->name;
        EXPECT_THAT(text, HasSubstr(glsl_name(c->reference.result) + " " + function_name(*c) + "("));
        EXPECT_EQ(text.find("void main"), text.npos) << c->name;
    }
}

TEST(catalogue, entries_are_complete) {
    std::set<std::string> names;
    for (const Family& family : catalogue()) {
        EXPECT_FALSE(family.what.empty()) << family.name;
        std::set<unsigned> numbers;
        for (const Case& c : family.cases) {
            EXPECT_TRUE(names.insert(c.name).second) << c.name << " is there twice";
            EXPECT_TRUE(c.name.starts_with(family.name + "/")) << c.name;
            EXPECT_FALSE(c.source.empty()) << c.name;
            EXPECT_EQ(c.parameters.size(), c.reference.parameters.size()) << c.name;
            EXPECT_TRUE(c.reference.call) << c.name;
            EXPECT_LE(c.result.lower, c.result.upper) << c.name;
            for (const Parameter& p : c.parameters) {
                EXPECT_FALSE(p.name.empty() || p.unit.empty() || p.meaning.empty())
                    << c.name << " " << p.name;
                if (p.domain.choices.empty()) EXPECT_LE(p.domain.lower, p.domain.upper) << c.name;
            }
            if (c.number == 0) continue;
            EXPECT_FALSE(c.condition.empty()) << c.name << " is numbered, but nothing says when it applies";
            EXPECT_FALSE(c.formula.empty()) << c.name << " is numbered, but has no formula";
            EXPECT_TRUE(numbers.insert(c.number).second) << c.name << " repeats a number";
        }
    }
}

TEST(catalogue, smsr_has_the_twelve_cases_by_number) {
    for (unsigned number = 1; number <= 12; ++number)
        EXPECT_EQ(find_case(fmt::format("smsr/case_{:02}", number)).number, number);
    EXPECT_EQ(find_cases("smsr/case_").size(), 12u);
}

TEST(catalogue, rsmss_has_the_31_cases_and_rbsm_nine_shapes_by_number) {
    for (unsigned number = 1; number <= 31; ++number)
        EXPECT_EQ(find_case(fmt::format("rsmss/case_{:02}", number)).number, number);
    EXPECT_EQ(find_cases("rsmss/case_").size(), 31u);
    std::map<std::string, unsigned> shapes;
    for (const Case* c : find_cases("rbsm/"))
        if (c->number != 0) ++shapes[c->name.substr(0, c->name.rfind('/'))];
    EXPECT_THAT(shapes,
                ElementsAre(::testing::Pair("rbsm/filter", 5), ::testing::Pair("rbsm/silhouette", 4)));
}

std::vector<std::string> names_of(const std::string& pattern) {
    std::vector<std::string> names;
    for (const Case* c : find_cases(pattern)) names.push_back(c->name);
    return names;
}

TEST(catalogue, patterns_are_parts_of_names_or_globs) {
    EXPECT_THAT(names_of("smsr/case_09"), ElementsAre("smsr/case_09"));
    EXPECT_THAT(names_of("case_09"), ElementsAre("smsr/case_09", "rsmss/case_09"));
    EXPECT_THAT(names_of("smsr/case_1?"), ElementsAre("smsr/case_10", "smsr/case_11", "smsr/case_12"));
    EXPECT_THAT(names_of("s*/case_0[12]"), ElementsAre("smsr/case_01", "smsr/case_02"));
    std::size_t all = 0;
    for (const Family& family : catalogue()) all += family.cases.size();
    EXPECT_EQ(names_of("").size(), all);
    EXPECT_EQ(names_of("*").size(), all);
}

TEST(catalogue, patterns_apart_by_commas_name_a_kernel_once) {
    EXPECT_THAT(names_of("rsmss/case_09,smsr/case_0[89],case_09"),
                ElementsAre("smsr/case_08", "smsr/case_09", "rsmss/case_09"));
    for (const char* pattern : {",", "smsr,", ",smsr", "smsr,,rsmss"}) EXPECT_THROW(names_of(pattern), Error);
    try {
        names_of("smsr/case_09,smsr/case_99");
        FAIL() << "nothing is named smsr/case_99";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("no kernel matches \"smsr/case_99\"; near names: "));
    }
}

TEST(catalogue, unknown_kernels_get_near_names) {
    EXPECT_THAT(error_of([] { find_case("smsr/case_9"); }),
                AllOf(HasSubstr("\"smsr/case_9\""), HasSubstr("smsr/case_09")));
    EXPECT_THAT(error_of([] { find_cases("decison"); }), HasSubstr("smsr/decision"));
    EXPECT_THAT(error_of([] { find_case("revectorise/walk"); }), HasSubstr("revectorize/walk"));
    EXPECT_THAT(error_of([] { find_cases("smsr/x*"); }), HasSubstr("\"smsr/x*\""));
    EXPECT_THAT(error_of([] { find_case(""); }), HasSubstr("gnomon list"));
    EXPECT_THAT(error_of([] { find_case("case_09"); }), HasSubstr("smsr/case_09")); // exactly, not a part
}

TEST(catalogue, generates_the_choice_of_cases) {
    const std::string text = generated_sources().at("smsr/cases");
    for (const Case* c : find_cases("smsr/case_*")) {
        EXPECT_THAT(text, HasSubstr(fmt::format("#include \"{}.glsl\"", c->name)));
        EXPECT_THAT(text, HasSubstr(fmt::format("case {}u: return {}(", c->number, function_name(*c))));
    }
    EXPECT_THAT(text,
                HasSubstr("float smsr_case(uint number, Edge edge, float along_x, float along_y, vec2 p, "
                          "uint side_x, uint side_y)"));
    EXPECT_THAT(text, HasSubstr("smsr_case_08(p, along_x, along_y, side_x, side_y)"));
    EXPECT_THAT(text, HasSubstr("return edge.lit ? 1.0 : 0.0;"));
    EXPECT_FALSE(generated_sources().contains("revectorize/cases")); // nothing numbered there
}

TEST(catalogue, techniques_are_families_with_a_visibility_kernel) {
    EXPECT_THAT(visibility_techniques(), IsSupersetOf({"nsm", "smsr"}));
    EXPECT_THAT(visibility_techniques(), Not(Contains("revectorize")));
    EXPECT_THAT(numbered_techniques(), Contains("smsr"));
    EXPECT_THAT(numbered_techniques(), Not(Contains("nsm")));
    for (const std::string& name : visibility_techniques()) {
        EXPECT_EQ(name.find('/'), name.npos) << "a technique is a file's name in reports";
        EXPECT_TRUE(find_kernel(technique_family(name), "visibility"));
    }
    EXPECT_EQ(technique_family("smsr").name, "smsr");
    EXPECT_THAT(error_of([] { technique_family("smrs"); }), AllOf(HasSubstr("\"smrs\""), HasSubstr("smsr")));
}

TEST(catalogue, a_family_in_a_folder_of_its_family_has_one_word_for_a_name) {
    EXPECT_EQ(identifier({.name = "rbsm/filter", .what = {}, .cases = {}}), "rbsm_filter");
    EXPECT_EQ(technique_name({.name = "rbsm/filter", .what = {}, .cases = {}}), "rbsm-filter");
}

} // namespace
} // namespace gnomon
