#include "casegen/sampling.h"

#include "casegen/catalogue.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace gnomon {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

std::shared_ptr<const EdgePool> pool() {
    static const auto made = std::make_shared<const EdgePool>(make_edge_pool(default_seed("masks")));
    return made;
}

std::uint64_t hash_of(const Sampler::Sample& sample, std::uint64_t state) {
    for (const std::uint32_t word : sample.words)
        state = hash(std::string_view(reinterpret_cast<const char*>(&word), sizeof word), state);
    return sample.mask ? hash(format_mask(*sample.mask, '/'), state) : state;
}

bool same(const Sampler::Sample& a, const Sampler::Sample& b) {
    return a.words == b.words && (a.mask == nullptr) == (b.mask == nullptr) &&
           (!a.mask || *a.mask == *b.mask);
}

TEST(sampling, a_sample_does_not_depend_on_what_else_is_drawn) {
    for (const Case* c : find_cases("")) {
        const Sampler forwards(*c, 5, pool()), backwards(*c, 5, pool());
        const std::size_t count = forwards.fixed_count() + 100;
        std::vector<Sampler::Sample> drawn;
        for (std::size_t i = 0; i < count; ++i) drawn.push_back(forwards.draw(i));
        for (std::size_t i = count; i-- > 0;)
            ASSERT_TRUE(same(backwards.draw(i), drawn[i])) << c->name << " sample " << i;
    }
}

TEST(sampling, seeds_give_different_samples) {
    const Case& c = find_case("smsr/case_09");
    const Sampler one(c, 1, pool()), two(c, 2, pool());
    int different = 0;
    for (std::size_t i = one.fixed_count(); i < one.fixed_count() + 100; ++i)
        different += one.draw(i).words != two.draw(i).words ? 1 : 0;
    EXPECT_GT(different, 90);
}

// A seed in a report must lead to the same inputs on every machine.
TEST(sampling, golden_samples) {
    const std::map<std::string, std::uint64_t> golden{
        {"smsr/case_08", 0x34e5bdd6682e3e3f},
        {"smsr/visibility", 0x1f1ea95fe1d834fb},
        {"smsr/decision", 0x964c1e21347ab96b},
        {"revectorize/along", 0x70178df4b6ed5915},
        {"revectorize/shadow_test", 0x3bea6b00fa5eef32},
        {"revectorize/walk", 0x93841e82c1876422},
        {"integral/elementary/exp", 0xdf8cbd7aa468b8f4},             // -103 to 88.5
        {"integral/elementary/missing_of_sine", 0x8662e8b9457c429c}, // to 0.8, which is no float
    };
    for (const auto& [name, expected] : golden) {
        const Sampler sampler(find_case(name), 1, pool());
        std::uint64_t state = hash("");
        for (std::size_t i = 0; i < sampler.fixed_count() + 1000; ++i)
            state = hash_of(sampler.draw(i), state);
        EXPECT_EQ(state, expected) << fmt::format("{{\"{}\", {:#018x}}},", name, state);
    }
}

TEST(sampling, samples_have_the_case_s_words_and_masks) {
    for (const Case* c : find_cases("")) {
        const Sampler sampler(*c, 1, pool());
        for (std::size_t i = 0; i < sampler.fixed_count() + 50; ++i) {
            const Sampler::Sample sample = sampler.draw(i);
            ASSERT_EQ(sample.words.size(), word_count(*c)) << c->name;
            ASSERT_EQ(sample.mask != nullptr, c->reference.takes_mask) << c->name;
        }
    }
}

TEST(sampling, every_float_input_meets_every_hostile_value) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const Case* c : find_cases("")) {
        const Sampler sampler(*c, 1, pool());
        std::vector<std::set<std::uint32_t>> seen(word_count(*c));
        for (std::size_t i = 0; i < sampler.fixed_count(); ++i) {
            const Sampler::Sample sample = sampler.draw(i);
            for (std::size_t w = 0; w < seen.size(); ++w) seen[w].insert(sample.words[w]);
        }
        std::size_t word = 0;
        for (std::size_t p = 0; p < c->parameters.size(); ++p)
            for (int k = 0; k < c->reference.parameters[p].components; ++k, ++word) {
                if (c->reference.parameters[p].scalar != Scalar::float32) continue;
                const auto lower = static_cast<float>(c->parameters[p].domain.lower);
                const auto upper = static_cast<float>(c->parameters[p].domain.upper);
                for (const float value :
                     {0.0f, -0.0f, FLT_TRUE_MIN, FLT_MIN, FLT_MAX, -FLT_MAX, infinity, -infinity, lower,
                      upper, std::nextafter(lower, -infinity), std::nextafter(upper, infinity)})
                    EXPECT_TRUE(seen[word].contains(std::bit_cast<std::uint32_t>(value)))
                        << c->name << " " << c->parameters[p].name << " never is " << value;
                const bool has_nan = std::ranges::any_of(
                    seen[word], [](std::uint32_t w) { return std::isnan(std::bit_cast<float>(w)); });
                EXPECT_TRUE(has_nan) << c->name << " " << c->parameters[p].name << " never is NaN";
            }
    }
}

