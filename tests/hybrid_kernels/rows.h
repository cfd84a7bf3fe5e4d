// The hybrid kernels run on rows of triangles: what they draw from, and how their words are filled.
#pragma once

#include "casegen/catalogue.h"
#include "casegen/hybrid/triangles.h"
#include "casegen/reference/hybrid/truth.h"
#include "tests/support/device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace gnomon::testing {

namespace hybrid_truth = reference::hybrid;
using Point = hybrid_truth::Point<double>;
using Corners = hybrid_truth::Triangle<double>;

/// A kernel's numbers; words are made as its types ask.
using Numbered = std::vector<double>;

inline std::vector<std::uint32_t> run_numbers(const std::string& kernel, const std::vector<Numbered>& rows) {
    const Case& c = find_case(kernel);
    Records records(c);
    records.reserve(rows.size());
    for (const Numbered& row : rows)
        records.add_with([&](std::span<std::uint32_t> words) -> const Mask* {
            EXPECT_EQ(row.size(), words.size()) << c.name;
            for (std::size_t i = 0; i < words.size(); ++i) words[i] = narrow(c.reference.words[i], row[i]);
            return nullptr;
        });
    return run_kernel(kernel, records);
}
inline std::vector<double> run_floats(const std::string& kernel, const std::vector<Numbered>& rows) {
    std::vector<double> results;
    for (const std::uint32_t word : run_numbers(kernel, rows))
        results.push_back(widen(Scalar::float32, word));
    return results;
}

/// A triangle whose corners are floats, and a distance.
struct Trial {
    Corners corners;
    double lambda = 0;
    double sine() const { return hybrid_truth::least_sine(corners); }
    double area2() const { return hybrid_truth::area2(corners[0], corners[1], corners[2]); }
    /// The largest coordinate: what rounding is a fraction of.
    double magnitude() const {
        double largest = lambda;
        for (const Point& p : corners) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
        return largest;
    }
    /// How far a corner that a kernel computes may be off: 2^-21 of the coordinates, times what an angle's
    /// sine and the direction of a chord through it can do. The tables' checks are finer.
    double rounding() const { return 0x1p-21 * magnitude() / (sine() * sine()); }
    Numbered numbers() const {
        return {corners[0].x, corners[0].y, corners[1].x, corners[1].y, corners[2].x, corners[2].y, lambda};
    }
    Numbered numbers(std::initializer_list<double> more) const {
        Numbered all = numbers();
        all.insert(all.end(), more);
        return all;
    }
};

/// As a table's generator draws them: every fourth near a locus.
inline std::vector<Trial>
trials(std::uint64_t seed, std::size_t count,
       const std::shared_ptr<const Generator>& generator = hybrid::triangles("trials", {.distance = 6})) {
    std::vector<Trial> drawn;
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, i);
        std::array<double, 7> numbers{};
        generator->draw(random, numbers);
        if (i % 4 == 3) {
            const Locus& locus =
                generator->loci[random.below(static_cast<std::uint32_t>(generator->loci.size()))];
            locus.place(random, locus_distance(random.between(0, locus_distances - 1)), numbers);
        }
        Trial trial;
        for (std::size_t k = 0; k < 3; ++k)
            trial.corners[k] = {static_cast<double>(static_cast<float>(numbers[2 * k])),
                                static_cast<double>(static_cast<float>(numbers[2 * k + 1]))};
        trial.lambda = static_cast<double>(static_cast<float>(numbers[6]));
        drawn.push_back(trial);
    }
    return drawn;
}

/// How far p lies inside of edge i, negative outside.
inline double inside_edge(const Corners& corners, std::size_t i, const Point& p) {
    const auto line = hybrid_truth::edge(corners, i, 0.0);
    const Point& a = corners[i];
    return line.a * (p.x - a.x) + line.b * (p.y - a.y);
}
inline double inside(const Corners& corners, const Point& p) {
    return std::min({inside_edge(corners, 0, p), inside_edge(corners, 1, p), inside_edge(corners, 2, p)});
}

/// The triangles that a kernel emits for each row, by asking for vertices 0 … 3 n - 1; `rows` lack `corner`.
inline std::vector<std::vector<Corners>> emitted(const std::string& kernel, const std::vector<Numbered>& rows,
                                                 std::size_t n) {
    std::vector<Numbered> asked;
    for (const Numbered& row : rows)
        for (std::size_t vertex = 0; vertex < 3 * n; ++vertex) {
            asked.push_back(row);
            asked.back().push_back(static_cast<double>(vertex));
        }
    const std::vector<double> results = run_floats(kernel, asked);
    std::vector<std::vector<Corners>> triangles(rows.size(), std::vector<Corners>(n));
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t vertex = 0; vertex < 3 * n; ++vertex) {
            const std::size_t at = 2 * (row * 3 * n + vertex);
            triangles[row][vertex / 3][vertex % 3] = {results[at], results[at + 1]};
        }
    return triangles;
}

} // namespace gnomon::testing
