// Laws that the integrals obey whatever computes them: turns about the pole, the mirror at the equator, cells
// that are cut in two.
#include "casegen/check.h"
#include "casegen/compare.h"
#include "casegen/truths.h"
#include "tests/integral_kernels/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

namespace gnomon {
namespace {

using testing::Row;
using testing::run_rows;

constexpr float pi = std::numbers::pi_v<float>;

/// The vector whose x is at this place a quarter turn on, exactly.
void turn_quarter(Row& row, std::size_t x) {
    const float old = row[x];
    row[x] = -row[x + 1];
    row[x + 1] = old;
}

/// `sign` times the results on `others` are those on `rows`, but for so many times what rounding either's
/// inputs does.
void expect_equal(const Case& c, const std::vector<Row>& rows, const std::vector<Row>& others, float sign,
                  double times) {
    const Records records = testing::records_of(c, rows), of_others = testing::records_of(c, others);
    const std::vector<Truth> known = truths(c, records), others_known = truths(c, of_others);
    const std::vector<float> one = run_rows(c.name, rows), other = run_rows(c.name, others);
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    for (std::size_t i = 0; i < one.size(); ++i) {
        const std::size_t row = i / components, k = i % components;
        const double unit = unit_of_error(known[row], k) + unit_of_error(others_known[row], k);
        EXPECT_LE(std::abs(static_cast<double>(one[i]) - static_cast<double>(sign * other[i])), times * unit)
            << fmt::format("{}: {:a} and {:a}", format_call(c, records.input(row), nullptr), one[i],
                           other[i]);
    }
}

TEST(symmetry, turning_cell_normal_and_axis_by_quarters_changes_nothing) {
    for (const auto& [kernel, vectors] :
         {std::pair{"integral/mix/radiance", std::vector<std::size_t>{5, 8}},
          std::pair{"integral/interval/exact", std::vector<std::size_t>{4}},
          std::pair{"integral/interval/versines", std::vector<std::size_t>{4}}}) {
        const Case& c = find_case(kernel);
        const std::vector<Row> rows = testing::ordinary_rows(c, 300, 21);
        std::vector<Row> turned = rows;
        for (int quarters = 1; quarters <= 3; ++quarters) {
            for (std::size_t i = 0; i < rows.size(); ++i) {
                turned[i][0] = rows[i][0] + static_cast<float>(quarters) * 0.5f * pi;
                for (const std::size_t x : vectors) turn_quarter(turned[i], x);
            }
            expect_equal(c, rows, turned, 1, 4);
        }
    }
}

TEST(symmetry, turning_a_cell_under_a_boundary_by_quarters_changes_nothing) {
    const Case& c = find_case("integral/exact_theta/b");
    std::vector<Row> rows = testing::ordinary_rows(c, 200, 22), turned;
    for (const Row& row : rows) {
        turned.push_back(row);
        Row& other = turned.back();
        other[0] += 0.5f * pi;
        other[1] += 0.5f * pi;
        other[4] -= other[3] * (0.5f * pi);
        turn_quarter(other, 5);
        turn_quarter(other, 8);
    }
    expect_equal(c, rows, turned, 1, 4);
}

// By the angle from the other pole, as cells there are better given: z, heights and the result change sign.
TEST(symmetry, the_mirror_at_the_equator_negates) {
    const Case& c = find_case("integral/mix/radiance");
    const std::vector<Row> rows = testing::ordinary_rows(c, 600, 23);
    std::vector<Row> thetas;
    for (const Row& row : rows) thetas.push_back({row[2]});
    const std::vector<float> from_south = run_rows("integral/cell/from_south", thetas);
    std::vector<Row> mirrored = rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        mirrored[i][2] = from_south[i];
        for (const std::size_t sign : {3u, 4u, 7u, 10u}) mirrored[i][sign] = -mirrored[i][sign];
    }
    expect_equal(c, rows, mirrored, -1, 4);
}

TEST(symmetry, the_mirror_at_a_meridian_changes_nothing) {
    const Case& c = find_case("integral/mix/radiance");
    std::vector<Row> rows = testing::ordinary_rows(c, 300, 24), mirrored = rows;
    for (Row& row : mirrored) {
        row[0] = -row[0];
        std::swap(row[3], row[4]);
        row[6] = -row[6];
        row[9] = -row[9];
    }
    expect_equal(c, rows, mirrored, 1, 2);
}

/// Cells under one boundary: from φ0 to φ1, to a φ between, and from there.
TEST(symmetry, a_cell_is_the_sum_of_its_parts) {
    for (const char* form : {"exact_theta", "sinc"})
        for (const char* name : {"a", "b", "a1", "b3"}) {
            const Case& c = find_case(fmt::format("integral/{}/{}", form, name));
            std::vector<Row> wholes, firsts, seconds;
            Random random(25);
            for (const Row& row : testing::ordinary_rows(c, 200, 26)) {
                const auto share = static_cast<float>(0.2 + 0.6 * random.unit());
                const float between = row[0] + share * (row[1] - row[0]);
                wholes.push_back(row);
                firsts.push_back(row);
                firsts.back()[1] = between;
                seconds.push_back(row);
                seconds.back()[0] = between;
            }
            const Records records = testing::records_of(c, wholes);
            const std::vector<Truth> known = truths(c, records);
            const std::vector<float> whole = run_rows(c.name, wholes), first = run_rows(c.name, firsts),
                                     second = run_rows(c.name, seconds);
            double most = 0;
            for (std::size_t i = 0; i < whole.size(); ++i) {
                const double sum = static_cast<double>(first[i]) + static_cast<double>(second[i]);
                const double error = std::abs(static_cast<double>(whole[i]) - sum);
                most = std::max(most, error / unit_of_error(known[i], 0));
                EXPECT_LE(error, 16 * unit_of_error(known[i], 0))
                    << fmt::format("{}: {:a} is not {:a} + {:a}", format_call(c, records.input(i), nullptr),
                                   whole[i], first[i], second[i]);
            }
            RecordProperty(c.name, fmt::format("{:.3g}", most));
        }
}

} // namespace
} // namespace gnomon
