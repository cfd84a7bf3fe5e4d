// What the printed formulas lose, and where: the reason why the others are there.
#include "casegen/compare.h"
#include "casegen/measure/quantiles.h"
#include "casegen/truths.h"
#include "tests/integral_kernels/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::Row;

/// A kernel's outputs, whatever is wrong with them: what a division by zero gives need not even be written.
Outputs run_bare(const Case& c, const std::vector<Row>& rows) {
    return evaluate(testing::shared_device(), kernel_sources(testing::kernels_folder()), c,
                    testing::records_of(c, rows));
}
float result(const Outputs& outputs, std::size_t i) { return std::bit_cast<float>(outputs.words[i]); }

TEST(as_printed, b0_is_never_a_number) {
    for (const char* name :
         {"integral/as_printed/b0", "integral/as_printed/b", "integral/as_printed/radiance"}) {
        const Case& c = find_case(name);
        std::vector<Row> rows = testing::ordinary_rows(c, 2000, 41);
        for (Row& row : testing::stiff_rows(c, 42)) rows.push_back(std::move(row));
        const Outputs outputs = run_bare(c, rows);
        EXPECT_FALSE(outputs.stray_write);
        for (std::size_t i = 0; i < rows.size(); ++i)
            ASSERT_TRUE(outputs.unwritten[i] || std::isnan(result(outputs, i)))
                << name << " row " << i << " gives " << result(outputs, i);
    }
}

/// Rows of C4 (phi0, phi1, p, s, t) with this s.
std::vector<Row> waves_with(float s, std::uint64_t seed) {
    std::vector<Row> rows = testing::ordinary_rows(find_case("integral/sinc/c4"), 300, seed);
    for (Row& row : rows) row[3] = s;
    return rows;
}

TEST(as_printed, c4_is_no_number_at_s_1_and_minus_1_and_is_one_next_to_them) {
    const Case& c = find_case("integral/as_printed/c4");
    for (const float s : {1.0f, -1.0f}) {
        const Outputs at = run_bare(c, waves_with(s, 43));
        const Outputs above = run_bare(c, waves_with(std::nextafter(s, 2.0f), 43));
        const Outputs below = run_bare(c, waves_with(std::nextafter(s, -2.0f), 43));
        for (std::size_t i = 0; i < at.unwritten.size(); ++i) {
            EXPECT_TRUE(at.unwritten[i] || std::isnan(result(at, i))) << "s = " << s;
            EXPECT_TRUE(std::isfinite(result(above, i)) && std::isfinite(result(below, i)))
                << "s next to " << s;
        }
    }
}

/// Rows that the generator places at this step of the locus, within the case's domain.
std::vector<Row> at_distance(const Case& c, const char* locus, int step) {
    const auto& loci = c.generator->loci;
    const auto found = std::ranges::find(loci, locus, &Locus::name);
    EXPECT_NE(found, loci.end()) << locus;
    std::vector<Row> rows;
    std::vector<std::uint32_t> words(word_count(c));
    for (std::uint64_t i = 0; rows.size() < 300; ++i) {
        Random random(44, i);
        draw_generated(c, random, Place{static_cast<std::size_t>(found - loci.begin()), step}, words);
        if (in_domain(c, arguments(c, words, nullptr))) rows.push_back(testing::as_floats(words));
    }
    return rows;
}

/// The median error of `form`, as a fraction of the integrand's size.
double median_error(const std::string& form, const Case& truth_of, const std::vector<Row>& rows) {
    const Case& c = find_case(form);
    const std::vector<Truth> known = truths(truth_of, testing::records_of(truth_of, rows));
    const Outputs outputs = run_bare(c, rows);
    std::vector<double> errors;
    for (std::size_t i = 0; i < rows.size(); ++i)
        errors.push_back(std::abs(static_cast<double>(result(outputs, i)) - known[i].value[0]) /
                         known[i].scale);
    return measure::quantiles(std::move(errors)).median;
}

struct Loss {
    const char *quantity, *locus, *domain;
};
class printed_forms : public ::testing::TestWithParam<Loss> {};

TEST_P(printed_forms, lose_what_they_divide_by_and_waves_without_a_division_do_not) {
    const auto& [quantity, locus, domain] = GetParam();
    const Case& c = find_case(domain);
    for (int step = 1; step <= 6; ++step) {
        const std::vector<Row> rows = at_distance(c, locus, step);
        const double printed = median_error(fmt::format("integral/printed/{}", quantity), c, rows);
        const double sinc = median_error(fmt::format("integral/sinc/{}", quantity), c, rows);
        const double expected = 1e-7 / locus_distance(step);
        RecordProperty(fmt::format("{} at 1e-{}", locus, step),
                       fmt::format("printed {:.2g}, sinc {:.2g}", printed, sinc));
        EXPECT_GT(printed, 0.1 * expected) << locus << " at 1e-" << step;
        EXPECT_LT(printed, 10 * expected) << locus << " at 1e-" << step;
        EXPECT_LT(sinc, 1e-6) << locus << " at 1e-" << step;
    }
}

INSTANTIATE_TEST_SUITE_P(
    quantities, printed_forms,
    ::testing::Values(Loss{"c4", "s = 1", "integral/sinc/c4"}, Loss{"c4", "s = -1", "integral/sinc/c4"},
                      Loss{"c2", "s = 0", "integral/sinc/c2"}, Loss{"c5", "s = 2", "integral/sinc/c5"},
                      Loss{"a1", "k = 0", "integral/exact_theta/a1"}),
    [](const auto& instance) { return fmt::format("{}_{}", instance.param.quantity, instance.index); });

} // namespace
} // namespace gnomon
