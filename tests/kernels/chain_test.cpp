// Chains as fuzzing judges them: right kernels break no invariant, and every invariant tells a kernel that
// breaks it from those that do not.
#include "casegen/fuzz/chain.h"
#include "runtime/files.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"
#include "tests/support/masks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>

namespace gnomon::fuzz {
namespace {

const Chain& chain(const std::string& name) { return *find_chain(*find_subject(name)); }

/// Every texel of some masks, at points all over.
std::vector<Input> texels() {
    Random random(17);
    std::vector<Input> inputs;
    for (const NamedMask& named : mask_corpus(5, 1, 12))
        for (int y = 0; y < named.mask.height; ++y)
            for (int x = 0; x < named.mask.width; ++x)
                inputs.push_back({{std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y),
                                   std::bit_cast<std::uint32_t>(static_cast<float>(random.unit())),
                                   std::bit_cast<std::uint32_t>(static_cast<float>(random.unit()))},
                                  named.mask});
    return inputs;
}

/// How often each invariant breaks, without the number of the case.
std::map<std::string, std::size_t> broken(const std::string& name, const glsl::Sources& sources) {
    std::map<std::string, std::size_t> counts;
    for (std::string& failure : chain(name).judge(sources, testing::shared_device())(texels()))
        if (!failure.empty()) ++counts[failure.substr(0, failure.find(" in case"))];
    return counts;
}

class mask_chains : public ::testing::TestWithParam<std::string> {};

TEST_P(mask_chains, break_nothing_as_they_are) {
    for (const auto& [failure, count] : broken(GetParam(), kernel_sources(testing::kernels_folder())))
        ADD_FAILURE() << count << " times: " << failure;
}

INSTANTIATE_TEST_SUITE_P(of, mask_chains,
                         ::testing::Values("chain/smsr", "chain/rsmss", "chain/rbsm-silhouette",
                                           "chain/rbsm-filter"),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::ranges::replace_if(
                                 name, [](char c) { return c == '/' || c == '-'; }, '_');
                             return name;
                         });

/// One text of one kernel, and the invariant of a chain that notices when it is another.
struct Broken {
    const char *chain, *file, *from, *to, *invariant;
};
void PrintTo(const Broken& b, std::ostream* out) { *out << b.invariant; }

class invariants : public ::testing::TestWithParam<Broken> {};

TEST_P(invariants, are_told_from_what_keeps_them) {
    const Broken& b = GetParam();
    glsl::Sources sources = kernel_sources(testing::kernels_folder());
    std::string text = read_file(testing::kernels_folder() / b.file);
    const std::size_t at = text.find(b.from);
    ASSERT_NE(at, text.npos);
    sources.overlaid[b.file] = text.replace(at, std::string(b.from).size(), b.to);
    const std::map<std::string, std::size_t> counts = broken(b.chain, sources);
    EXPECT_TRUE(counts.contains(b.invariant));
    for (const auto& [failure, count] : counts) fmt::print("{} times: {}\n", count, failure);
}

constexpr const char* along = "return clamp(position, 0.0, 1.0);";

INSTANTIATE_TEST_SUITE_P(
    of, invariants,
    ::testing::Values(
        Broken{"chain/smsr", "smsr/visibility.glsl", "along_x = revectorize_along(edge.reach.xy, p.x)",
               "along_x = revectorize_along(edge.reach.xy, p.y)", "another value than the parts give"},
        Broken{"chain/smsr", "smsr/number.glsl", "return smsr_decision(edge.sides, edge.type, edge.dominant)",
               "return 3u", "another number than the parts give"},
        Broken{"chain/smsr", "smsr/decision.glsl", "return 8u", "return 2u",
               "another number than the conditions say"},
        Broken{"chain/smsr", "smsr/case_09.glsl", "1.0 - p.y", "0.9 - p.y", "another value transposed"},
        Broken{"chain/smsr", "smsr/decision.glsl", "return sides.x == MINUS ? 11u : 12u",
               "return sides.x == MINUS ? 12u : 11u", "another number transposed"},
        Broken{"chain/smsr", "smsr/visibility.glsl", "return 0.0", "return 1.0", "light in shadow"},
        Broken{"chain/smsr", "smsr/case_12.glsl", "? 0.0", "? 0.5", "neither lit nor shadowed"},
        Broken{"chain/smsr", "smsr/case_12.glsl", "? 0.0", "? 1.5", "out of range"},
        Broken{"chain/smsr", "smsr/case_12.glsl", "? 0.0", "? uintBitsToFloat(0x7fc00000u)", "NaN"},
        Broken{"chain/rsmss", "revectorize/along.glsl", along,
               "return clamp(min(abs(reach.x), abs(reach.y)) % 2 == 1 ? 0.75 * position : position, 0.0, "
               "1.0);",
               "does not go on along the run"},
        Broken{"chain/rbsm-filter", "rbsm/filter/l.glsl", "entering ? distance", "entering ? 0.75 * distance",
               "the opposite mask does not take its light away"},
        Broken{"chain/rbsm-silhouette", "rbsm/silhouette/u.glsl", "return 0.0", "return 1.0",
               "another value than smsr/visibility"},
        Broken{"chain/smsr", "revectorize/along.glsl", along, "return clamp(0.75 * position, 0.0, 1.0);",
               "wrong"}));

TEST(mask_chain, tells_what_a_dispatch_complains_of_and_of_which_input) {
    glsl::Sources sources = kernel_sources(testing::kernels_folder());
    sources.overlaid["smsr/number.glsl"] = "// None.\n#include \"revectorize/lit.glslh\"\n"
                                           "uint smsr_number(ivec2 texel) {\n"
                                           "    if (texel == ivec2(3, 3)) return 0x7fdeadbeu;\n"
                                           "    return lit(texel) ? 0u : 0u;\n}\n";
    const std::vector<Input> inputs = texels();
    const std::vector<std::string> failures =
        chain("chain/smsr").judge(sources, testing::shared_device())(inputs);
    const auto found = std::ranges::find(failures, "never written by smsr/number");
    ASSERT_NE(found, failures.end());
    const Input& input = inputs[static_cast<std::size_t>(found - failures.begin())];
    EXPECT_EQ(input.words[0], 3u);
    EXPECT_EQ(input.words[1], 3u) << "of itself and its images the first";
}

TEST(mask_chain, shrinks_to_three_by_three_texels) {
    glsl::Sources sources = kernel_sources(testing::kernels_folder());
    sources.overlaid["smsr/case_09.glsl"] = "// Off.\nfloat smsr_case_09(vec2 p, float along_x) {\n"
                                            "    return 0.9 - p.y < along_x ? 0.0 : 1.0;\n}\n";
    const Chain& smsr = chain("chain/smsr");
    const Judge judge = smsr.judge(sources, testing::shared_device());
    const std::vector<Input> inputs = texels();
    const std::vector<std::string> failures = judge(inputs);
    const auto found = std::ranges::find_if(failures, [](const std::string& f) { return !f.empty(); });
    ASSERT_NE(found, failures.end());
    const Input shrunk = smsr.shrink(inputs[static_cast<std::size_t>(found - failures.begin())],
                                     [&](std::span<const Input> candidates) {
                                         std::vector<bool> fails;
                                         for (const std::string& failure : judge(candidates))
                                             fails.push_back(failure == *found);
                                         return fails;
                                     });
    EXPECT_LE(shrunk.mask.width, 3);
    EXPECT_LE(shrunk.mask.height, 3);
    EXPECT_EQ(judge(std::span(&shrunk, 1)).front(), *found);
}

} // namespace
} // namespace gnomon::fuzz
