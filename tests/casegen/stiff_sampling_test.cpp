// Where the sampler puts the inputs that lie on and near loci.
#include "casegen/sampling.h"

#include "casegen/catalogue.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <map>

namespace gnomon {
namespace {

std::shared_ptr<const EdgePool> pool() {
    static const auto made = std::make_shared<const EdgePool>(make_edge_pool(default_seed("masks")));
    return made;
}

constexpr const char* names[] = {"integral/exact_theta/a1", "integral/sinc/c4", "integral/fit/r0",
                                 "integral/interval/exact", "integral/mix/radiance"};

TEST(stiff_samples, every_locus_has_every_distance_as_often) {
    for (const char* name : names) {
        const Case& c = find_case(name);
        const Sampler sampler(c, 1, pool());
        EXPECT_EQ(sampler.stiff_count(), c.generator->loci.size() * locus_distances * Sampler::stiff_repeats);
        EXPECT_EQ(sampler.first_stiff() + sampler.stiff_count(), sampler.fixed_count());
        std::map<std::pair<std::size_t, int>, std::size_t> found;
        for (std::size_t i = 0; i < sampler.fixed_count() + 1000; ++i) {
            const std::optional<Place> place = sampler.place(i);
            const bool is_stiff = i >= sampler.first_stiff() && i < sampler.fixed_count();
            ASSERT_EQ(place.has_value(), is_stiff) << name << " sample " << i;
            if (place) ++found[{place->locus, place->step}];
        }
        EXPECT_EQ(found.size(), c.generator->loci.size() * locus_distances) << name;
        for (const auto& [at, count] : found) EXPECT_EQ(count, Sampler::stiff_repeats) << name;
        EXPECT_EQ(found.rbegin()->first.first, c.generator->loci.size() - 1);
    }
}

TEST(stiff_samples, a_place_leads_to_the_sample) {
    for (const char* name : names) {
        const Case& c = find_case(name);
        const Sampler sampler(c, 5, pool());
        for (std::size_t i = sampler.first_stiff(); i < sampler.fixed_count(); i += 11) {
            Random random(5, i - sampler.first_stiff());
            std::vector<std::uint32_t> words(word_count(c));
            draw_generated(c, random, sampler.place(i), words);
            EXPECT_EQ(sampler.draw(i).words, words) << name << " sample " << i;
        }
    }
}

TEST(stiff_samples, rows_from_files_move_them_back_and_change_none) {
    const testing::TemporaryFolder folder;
    const Case& c = find_case("integral/fit/r0");
    const auto file = folder.write("r0.csv", "versines_x,versines_y,lambda,mu\n1,0,2,1\n0.5,0.25,2,1\n");
    const auto worst = folder.write("worst.csv", "versines_x,versines_y,lambda,mu\n0.75,0,3,1\n");
    const Sampler without(c, 1, pool()), with(c, 1, pool(), file, worst);
    EXPECT_EQ(with.pinned_count(), 3u);
    EXPECT_EQ(with.draw(0).words[0], std::bit_cast<std::uint32_t>(0.75f)) << "the worst come first";
    EXPECT_EQ(with.draw(1).words[0], std::bit_cast<std::uint32_t>(1.0f));
    EXPECT_EQ(with.first_stiff(), without.first_stiff() + 3);
    for (std::size_t i = 0; i < without.fixed_count() + 100; ++i) {
        ASSERT_EQ(with.draw(i + 3).words, without.draw(i).words) << i;
        const auto moved = with.place(i + 3), place = without.place(i);
        ASSERT_EQ(moved.has_value(), place.has_value());
        if (place) ASSERT_TRUE(moved->locus == place->locus && moved->step == place->step);
    }
    for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(with.place(i));
}

TEST(stiff_samples, kernels_of_one_generator_run_on_the_same_inputs) {
    const Case& one = find_case("integral/exact_theta/a1");
    const Case& other = find_case("integral/sinc/b0"); // with two angles behind the cell
    ASSERT_EQ(default_seed(one), default_seed(other));
    const Sampler of_one(one, default_seed(one), pool()), of_other(other, default_seed(other), pool());
    ASSERT_EQ(of_one.stiff_count(), of_other.stiff_count());
    EXPECT_NE(of_one.first_stiff(), of_other.first_stiff()) << "hostile values differ, stiff ones do not";
    for (std::size_t i = 0; i < of_one.stiff_count(); ++i) {
        auto words = of_other.draw(of_other.first_stiff() + i).words;
        words.resize(5);
        ASSERT_EQ(of_one.draw(of_one.first_stiff() + i).words, words) << i;
    }
}

TEST(stiff_samples, a_kernel_without_a_generator_has_none) {
    const Sampler sampler(find_case("smsr/case_09"), 1, pool());
    EXPECT_EQ(sampler.stiff_count(), 0u);
    for (std::size_t i = 0; i < sampler.fixed_count() + 10; ++i) EXPECT_FALSE(sampler.place(i));
}

TEST(stiff_samples, half_of_what_follows_them_is_ordinary_and_a_quarter_near_a_locus) {
    const Case& c = find_case("integral/mix/radiance");
    const Sampler sampler(c, 3, pool());
    const auto is_ordinary = [&](std::size_t index) {
        Random random(3, index - sampler.first_stiff());
        std::vector<std::uint32_t> words(word_count(c));
        draw_generated(c, random, {}, words);
        return sampler.draw(index).words == words;
    };
    int ordinary = 0, inside = 0;
    for (std::size_t i = sampler.fixed_count(); i < sampler.fixed_count() + 1000; ++i) {
        ordinary += is_ordinary(i) ? 1 : 0;
        inside += in_domain(c, arguments(c, sampler.draw(i).words, nullptr)) ? 1 : 0;
    }
    EXPECT_EQ(ordinary, 500);
    EXPECT_GT(inside, 700);
}

TEST(locus_distance, goes_from_the_locus_itself_over_decades) {
    EXPECT_EQ(locus_distance(0), 0);
    for (int step = 1; step < locus_distances; ++step)
        EXPECT_NEAR(locus_distance(step) * std::pow(10.0, step), 1, 1e-9) << step;
}

} // namespace
} // namespace gnomon
