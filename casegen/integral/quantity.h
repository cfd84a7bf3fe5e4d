// Tables of kernels/integral. A quantity is computed by several kernels, each a form of the same integral:
// the quantity says what is asked and what is true, a form how far from that it may be.
#pragma once

#include "casegen/catalogue.h"
#include "casegen/stiffness.h"

namespace gnomon::integral {

struct Quantity {
    std::string name; ///< "a0": the kernels integral/<form>/a0
    std::string source;
    Reference reference;
    std::vector<Parameter> parameters;
    Result result;
    std::shared_ptr<const Generator> generator;
    std::function<bool(const Arguments&)> where;
    std::string rule;
    std::function<std::optional<Bounds>(std::span<const double>)> outside; ///< as Case::outside
};

/// The rule that an input which is not finite gives this.
std::function<std::optional<Bounds>(std::span<const double>)> not_finite_gives(const Numbers& answer);

/// The kernel integral/<form>/<quantity>.
Case in_form(const std::string& form, const Quantity& quantity, Tolerance tolerance);

/// A form as the papers print it: held to its tolerance where `ordinary` holds, and to nothing elsewhere.
Case as_printed(Case c, std::function<bool(const Arguments&)> ordinary);
/// A form that answers everything, but is as good as its tolerance only where `ordinary` holds.
Case good_where(Case c, std::function<bool(const Arguments&)> ordinary);

constexpr double largest = 0x1.fffffep127; ///< the largest float
constexpr double nearest_pi =
    0x1.921fb6p1; ///< the float next to π, which is greater: a domain up to π holds it

// The tables, of all forms.
std::vector<Case> elementary_cases(); ///< sin, exp, …
std::vector<Case> lobe_cases();       ///< the interval of the dot product, the linear fit and its errors
std::vector<Case> wave_cases();       ///< C0 … C5
std::vector<Case> boundary_cases();   ///< the cell, A0 … B
std::vector<Case> radiance_cases();   ///< L_o

} // namespace gnomon::integral
