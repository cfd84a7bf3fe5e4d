// What is turned round: an interval of φ or θ negates an integral, one of x is the same from either end.
#include "casegen/check.h"
#include "casegen/compare.h"
#include "casegen/truths.h"
#include "tests/integral_kernels/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::Row;
using testing::run_rows;
using testing::same_bits;

bool are_opposite(float a, float b) { return same_bits(a, -b) || (a == 0 && b == 0); }

std::vector<Row> rows_of(const char* kernel) {
    const Case& c = find_case(kernel);
    std::vector<Row> rows = testing::ordinary_rows(c, 1500, 11);
    for (Row& row : testing::stiff_rows(c, 12)) rows.push_back(std::move(row));
    return rows;
}

class by_phi : public ::testing::TestWithParam<const char*> {};

TEST_P(by_phi, an_interval_from_its_other_end_negates_to_the_last_bit) {
    const std::string kernel = GetParam();
    const std::vector<Row> rows = rows_of(GetParam());
    std::vector<Row> reversed = rows;
    for (Row& row : reversed) std::swap(row[0], row[1]);
    const std::vector<float> straight = run_rows(kernel, rows), turned = run_rows(kernel, reversed);
    std::size_t not_zero = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_TRUE(are_opposite(straight[i], turned[i]))
            << kernel << " row " << i << ": " << straight[i] << " and " << turned[i];
        not_zero += straight[i] != 0 ? 1 : 0;
    }
    EXPECT_GT(not_zero, rows.size() / 2);
}

INSTANTIATE_TEST_SUITE_P(kernels, by_phi,
                         ::testing::Values("integral/sinc/c1", "integral/sinc/c2", "integral/sinc/c3",
                                           "integral/sinc/c4", "integral/sinc/c5", "integral/sinc/a0",
                                           "integral/sinc/a1", "integral/sinc/b0", "integral/sinc/b1",
                                           "integral/sinc/b2", "integral/sinc/b3"),
                         [](const auto& instance) { return function_name(find_case(instance.param)); });

/// Sums whose terms come in another order: the same to this many times what rounding the inputs does. `whole`
/// is the kernel whose domain holds all rows.
void expect_opposite(const Case& whole, const Case& c, const std::vector<Row>& rows,
                     const std::vector<Row>& reversed, double times) {
    const Records records = testing::records_of(c, rows);
    const std::vector<Truth> known = truths(whole, records);
    const std::vector<float> straight = run_rows(c.name, rows), turned = run_rows(c.name, reversed);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!in_domain(whole, arguments(whole, records.input(i), nullptr))) continue; // no truth there
        const double sum = static_cast<double>(straight[i]) + static_cast<double>(turned[i]);
        EXPECT_LE(std::abs(sum), times * unit_of_error(known[i], 0)) << fmt::format(
            "{}: {:a} and {:a}", format_call(c, records.input(i), nullptr), straight[i], turned[i]);
    }
}

TEST(reversal, of_phi_negates_what_is_summed_over_columns) {
    for (const char* name : {"a0", "a1", "b0", "b1", "b2", "b3", "a", "b"}) {
        const Case& c = find_case(fmt::format("integral/exact_theta/{}", name));
        const std::vector<Row> rows = testing::ordinary_rows(c, 200, 13);
        std::vector<Row> reversed = rows;
        for (Row& row : reversed) std::swap(row[0], row[1]);
        expect_opposite(c, c, rows, reversed, 4);
    }
}

TEST(reversal, of_a_lit_cell_s_width_and_boundary_negates) {
    const Case& any = find_case("integral/mix/radiance");
    std::vector<Row> rows = testing::ordinary_rows(any, 400, 14);
    for (Row& row : testing::stiff_rows(any, 15)) rows.push_back(std::move(row));
    std::vector<Row> reversed = rows;
    for (Row& row : reversed) {
        row[1] = -row[1];
        std::swap(row[3], row[4]);
    }
    for (const char* form : {"mix", "columns_4", "columns_8", "columns_12", "columns_16"}) {
        const std::string kernel = fmt::format("integral/{}/radiance", form);
        const std::vector<float> straight = run_rows(kernel, rows), turned = run_rows(kernel, reversed);
        for (std::size_t i = 0; i < rows.size(); ++i)
            ASSERT_TRUE(are_opposite(straight[i], turned[i])) << kernel << " row " << i;
    }
    for (const char* form : {"centred_4", "centred_8", "centred_12"})
        expect_opposite(any, find_case(fmt::format("integral/{}/radiance", form)), rows, reversed, 2);
    // By α and βx, or by φ0, k and b: where those are good enough.
    for (const char* form : {"exact_theta_4", "exact_theta_8", "exact_theta", "sinc"}) {
        const Case& c = find_case(fmt::format("integral/{}/radiance", form));
        const auto mirrored = [](Row row) {
            row[1] = -row[1];
            std::swap(row[3], row[4]);
            return row;
        };
        const std::vector<Row> within = testing::ordinary_rows(c, 200, 20);
        std::vector<Row> turned;
        std::ranges::transform(within, std::back_inserter(turned), mirrored);
        expect_opposite(c, c, within, turned, 8);
    }
}

TEST(reversal, of_x_gives_the_same_bits) {
    const Case& any = find_case("integral/mix/radiance");
    std::vector<Row> rows = testing::ordinary_rows(any, 1000, 16);
    for (Row& row : testing::stiff_rows(any, 17)) rows.push_back(std::move(row));
    std::vector<Row> reversed = rows;
    for (Row& row : reversed) std::swap(row[13], row[14]);
    for (const Case* c : testing::radiance_kernels()) {
        const std::vector<float> straight = run_rows(c->name, rows), turned = run_rows(c->name, reversed);
        for (std::size_t i = 0; i < rows.size(); ++i)
            ASSERT_TRUE(same_bits(straight[i], turned[i])) << c->name << " row " << i;
    }
}

/// A flat boundary above θ0, and the same slab from its other edge. On a lattice on which both edges and
/// their distance are floats.
TEST(reversal, of_theta_negates) {
    const Case& c = find_case("integral/mix/radiance");
    std::vector<Row> rows = testing::ordinary_rows(c, 400, 18), reversed;
    const auto on_lattice = [](float x) { return std::round(x * 0x1p20f) * 0x1p-20f; };
    for (Row& row : rows) {
        row[2] = on_lattice(std::min(row[2], 3.0f));
        row[3] = row[4] = on_lattice(std::clamp(row[3], -row[2], 3.1f - row[2]));
        reversed.push_back(row);
        reversed.back()[2] = row[2] + row[3];
        reversed.back()[3] = reversed.back()[4] = -row[3];
    }
    expect_opposite(c, c, rows, reversed, 3);
    // Where the edges' names change nothing but the sign, for any boundary: the mean heights.
    for (const char* name : {"a1", "b3", "a", "b"}) {
        const Case& part = find_case(fmt::format("integral/exact_theta/{}", name));
        std::vector<Row> cells = testing::ordinary_rows(part, 200, 19), turned;
        for (Row& row : cells) {
            row[3] = 0;
            row[2] = on_lattice(std::min(row[2], 3.0f));
            row[4] = on_lattice(std::clamp(row[4], 0.0f, 3.0f));
            turned.push_back(row);
            std::swap(turned.back()[2], turned.back()[4]);
        }
        expect_opposite(part, part, cells, turned, 4);
    }
}

} // namespace
} // namespace gnomon
