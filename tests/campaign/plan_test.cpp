// Which inputs a campaign runs, and what its processes say to each other.
#include "casegen/catalogue.h"
#include "casegen/fuzz/draw.h"
#include "casegen/fuzz/message.h"
#include "casegen/fuzz/plan.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace gnomon::fuzz {
namespace {

TEST(plan, asks_for_as_much_as_was_asked_for_and_less_than_a_round_more) {
    const std::vector<const Case*> cases = find_cases("smsr");
    for (const std::uint64_t samples : {1ull, 1000ull, 1000000ull, 100000000ull}) {
        const Plan plan = make_plan(cases, samples);
        const std::uint64_t round = std::accumulate(plan.sizes.begin(), plan.sizes.end(), std::uint64_t{0});
        const std::uint64_t all = round * *plan.rounds;
        EXPECT_GE(all, samples);
        EXPECT_LT(all, samples + std::max<std::uint64_t>(round, cases.size() + 1));
    }
    EXPECT_FALSE(make_plan(cases, {}).rounds);
}

TEST(plan, slow_references_get_fewer_inputs_each) {
    const Plan plan = make_plan(find_cases("*a0"), {});
    for (std::size_t i = 0; i < plan.cases.size(); ++i)
        if (plan.cases[i]->reference.truth)
            EXPECT_LT(plan.sizes[i], unit_size(find_case("smsr/case_09")) / 50);
}

TEST(draw, is_the_same_bits_whatever_else_is_drawn_and_another_for_another_seed) {
    const Case& c = find_case("smsr/visibility");
    const auto pool = make_fuzz_pool(5, 3);
    const Sampler sampler(c, 11, pool);
    const Draw one(c, sampler, 11), other(c, sampler, 12);
    std::vector<std::uint32_t> a(4), b(4), d(4);
    std::size_t differ = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const Mask* mask = one(i, {}, a);
        one((i * 7 + 5) % 2000, {}, b); // in between
        EXPECT_EQ(one(i, {}, b), mask);
        EXPECT_EQ(a, b);
        other(i, {}, d);
        differ += a != d ? 1 : 0;
    }
    EXPECT_GT(differ, 100u);
}

// What a seed found on one machine it finds on every other one.
TEST(draw, golden_inputs) {
    const std::map<std::string, std::uint64_t> golden{
        {"smsr/case_09", 0x0c432d5067df0a44},              // floats of 0 to 1
        {"rsmss/case_12", 0x39184c7402be561e},             // and of lists
        {"smsr/visibility", 0x508176568908f4ff},           // a texel of a mask
        {"smsr/decision", 0xfd13c6160aef3395},             // whole numbers and truth values
        {"revectorize/walk", 0x79ee555eec6210f5},          // lists of vectors
        {"integral/elementary/exp", 0xc1909857fbd882be},   // floats of -103 to 88.5
        {"conservative/tight_offset", 0x981690ed2bfe50d8}, // by a generator; a texel that is no whole number
    };
    const auto pool = make_fuzz_pool(5, 3);
    for (const auto& [name, expected] : golden) {
        const Case& c = find_case(name);
        const Sampler sampler(c, 11, pool);
        const Draw draw(c, sampler, 11);
        std::vector<std::uint32_t> words(word_count(c));
        std::vector<worst::Row> worst;
        std::uint64_t state = hash("");
        for (std::uint64_t i = 0; i < 4000; ++i) {
            const Mask* mask = draw(i, worst, words);
            state =
                hash(std::string_view(reinterpret_cast<const char*>(words.data()), words.size() * 4), state);
            if (mask) state = hash(format_mask(*mask, '/'), state);
            if (i % 500 == 0) worst.push_back({words, mask, 0.5, true});
        }
        EXPECT_EQ(state, expected) << fmt::format("{{\"{}\", {:#018x}}},", name, state);
    }
}

TEST(draw, meets_boundaries_random_bits_and_neighbours_of_the_worst) {
    const Case& c = find_case("smsr/case_09");
    const auto pool = make_fuzz_pool(5, 0);
    const Sampler sampler(c, 11, pool);
    const Draw draw(c, sampler, 11);
    const std::vector<std::uint32_t> worst_words{0x3e123456u, 0x3e654321u, 0x3f0fedcbu};
    const std::vector<worst::Row> worst{{worst_words, nullptr, 1, true}};
    std::size_t nan = 0, beyond = 0, near = 0;
    std::vector<std::uint32_t> words(3);
    for (std::uint64_t i = 0; i < 4000; ++i) {
        draw(i, worst, words);
        int same = 0;
        for (std::size_t k = 0; k < words.size(); ++k) {
            same += words[k] == worst_words[k] ? 1 : 0;
            const float value = std::bit_cast<float>(words[k]);
            nan += std::isnan(value) ? 1 : 0;
            beyond += std::isfinite(value) && std::abs(value) > 10 ? 1 : 0;
        }
        near += same > 0 ? 1 : 0;
    }
    EXPECT_GT(nan, 20u);
    EXPECT_GT(beyond, 100u);
    // A quarter of the blocks begin with a change of the worst, most of these with two of its three words
    // left. Of the seven others of a block, which draw one, two or three words anew (a word twice, too), 1,
    // 7/9 and 15/27 keep one of the two; of a beginning with one word left 2/3, 4/9 and 8/27: 4000/4 (1 + 7 *
    // (0.47 ... 0.78)) / 8.
    EXPECT_GT(near, 1000 * (1 + 7 * 0.47) / 8);
    EXPECT_LT(near, 1000 * (1 + 7 * 0.78) / 8);
}

