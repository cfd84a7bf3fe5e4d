// SMSR in double precision as its parts compose: edge, condition, case. What the assembled kernel is made of,
// without a device.
#pragma once

#include "casegen/catalogue.h"

#include <cstdint>
#include <map>
#include <vector>

namespace gnomon::testing {

/// The cases that a decision list numbers, of the family "smsr".
const std::vector<const Case*>& smsr_cases();

/// The one case of a lit texel's edge; null if nothing around it differs. Fails the test if several apply.
const Case* smsr_case_of(const reference::Edge& edge);

/// The case's reference at `p`; 1 if no case applies.
double smsr_by_cases(const reference::Edge& edge, glm::dvec2 p);

/// smsr_by_cases at fixed points, remembered by edge: exhaustive tests meet few different ones.
class SmsrChain {
public:
    explicit SmsrChain(std::vector<glm::dvec2> points) : points_(std::move(points)) {}
    const std::vector<glm::dvec2>& points() const { return points_; }
    const std::vector<double>& values(const reference::Edge& edge);

private:
    std::vector<glm::dvec2> points_;
    std::map<std::uint64_t, std::vector<double>> known_;
};

/// Everything that decides about an edge's case and values.
std::uint64_t edge_key(const reference::Edge& edge);
/// Sides, types and, at corners, dominance: what the decision list reads.
std::uint64_t decision_key(const reference::Edge& edge);

} // namespace gnomon::testing
