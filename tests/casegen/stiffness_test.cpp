// The generators of the integrals' inputs: what all of them promise, and that no locus is missing.
#include "casegen/stiffness.h"

#include "casegen/catalogue.h"
#include "casegen/sampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace gnomon::stiffness {
namespace {

using ::testing::Contains;
using ::testing::IsSupersetOf;

using Drawn = std::array<double, 16>;

/// The kernels whose domain is all that the generator is meant for.
constexpr std::array kernels{
    "integral/exact_theta/a0", "integral/exact_theta/a1", "integral/exact_theta/b0",
    "integral/exact_theta/a",  "integral/exact_theta/b",  "integral/cell/from_boundary",
    "integral/sinc/c1",        "integral/sinc/c2",        "integral/sinc/c3",
    "integral/fit/r0",         "integral/interval/exact", "integral/interval/versines",
    "integral/mix/radiance",
};

Drawn draw(const Generator& generator, std::uint64_t seed, const Place* place = nullptr) {
    Random random(seed);
    Drawn numbers{};
    generator.draw(random, numbers);
    if (place) generator.loci[place->locus].place(random, locus_distance(place->step), numbers);
    return numbers;
}

std::set<std::string> names(const Generator& generator) {
    std::set<std::string> result;
    for (const Locus& locus : generator.loci) result.insert(locus.name);
    return result;
}

TEST(stiffness, ordinary_inputs_lie_in_the_domain) {
    for (const char* name : kernels) {
        const Case& c = find_case(name);
        std::vector<std::uint32_t> words(word_count(c));
        int inside = 0;
        for (std::uint64_t i = 0; i < 4000; ++i) {
            Random random(17, i);
            draw_generated(c, random, {}, words);
            inside += in_domain(c, arguments(c, words, nullptr)) ? 1 : 0;
        }
        EXPECT_GT(inside, 3800) << name;
    }
}

TEST(stiffness, no_locus_lies_outside_the_domain_at_every_distance) {
    for (const char* name : kernels) {
        const Case& c = find_case(name);
        std::vector<std::uint32_t> words(word_count(c));
        for (std::size_t locus = 0; locus < c.generator->loci.size(); ++locus) {
            int inside = 0;
            for (int step = 0; step < locus_distances; ++step)
                for (std::uint64_t i = 0; i < 20; ++i) {
                    Random random(18, i);
                    draw_generated(c, random, Place{locus, step}, words);
                    inside += in_domain(c, arguments(c, words, nullptr)) ? 1 : 0;
                }
            EXPECT_GT(inside, 20) << name << ", " << c.generator->loci[locus].name;
        }
    }
}

TEST(stiffness, every_number_drawn_is_finite_and_in_its_parameter_s_range) {
    for (const char* name : kernels) {
        const Case& c = find_case(name);
        std::vector<std::uint32_t> words(word_count(c));
        std::size_t inside = 0, drawn = 0;
        for (std::size_t locus = 0; locus < c.generator->loci.size(); ++locus)
            for (int step = 0; step < locus_distances; ++step)
                for (std::uint64_t i = 0; i < 10; ++i, ++drawn) {
                    Random random(19, i);
                    draw_generated(c, random, Place{locus, step}, words);
                    const Arguments with = arguments(c, words, nullptr);
                    for (std::size_t w = 0; w < words.size(); ++w)
                        ASSERT_TRUE(std::isfinite(with.numbers[w]))
                            << name << ", " << c.generator->loci[locus].name << ", number " << w;
                    inside += in_domain(c, with) ? 1u : 0u;
                }
        EXPECT_GT(inside, drawn * 8 / 10) << name;
    }
}

TEST(stiffness, one_seed_gives_the_same_bits_and_another_one_others) {
    for (const char* name : kernels) {
        const Generator& generator = *find_case(name).generator;
        const Generator& again = *find_case(name).generator;
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            EXPECT_EQ(draw(generator, seed), draw(again, seed)) << name;
            EXPECT_NE(draw(generator, seed), draw(generator, seed + 1)) << name;
            const Place place{seed % generator.loci.size(), static_cast<int>(seed) % locus_distances};
            EXPECT_EQ(draw(generator, seed, &place), draw(again, seed, &place)) << name;
        }
    }
}

// Truths are kept by their inputs: the cells of A0, B0 and A are the same ones.
TEST(stiffness, cells_are_the_same_whatever_follows_them) {
    const auto plain = boundary_cells(Trailing::nothing);
    for (const Trailing trailing :
         {Trailing::angle, Trailing::two_angles, Trailing::vector, Trailing::two_vectors}) {
        const auto longer = boundary_cells(trailing);
        EXPECT_EQ(longer->name, plain->name); // which is the seed
        ASSERT_GE(longer->loci.size(), plain->loci.size());
        for (std::size_t locus = 0; locus < plain->loci.size(); ++locus) {
            EXPECT_EQ(longer->loci[locus].name, plain->loci[locus].name);
            const Place place{locus, static_cast<int>(locus) % locus_distances};
            for (std::uint64_t seed = 0; seed < 20; ++seed)
                for (const Place* at : {static_cast<const Place*>(nullptr), &place}) {
                    Drawn cell = draw(*plain, seed, at), with = draw(*longer, seed, at);
                    EXPECT_TRUE(std::equal(cell.begin(), cell.begin() + 5, with.begin()));
                    EXPECT_NE(with[5], 0) << "nothing follows";
                }
        }
    }
}

