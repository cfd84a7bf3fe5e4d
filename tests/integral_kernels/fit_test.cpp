// The lobe's linear fit keeps its digits whatever the lobe: from flat ones to the sharpest, at the peak and
// far from it.
#include "casegen/reference/integral/truth.h"
#include "tests/integral_kernels/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::Row;
using testing::run_rows;
using testing::same_bits;

/// λq from 1e-8 to 1e6 by quarter decades, on intervals that are wide and short, at the peak and off it, as
/// far as something is left of the lobe there; either sign of μ.
std::vector<Row> grid() {
    std::vector<Row> rows;
    for (int quarter = -32; quarter <= 24; ++quarter)
        for (const double width : {2.0, 0.5, 1e-2, 1e-4, 1e-6}) {
            const double m = std::pow(10.0, quarter / 4.0), lambda = 2 * m / width;
            if (lambda > 1e8) continue;
            for (const double near : {0.0, 1e-3 / lambda, 1 / lambda, 30 / lambda, 0.1, 1.0})
                for (const float mu : {1.0f, -0.7f}) {
                    if (near + width > 2 || lambda * near > 60) continue;
                    rows.push_back({static_cast<float>(near + width), static_cast<float>(near),
                                    static_cast<float>(lambda), mu});
                }
        }
    return rows;
}

TEST(fit, keeps_its_digits_from_flat_lobes_to_the_sharpest) {
    const std::vector<Row> rows = grid();
    ASSERT_GT(rows.size(), 500u);
    for (const char* name : {"r0", "r1", "beta"}) {
        const Case& c = find_case(fmt::format("integral/fit/{}", name));
        const std::vector<float> got = run_rows(c.name, rows);
        double worst = 0;
        std::size_t compared = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            Arguments with{};
            std::ranges::copy(rows[i], with.numbers.begin());
            const double want = c.reference.truth(with).value[0];
            if (std::abs(want) < 0x1p-100) continue;
            ++compared;
            const double error = std::abs(static_cast<double>(got[i]) - want) / std::abs(want);
            worst = std::max(worst, error);
            EXPECT_LE(error, 5e-7) << fmt::format(
                "{}: versines {:a}, {:a}, lambda {:a}, mu {:a}: got {:a}, want {:a}", name, rows[i][0],
                rows[i][1], rows[i][2], rows[i][3], got[i], want);
        }
        RecordProperty(name, fmt::format("{:.3g}", worst));
        EXPECT_GT(compared, rows.size() * 9 / 10) << name;
    }
}

/// Lobes of all kinds, `mu` negated or not.
std::vector<Row> lobes(bool negated) {
    const Case& c = find_case("integral/fit/r0");
    std::vector<Row> rows = testing::ordinary_rows(c, 2000, 3);
    for (Row& row : testing::stiff_rows(c, 4)) rows.push_back(std::move(row));
    for (Row& row : grid()) rows.push_back(std::move(row));
    if (negated)
        for (Row& row : rows) row[3] = -row[3];
    return rows;
}

TEST(fit, a_lobe_turned_dark_negates_to_the_last_bit) {
    for (const char* name : {"r0", "r1", "alpha", "beta"}) {
        const std::string kernel = fmt::format("integral/fit/{}", name);
        const std::vector<float> bright = run_rows(kernel, lobes(false)),
                                 dark = run_rows(kernel, lobes(true));
        for (std::size_t i = 0; i < bright.size(); ++i)
            ASSERT_TRUE(same_bits(dark[i], -bright[i]) || (dark[i] == 0 && bright[i] == 0))
                << kernel << " row " << i;
    }
}

TEST(fit, its_error_does_not_depend_on_the_lobe_s_sign) {
    for (const char* kernel : {"integral/fit/l1", "integral/fit/l2"}) {
        const std::vector<float> bright = run_rows(kernel, lobes(false)),
                                 dark = run_rows(kernel, lobes(true));
        for (std::size_t i = 0; i < bright.size(); ++i) {
            ASSERT_TRUE(same_bits(dark[i], bright[i])) << kernel << " row " << i;
            ASSERT_GE(bright[i], 0) << kernel << " row " << i;
        }
    }
}

TEST(fit, an_interval_is_the_same_from_either_end) {
    std::vector<Row> turned = lobes(false);
    for (Row& row : turned) std::swap(row[0], row[1]);
    for (const char* name : {"r0", "r1", "alpha", "beta", "l1", "l2"}) {
        const std::string kernel = fmt::format("integral/fit/{}", name);
        const std::vector<float> straight = run_rows(kernel, lobes(false)),
                                 reversed = run_rows(kernel, turned);
        for (std::size_t i = 0; i < straight.size(); ++i)
            ASSERT_TRUE(same_bits(straight[i], reversed[i])) << kernel << " row " << i;
    }
}

TEST(fit, a_dark_lobe_s_radiance_is_the_bright_one_s_negated) {
    const Case& any = find_case("integral/mix/radiance");
    std::vector<Row> rows = testing::ordinary_rows(any, 1000, 5);
    for (Row& row : testing::stiff_rows(any, 6)) rows.push_back(std::move(row));
    std::vector<Row> dark_rows = rows;
    for (Row& row : dark_rows) row[12] = -row[12];
    for (const Case* c : testing::radiance_kernels()) {
        const std::vector<float> bright = run_rows(c->name, rows), dark = run_rows(c->name, dark_rows);
        for (std::size_t i = 0; i < rows.size(); ++i)
            ASSERT_TRUE(same_bits(dark[i], -bright[i]) || (dark[i] == 0 && bright[i] == 0))
                << c->name << " row " << i;
    }
}

} // namespace
} // namespace gnomon
