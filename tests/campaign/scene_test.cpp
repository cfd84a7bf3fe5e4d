// Scenes as inputs: in words, in a regression's file, and shrunk.
#include "casegen/catalogue.h"
#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/regression.h"
#include "casegen/fuzz/scene_input.h"
#include "casegen/fuzz/scene_shrink.h"
#include "runtime/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace gnomon::fuzz {
namespace {

using ::testing::HasSubstr;

const Chain& sheet() { return *find_chain(*find_subject("scene/sheet")); }

Input scene(std::uint64_t index = 1) { return sheet().draw(77, index, 1).front(); }

TEST(scene_input, is_the_same_bits_in_words_and_in_a_file) {
    const SceneInput read = scene_of(scene());
    EXPECT_GT(read.scene.triangles.size(), 50u);
    EXPECT_EQ(words_of(read).words, scene().words);
    const SceneInput again = scene_of(json_of(read), "text");
    EXPECT_EQ(words_of(again).words, scene().words);
}

TEST(scene_input, goes_into_a_regression_and_out_of_it) {
    const Regression regression{
        "scene/sheet", "certain of light, which a triangle blocks", scene(), "a", "b", "c", "d"};
    const Regression read = parse_regression(format_regression(regression), "file");
    EXPECT_EQ(read.input.words, regression.input.words);
    EXPECT_EQ(read.failure, regression.failure);
    EXPECT_TRUE(file_name(regression).starts_with("scene.sheet.certain-of-light"));
    Regression other = regression;
    other.input.words[0] ^= 1u;
    EXPECT_NE(file_name(other), file_name(regression));
}

TEST(scene_input, refuses_what_is_none_with_one_line) {
    const nlohmann::ordered_json whole = json_of(scene_of(scene()));
    const auto refused = [&](const auto& change, const std::string& what) {
        nlohmann::ordered_json object = whole;
        change(object);
        try {
            scene_of(object, "file");
            ADD_FAILURE() << what;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("file"));
            EXPECT_THAT(error.what(), HasSubstr(what));
        }
    };
    refused([](auto& o) { o.erase("camera"); }, "camera");
    refused([](auto& o) { o["lamp"] = 1; }, "lamp");
    refused([](auto& o) { o["camera"]["tilt"] = 1; }, "tilt");
    refused([](auto& o) { o["light"]["direction"] = {"0x0p+0", "0x0p+0", "0x0p+0"}; }, "direction");
    refused([](auto& o) { o["light"]["direction"] = "up"; }, "three");
    refused([](auto& o) { o["settings"]["width"] = 0; }, "width");
    refused([](auto& o) { o["settings"]["width"] = 1 << 20; }, "width");
    refused([](auto& o) { o["settings"]["light_fit"] = "tight"; }, "light_fit");
    refused([](auto& o) { o["vertices"][0] = {"nan", "0x0p+0", "0x0p+0"}; }, "vertex");
    refused([](auto& o) { o["vertices"][0] = {1, 2, 3}; }, "vertex 0");
    refused([](auto& o) { o["triangles"] = nlohmann::ordered_json::array(); }, "triangles");
    refused([](auto& o) { o["triangles"][0][1] = 100000; }, "100000");
    refused([](auto& o) { o["triangles"][0][1] = -1; }, "triangle 0");
    Input input = scene();
    input.words.pop_back();
    EXPECT_THROW(scene_of(input), Error);
    input.words.insert(input.words.end(), 2, 0u);
    EXPECT_THROW(scene_of(input), Error);
}

TEST(scene_shrink, keeps_only_the_triangles_that_a_failure_needs) {
    // Fails while two certain places are corners.
    const SceneInput whole = scene_of(scene(2));
    const glm::vec3 one = whole.scene.positions[whole.scene.triangles[40].x],
                    other = whole.scene.positions[whole.scene.triangles[250].y];
    std::size_t asked = 0;
    const auto fails = [&](std::span<const Input> candidates) {
        std::vector<bool> result;
        for (const Input& candidate : candidates) {
            ++asked;
            const auto& positions = scene_of(candidate).scene.positions;
            result.push_back(std::ranges::find(positions, one) != positions.end() &&
                             std::ranges::find(positions, other) != positions.end());
        }
        return result;
    };
    const SceneInput small = shrink_scene(whole, fails);
    EXPECT_LE(small.scene.triangles.size(), 2u);
    EXPECT_LE(small.scene.positions.size(), 6u);
    EXPECT_EQ(small.settings.width, 1);
    EXPECT_EQ(small.settings.shadow_map, 1);
    EXPECT_LE(asked, 200u);
    asked = 0;
    EXPECT_EQ(words_of(shrink_scene(whole, fails)).words, words_of(small).words);
}

TEST(scene_chain, draws_the_same_scenes_of_all_sizes_for_the_same_seed) {
    std::size_t fewest = 1000, most = 0;
    for (std::uint64_t i = 0; i < 6; ++i) {
        EXPECT_EQ(scene(i).words, scene(i).words);
        EXPECT_NE(scene(i).words, scene(i + 1).words);
        const std::size_t count = scene_of(scene(i)).scene.triangles.size();
        fewest = std::min(fewest, count), most = std::max(most, count);
    }
    EXPECT_LT(fewest, 30u);
    EXPECT_GT(most, 250u);
}

TEST(subjects, are_kernels_and_chains_by_one_pattern) {
    const auto names = [](const std::string& pattern) {
        std::vector<std::string> found;
        for (const Case* c : find_subjects(pattern)) found.push_back(c->name);
        return found;
    };
    EXPECT_THAT(names("chain/smsr"), ::testing::ElementsAre("chain/smsr"));
    EXPECT_THAT(names("scene/sheet,smsr/case_09"), ::testing::ElementsAre("smsr/case_09", "scene/sheet"));
    EXPECT_THAT(names("scene/*"), ::testing::ElementsAre("scene/sheet", "scene/nearest-8", "scene/lists"));
    EXPECT_THAT(names("smsr"),
                ::testing::AllOf(::testing::Contains("smsr/case_09"), ::testing::Contains("chain/smsr")));
    EXPECT_EQ(names("").size(), find_cases("").size() + chains().size());
    EXPECT_THROW(find_subjects("no such thing"), Error);
    EXPECT_THROW(find_subjects("chain/smsr,no such thing"), Error);
    EXPECT_EQ(find_subject("chain/nothing"), nullptr);
}

} // namespace
} // namespace gnomon::fuzz
