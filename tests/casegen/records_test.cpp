// How a dispatch's inputs lie in memory.
#include "casegen/catalogue.h"
#include "casegen/standalone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace gnomon {
namespace {

TEST(records, a_block_lies_as_its_rows_do_one_by_one) {
    const Mask small(3, 2, true, Outside::shadow), large(40, 30, false, Outside::clamp);
    for (const char* name : {"smsr/visibility", "smsr/case_09"}) {
        const Case& c = find_case(name);
        const std::size_t width = word_count(c);
        std::vector<std::uint32_t> all(5 * width);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(1000 + i);
        const auto row = [&](std::size_t i) { return std::span(all).subspan(i * width, width); };
        const std::array masks{&small, &large, &large, &large, &small};

        Records single(c), block(c);
        for (std::size_t i = 0; i < masks.size(); ++i) single.add(row(i), masks[i]);
        block.add(row(0), masks[0]);
        block.add_block(3, [&](std::span<std::uint32_t> rows) {
            EXPECT_EQ(rows.size(), 3 * block.stride());
            for (std::size_t n = 0; n < 3; ++n)
                std::ranges::copy(row(1 + n), rows.subspan(n * block.stride()).begin());
            return &large;
        });
        block.add(row(4), masks[4]);

        ASSERT_EQ(block.size(), single.size());
        EXPECT_TRUE(std::ranges::equal(block.words(), single.words())) << name;
        EXPECT_TRUE(std::ranges::equal(block.masks(), single.masks())) << name;
        for (std::size_t i = 0; i < block.size(); ++i) {
            EXPECT_TRUE(std::ranges::equal(block.input(i), row(i))) << name << " record " << i;
            EXPECT_EQ(block.mask(i), masks[i]) << name << " record " << i;
        }
    }
}

} // namespace
} // namespace gnomon