TEST(fuzz_pool, holds_masks_of_many_sizes_and_tiny_ones) {
    std::set<int> sides;
    for (std::uint64_t epoch = 0; epoch < 12; ++epoch) {
        const auto pool = make_fuzz_pool(1, epoch);
        EXPECT_GT(pool->entries.size(), 100u);
        sides.insert(pool->side);
        EXPECT_EQ(make_fuzz_pool(1, epoch)->masks, pool->masks);
        EXPECT_NE(make_fuzz_pool(2, epoch)->masks, pool->masks);
    }
    EXPECT_TRUE(sides.contains(6) && sides.contains(8) && sides.contains(48));
}

TEST(message, requests_and_replies_arrive_as_they_were_sent) {
    const Request request{3, 1ull << 60, 77, false, 5, {"wrong", "NaN"}, Part{1, 2, 3}, true};
    const Request read = parse_request(format_request(request));
    EXPECT_EQ(read.kernel, request.kernel);
    EXPECT_EQ(read.round, request.round);
    EXPECT_EQ(read.evaluations, request.evaluations);
    EXPECT_EQ(read.shrink, request.shrink);
    EXPECT_EQ(read.batches, request.batches);
    EXPECT_EQ(read.known, request.known);
    ASSERT_TRUE(read.part);
    EXPECT_EQ(read.part->end, 3u);
    EXPECT_TRUE(read.tell_inputs);

    Reply reply;
    reply.result.emplace();
    reply.result->evaluations = 9;
    reply.result->worst_error = 0.1;
    reply.result->worst = {{1, 0xffffffffu}, Mask(2, 1, false, Outside::lit)};
    Found found;
    found.regression.kernel = "smsr/case_09";
    found.regression.failure = "wrong";
    found.regression.input.words = {1, 2, 3};
    found.on_file = true;
    reply.result->found.push_back(std::move(found));
    const Reply again = parse_reply(format_reply(reply));
    ASSERT_TRUE(again.result);
    EXPECT_EQ(again.result->evaluations, 9u);
    EXPECT_EQ(again.result->worst_error, 0.1);
    EXPECT_EQ(again.result->worst.words, reply.result->worst.words);
    EXPECT_EQ(again.result->worst.mask, reply.result->worst.mask);
    ASSERT_EQ(again.result->found.size(), 1u);
    EXPECT_EQ(again.result->found[0].regression.input.words, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_TRUE(again.result->found[0].on_file);
    EXPECT_TRUE(again.timeout.empty());
    EXPECT_EQ(parse_reply(format_reply({{}, "late", {}, {}})).timeout, "late");
    // A compiler may say anything.
    EXPECT_FALSE(parse_reply(format_reply({{}, {}, "\xff\xfe", {}})).compile_error.empty());
}

TEST(message, damaged_ones_are_errors) {
    for (const char* text : {"", "{", "null", "[1]", R"({"kernel": 1})", R"({"result": 7})",
                             R"({"result": {"evaluations": -1.5, "found": 3}})"}) {
        EXPECT_THROW(parse_request(text), Error) << text;
        if (std::string_view(text) != R"({"kernel": 1})") EXPECT_THROW(parse_reply(text), Error) << text;
    }
    const auto reply = [](const char* kernel, const char* words) {
        return fmt::format(R"({{"result": {{"evaluations": 1, "found": [{{"kernel": "{}", "failure": "wrong",
            "input": {{"words": {}}}, "got": "", "want": "", "allowed": "", "found": "", "on_file": false}}]}}}})",
                           kernel, words);
    };
    EXPECT_EQ(parse_reply(reply("smsr/case_09", "[1, 2, 3]")).result->found.size(), 1u);
    EXPECT_EQ(parse_reply(reply("smsr/case_09", "[]")).result->found.size(), 1u); // not seen again
    EXPECT_THROW(parse_reply(reply("smsr/case_09", "[1, 2]")), Error);
    EXPECT_THROW(parse_reply(reply("smsr/visibility", "[1, 2, 3, 4]")), Error); // its mask is missing
    EXPECT_THROW(parse_reply(reply("smsr/case_99", "[1, 2, 3]")), Error);
}

} // namespace
} // namespace gnomon::fuzz