TEST(stiffness, cells_have_every_locus_of_their_formulas) {
    const std::set<std::string> cells = names(*boundary_cells(Trailing::nothing));
    for (const char* k : {"0", "1/3", "1/2", "2/3", "1", "2", "-1/3", "-1/2", "-2/3", "-1", "-2"})
        EXPECT_THAT(cells, Contains(std::string("k = ") + k));
    EXPECT_THAT(cells, IsSupersetOf({"phi1 - phi0 = 0", "phi1 - phi0 = 2 pi", "theta = theta0",
                                     "theta = theta0 at one end", "theta = 0", "theta = pi", "1/k = 0",
                                     "1/phi = 0", "boundary below theta0"}));
    EXPECT_THAT(names(*boundary_cells(Trailing::vector)), Contains("n on the pole"));
    EXPECT_THAT(names(*boundary_cells(Trailing::two_vectors)),
                IsSupersetOf({"n on the pole", "p on the pole"}));
}

TEST(stiffness, waves_have_every_locus_of_their_formulas) {
    EXPECT_THAT(names(*waves(2, true)),
                IsSupersetOf({"s = 0", "s = 1", "s = -1", "s = 2", "s = -2", "phi1 - phi0 = 0",
                              "phi1 - phi0 = 2 pi", "1/phi = 0", "1/s = 0"}));
    EXPECT_THAT(names(*waves(1, false)),
                IsSupersetOf({"phi1 - phi0 = 0", "phi1 - phi0 = 2 pi", "1/phi = 0"}));
}

TEST(stiffness, lobes_and_lit_cells_have_every_locus_of_their_formulas) {
    for (const auto& generator : {lobes(), lobes_of_ends()})
        EXPECT_THAT(names(*generator),
                    IsSupersetOf({"lambda q = 0", "width = 0", "1 / lambda q = 0", "peak",
                                  "far from the peak", "mu = 0", "the whole sphere", "a = b"}));
    for (const auto& generator : {cells_and_axes(), lit_cells()})
        EXPECT_THAT(
            names(*generator),
            IsSupersetOf({"axis inside", "axis on a theta edge", "axis on a phi edge", "axis on a corner",
                          "axis opposite", "axis on the pole", "axis on the equator", "half_width = 0",
                          "half_width = pi", "size = 0", "theta = 0", "theta = pi"}));
    EXPECT_THAT(names(*lit_cells()),
                IsSupersetOf({"rise = 0", "1 / boundary's slope = 0", "1/phi = 0", "boundary below theta0",
                              "lambda q = 0", "1 / lambda q = 0", "mu = 0", "normal on the pole"}));
}

/// Which decades of λq are met, and which signs of μ (−1, 0, 1).
struct Reached {
    std::set<int> decades, signs;
};
Reached reached(const Generator& generator, const std::function<double(const Drawn&)>& m, std::size_t mu) {
    Reached result;
    const auto see = [&](const Drawn& n) {
        if (m(n) > 0) result.decades.insert(static_cast<int>(std::floor(std::log10(m(n)))));
        result.signs.insert(n[mu] > 0 ? 1 : n[mu] < 0 ? -1 : 0);
    };
    for (std::uint64_t seed = 0; seed < 200; ++seed) see(draw(generator, seed));
    for (std::size_t locus = 0; locus < generator.loci.size(); ++locus)
        for (int step = 0; step < locus_distances; ++step)
            for (std::uint64_t i = 0; i < 16; ++i) {
                const Place place{locus, step};
                see(draw(generator, i, &place));
            }
    return result;
}

TEST(stiffness, lobes_reach_from_flat_ones_to_the_sharpest_and_have_either_sign_or_none) {
    const auto by_versines = [](const Drawn& n) { return 0.5 * n[2] * std::abs(n[0] - n[1]); };
    const auto in_cells = [](const Drawn& n) { return 0.5 * n[11] * std::abs(n[13] - n[14]); };
    for (const Reached& result :
         {reached(*lobes(), by_versines, 3), reached(*lobes_of_ends(), by_versines, 3),
          reached(*lit_cells(), in_cells, 12)}) {
        for (int decade = -8; decade < 6; ++decade) EXPECT_THAT(result.decades, Contains(decade));
        EXPECT_THAT(result.signs, ::testing::ElementsAre(-1, 0, 1));
    }
}

} // namespace
} // namespace gnomon::stiffness
