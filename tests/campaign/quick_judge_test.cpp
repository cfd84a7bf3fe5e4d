// What the quick judge lets pass unseen judge() would pass too.
#include "casegen/fuzz/quick_judge.h"

#include "casegen/catalogue.h"
#include "casegen/compare.h"
#include "casegen/fuzz/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>

namespace gnomon::fuzz {
namespace {

/// The reference's own results, one in four of them moved by some bits or anything at all.
std::vector<std::uint32_t> results_of(const Case& c, const Records& records) {
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    std::vector<std::uint32_t> words;
    Random random(7);
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Arguments with = arguments(c, records.input(i), records.mask(i));
        const Numbers want = in_domain(c, with) ? c.reference.call(with) : Numbers{};
        for (std::size_t k = 0; k < components; ++k) {
            std::uint32_t word = narrow(c.reference.result.scalar, want[k]);
            const std::uint32_t choice = random.below(16);
            if (choice == 0) word = static_cast<std::uint32_t>(random.bits());
            if (choice == 1) word += random.below(5) - 2;
            if (choice == 2) word ^= 1u << random.below(32);
            if (choice == 3) word = 0x7fc00000u;
            words.push_back(word);
        }
    }
    return words;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(quick_judge, looks_at_every_result_that_does_not_pass_and_at_the_largest_errors) {
    const auto pool = make_fuzz_pool(3, 0);
    std::size_t failing = 0, unseen = 0;
    for (const Case* c : find_cases("")) {
        if (c->reference.truth || !c->fails.empty()) continue;
        const Sampler sampler(*c, 5, pool);
        const Draw draw(*c, sampler, 5);
        Records records(*c);
        for (std::uint64_t i = 0; i < 1500; ++i)
            records.add_with([&](std::span<std::uint32_t> words) { return draw(i, {}, words); });
        const QuickJudge quick(*c);
        const std::vector<std::uint32_t> results = results_of(*c, records);
        const auto components = static_cast<std::size_t>(c->reference.result.components);
        const std::vector<std::size_t> looked = quick.to_look_at(records, results);
        EXPECT_TRUE(std::ranges::is_sorted(looked));
        const std::set<std::size_t> seen(looked.begin(), looked.end());
        EXPECT_EQ(seen.size(), looked.size()) << c->name;
        double largest = 0, largest_seen = 0;
        for (std::size_t i = 0; i < records.size(); ++i) {
            const Arguments with = arguments(*c, records.input(i), records.mask(i));
            const QuickJudge::Read read = quick.read(records.input(i), records.mask(i));
            ASSERT_TRUE(std::ranges::equal(std::span(read.arguments.numbers).first(word_count(*c)),
                                           std::span(with.numbers).first(word_count(*c)), same_bits))
                << c->name;
            ASSERT_EQ(read.arguments.mask, with.mask) << c->name;
            ASSERT_EQ(read.inside, in_domain(*c, with)) << c->name;
            const Agreement agreement =
                judge(*c, with, std::span(results).subspan(i * components, components));
            failing += agreement.pass ? 0 : 1;
            if (!agreement.pass) EXPECT_TRUE(seen.contains(i)) << c->name << " record " << i;
            if (!agreement.pass) continue;
            largest = std::max(largest, agreement.error);
            if (seen.contains(i)) largest_seen = std::max(largest_seen, agreement.error);
            unseen += seen.contains(i) ? 0 : 1;
        }
        EXPECT_EQ(largest, largest_seen) << c->name;
    }
    EXPECT_GT(failing, 10000u);
    EXPECT_GT(unseen, 50000u) << "it lets nothing pass";
}

TEST(draw, gives_a_block_as_it_gives_its_inputs_one_by_one) {
    for (const char* name : {"smsr/visibility", "rsmss/case_12", "integral/elementary/sin"}) {
        const Case& c = find_case(name);
        const auto pool = make_fuzz_pool(5, 3);
        const Sampler sampler(c, 11, pool);
        const Draw draw(c, sampler, 11);
        const std::size_t width = word_count(c), stride = width + 3;
        std::vector<std::uint32_t> rows(draw.block_size() * stride);
        for (std::uint64_t number = 0; number < 50; ++number) {
            const std::uint64_t begin = number * draw.block_size();
            std::ranges::fill(rows, 0xdeadbeefu);
            const Mask* mask = draw.draw_block(begin, begin + draw.block_size(), {}, rows, stride);
            std::vector<std::uint32_t> one(width);
            for (std::size_t i = 0; i < draw.block_size(); ++i) {
                EXPECT_EQ(draw(begin + i, {}, one), mask);
                const std::span row = std::span(rows).subspan(i * stride, stride);
                EXPECT_TRUE(std::ranges::equal(row.first(width), one));
                EXPECT_EQ(std::ranges::count(row.subspan(width), 0xdeadbeefu), 3);
            }
        }
    }
}

} // namespace
} // namespace gnomon::fuzz
