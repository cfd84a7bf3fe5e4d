#include "casegen/mask_families.h"

#include "runtime/files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <thread>

namespace gnomon {
namespace {

std::uint64_t hash_of(const std::vector<NamedMask>& corpus, const std::string& family) {
    std::uint64_t state = hash(family);
    for (const NamedMask& named : corpus)
        if (named.name.starts_with(family + "/")) state = hash(format_mask(named.mask, '/'), state);
    return state;
}

// The same masks on every machine, compiler and thread: a finding is replayed from its seed.
TEST(mask_families, golden_masks) {
    const std::map<std::string, std::uint64_t> golden{
        {"half-planes", 0x1d06f2312181b079},   {"circles", 0xc5234341741a1e58},
        {"thin-strips", 0x58015dec03705f45},   {"segments", 0x1a7af55c105837da},
        {"rectangles", 0xb2c25abd33c9c23a},    {"shapes", 0x608310982c3c2152},
        {"combs", 0x66f7aae6e87eb6ee},         {"blobs", 0x35444957b84608ae},
        {"mazes", 0xc8865c9253f5cc0e},         {"noise", 0xb0bd56226f8270bc},
        {"single-texels", 0xf8aabcc04e910aa6},
    };
    const std::vector<NamedMask> corpus = mask_corpus(1, 8, 32);
    for (const MaskFamily& family : mask_families()) {
        const std::uint64_t found = hash_of(corpus, family.name);
        EXPECT_TRUE(golden.contains(family.name) && golden.at(family.name) == found)
            << fmt::format("{{\"{}\", {:#018x}}},", family.name, found);
    }
    EXPECT_EQ(golden.size(), mask_families().size());
}

TEST(mask_families, do_not_depend_on_the_thread) {
    const std::vector<NamedMask> here = mask_corpus(9, 3, 24);
    std::vector<NamedMask> there[2];
    {
        std::jthread first([&] { there[0] = mask_corpus(9, 3, 24); });
        std::jthread second([&] { there[1] = mask_corpus(9, 3, 24); });
    }
    for (const std::vector<NamedMask>& corpus : there) {
        ASSERT_EQ(corpus.size(), here.size());
        for (std::size_t i = 0; i < here.size(); ++i) {
            EXPECT_EQ(corpus[i].name, here[i].name);
            EXPECT_EQ(corpus[i].mask, here[i].mask) << here[i].name;
        }
    }
}

TEST(mask_families, every_family_makes_light_and_shadow) {
    for (const MaskFamily& family : mask_families()) {
        int mixed = 0;
        for (std::uint64_t member = 0; member < 50; ++member) {
            Random random(4, member);
            const Mask mask = family.make(random, 32);
            ASSERT_EQ(mask.width, 32) << family.name;
            ASSERT_EQ(mask.height, 32) << family.name;
            const auto lit = std::ranges::count(mask.texels, 1);
            if (lit > 0 && lit < 32 * 32) ++mixed;
        }
        EXPECT_GE(mixed, 40) << family.name;
    }
}

TEST(mask_families, every_draw_is_another_member) {
    for (const MaskFamily& family : mask_families()) {
        std::vector<std::string> members;
        for (std::uint64_t member = 0; member < 20; ++member) {
            Random random(5, member);
            members.push_back(format_mask(family.make(random, 32), '/'));
        }
        std::ranges::sort(members);
        const auto distinct = std::unique(members.begin(), members.end());
        EXPECT_LE(members.end() - distinct, 4) << family.name;
    }
}

TEST(mask_families, corpus_has_every_surround) {
    std::map<Outside, int> surrounds;
    for (const NamedMask& named : mask_corpus(1, 3, 8)) ++surrounds[named.mask.outside];
    EXPECT_EQ(surrounds.size(), 3u);
}

TEST(mask_families, work_at_other_sizes) {
    for (const int size : {8, 9, 64})
        for (const NamedMask& named : mask_corpus(3, 4, size)) {
            ASSERT_EQ(named.mask.width, size) << named.name;
            ASSERT_EQ(named.mask.texels.size(),
                      static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
        }
}

TEST(mask_families, half_plane_is_decided_at_texel_centres) {
    EXPECT_EQ(format_mask(half_plane(3, 0, 1, 1.5), '/'), "###/.../..."); // the centre on the line is lit
    EXPECT_EQ(format_mask(half_plane(3, 0, 1, 1.51), '/'), "###/###/...");
    EXPECT_EQ(format_mask(half_plane(3, -1, 0, -1.5), '/'), "..#/..#/..#");
}

} // namespace
} // namespace gnomon
