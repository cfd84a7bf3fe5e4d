// Kernels of kernels/integral run on rows of floats.
#pragma once

#include "casegen/catalogue.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

namespace gnomon::testing {

/// One kernel's inputs, component by component.
using Row = std::vector<float>;

inline Records records_of(const Case& c, const std::vector<Row>& rows) {
    Records records(c);
    records.reserve(rows.size());
    for (const Row& row : rows)
        records.add_with([&](std::span<std::uint32_t> words) -> const Mask* {
            EXPECT_EQ(row.size(), words.size()) << c.name;
            std::ranges::transform(row, words.begin(),
                                   [](float x) { return std::bit_cast<std::uint32_t>(x); });
            return nullptr;
        });
    return records;
}

inline std::vector<float> as_floats(const std::vector<std::uint32_t>& words) {
    std::vector<float> values(words.size());
    std::ranges::transform(words, values.begin(),
                           [](std::uint32_t word) { return std::bit_cast<float>(word); });
    return values;
}

/// Its results, component by component.
inline std::vector<float> run_rows(const std::string& kernel, const std::vector<Row>& rows) {
    return as_floats(run_kernel(kernel, records_of(find_case(kernel), rows)));
}

/// Rows as the case's generator draws them: ordinary ones that lie in the case's domain.
inline std::vector<Row> ordinary_rows(const Case& c, std::size_t count, std::uint64_t seed) {
    std::vector<Row> rows;
    std::vector<std::uint32_t> words(word_count(c));
    for (std::uint64_t i = 0; rows.size() < count; ++i) {
        Random random(seed, i);
        draw_generated(c, random, {}, words);
        if (in_domain(c, arguments(c, words, nullptr))) rows.push_back(as_floats(words));
    }
    return rows;
}

/// The same, and one at every distance from every locus.
inline std::vector<Row> stiff_rows(const Case& c, std::uint64_t seed) {
    std::vector<Row> rows;
    std::vector<std::uint32_t> words(word_count(c));
    for (std::size_t locus = 0; locus < c.generator->loci.size(); ++locus)
        for (int step = 0; step < locus_distances; ++step) {
            Random random(seed, locus * locus_distances + static_cast<std::size_t>(step));
            draw_generated(c, random, Place{locus, step}, words);
            if (in_domain(c, arguments(c, words, nullptr))) rows.push_back(as_floats(words));
        }
    return rows;
}

inline bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Kernels of kernels/integral that answer everything.
inline std::vector<const Case*> defended_kernels() {
    std::vector<const Case*> cases = find_cases("integral/*");
    std::erase_if(cases, [](const Case* c) { return !c->defended; });
    return cases;
}
inline std::vector<const Case*> radiance_kernels() {
    std::vector<const Case*> cases = defended_kernels();
    std::erase_if(cases, [](const Case* c) { return c->quantity != "integral/radiance"; });
    return cases;
}

} // namespace gnomon::testing