TEST(sampling, most_samples_are_in_the_domain) {
    for (const Case* c : find_cases("")) {
        const Sampler sampler(*c, 1, pool());
        int inside = 0;
        for (std::size_t i = 0; i < 1000; ++i) {
            const Sampler::Sample sample = sampler.draw(sampler.fixed_count() + i);
            inside += in_domain(*c, arguments(*c, sample.words, sample.mask)) ? 1 : 0;
        }
        // A form that is good on part of its quantity's domain has fewer: the inputs are the quantity's.
        EXPECT_GT(inside, c->quantity.empty() ? 300 : 10) << c->name;
    }
}

TEST(sampling, half_of_the_random_samples_come_from_edges_that_lead_to_the_case) {
    const Case& c = find_case("smsr/case_04"); // sides and position depend on each other: a mask shows
    const Sampler sampler(c, 1, pool());
    std::set<std::uint32_t> positions;
    for (std::size_t i = 0; i < 400; ++i) positions.insert(sampler.draw(sampler.fixed_count() + i).words[2]);
    EXPECT_GT(positions.size(), 100u);

    const Case& number = find_case("smsr/number");
    const Sampler texels(number, 1, pool());
    std::map<double, int> cases;
    for (std::size_t i = 0; i < 4000; ++i) {
        const Sampler::Sample sample = texels.draw(texels.fixed_count() + i);
        ++cases[number.reference.call(arguments(number, sample.words, sample.mask))[0]];
    }
    for (int n = 0; n <= 12; ++n) EXPECT_GT(cases[n], 0) << "case " << n << " is never drawn";
}

TEST(sampling, every_case_occurs_in_the_edge_pool) {
    std::map<unsigned, int> found;
    for (const EdgePool::Entry& entry : pool()->entries) {
        if (!pool()->masks[entry.mask].lit(entry.texel.x, entry.texel.y)) continue;
        for (const Case* c : find_cases("smsr/case_*")) found[c->number] += applies(*c, entry.edge()) ? 1 : 0;
    }
    for (unsigned number = 1; number <= 12; ++number) EXPECT_GE(found[number], 10) << "case " << number;
}

TEST(sampling, pool_entries_are_edges_of_their_masks) {
    std::size_t checked = 0;
    for (const EdgePool::Entry& entry : pool()->entries) {
        const reference::Edge edge = reference::edge(pool()->masks[entry.mask], glm::ivec2(entry.texel));
        ASSERT_NE(edge.sides, glm::uvec2(0));
        ASSERT_EQ(edge.reach, entry.edge().reach);
        if (++checked == 2000) break;
    }
    EXPECT_EQ(checked, 2000u);
}

TEST(sampling, pins_come_first) {
    const TemporaryFolder folder;
    const auto pins =
        folder.write("p.csv", "# found once\np_x,p_y,along_x\n0.125,0x1p-2,0.375\nnan,-0,inf\n");
    const Case& c = find_case("smsr/case_09");
    const Sampler without(c, 1, pool()), with(c, 1, pool(), pins);
    EXPECT_EQ(with.fixed_count(), without.fixed_count() + 2);
    EXPECT_EQ(with.draw(0).words,
              (std::vector{std::bit_cast<std::uint32_t>(0.125f), std::bit_cast<std::uint32_t>(0.25f),
                           std::bit_cast<std::uint32_t>(0.375f)}));
    EXPECT_EQ(with.draw(1).words[1], 0x80000000u);
    EXPECT_EQ(with.draw(2).words, without.draw(0).words); // then the hostile ones
}

TEST(sampling, pins_bring_their_masks) {
    const TemporaryFolder folder;
    const auto pins = folder.write("p.csv", "mask,outside,texel_x,texel_y\n##/.#,shadow,0,1\n");
    const Sampler sampler(find_case("smsr/number"), 1, pool(), pins);
    const Sampler::Sample sample = sampler.draw(0);
    ASSERT_NE(sample.mask, nullptr);
    EXPECT_EQ(format_mask(*sample.mask, '/'), "##/.#");
    EXPECT_EQ(sample.mask->outside, Outside::shadow);
}

TEST(sampling, malformed_pins_are_an_error_and_missing_ones_are_none) {
    const TemporaryFolder folder;
    const Case& c = find_case("smsr/case_09");
    const auto error = [&](const char* text) {
        const auto pins = folder.write("bad.csv", text);
        return error_of([&] { Sampler(c, 1, pool(), pins); });
    };
    EXPECT_THAT(error("p_x,p_y\n0,0\n"), AllOf(HasSubstr("bad.csv"), HasSubstr("along_x")));
    EXPECT_THAT(error("p_x,p_y,along_x\n0,0,x\n"), HasSubstr("bad.csv: row 1, column along_x"));
    EXPECT_THAT(error(""), HasSubstr("bad.csv"));
    EXPECT_EQ(Sampler(c, 1, pool(), folder.path() / "none.csv").fixed_count(),
              Sampler(c, 1, pool()).fixed_count());
}

TEST(sampling, default_seed_is_the_name_s_hash) {
    EXPECT_EQ(default_seed("smsr/case_09"), hash("smsr/case_09"));
    EXPECT_NE(default_seed("smsr/case_09"), default_seed("smsr/case_10"));
    EXPECT_EQ(hash("a"), 0xaf63dc4c8601ec8cull); // FNV-1a's published test vector
}

} // namespace
} // namespace gnomon
