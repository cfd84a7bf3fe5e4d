// C0 … C5 of kernels/integral/printed and sinc: Appendix B, Equation 7.
#include "casegen/integral/quantity.h"
#include "casegen/reference/integral/truth.h"

#include <algorithm>
#include <cmath>

namespace gnomon::integral {
namespace {

using namespace reference::integral;

Parameter phi0() { return {"phi0", {-7000, 7000, {}}, "radians", "where the interval of azimuths begins"}; }
Parameter phi1() { return {"phi1", {-7000, 7000, {}}, "radians", "where it ends"}; }
Parameter phase(const char* name) { return {name, {-7, 7, {}}, "radians", "a phase"}; }
Parameter frequency() { return {"s", {-1e4, 1e4, {}}, "1", "turns of the second wave per turn of azimuth"}; }

Quantity wave(const char* name, Reference reference, std::vector<Parameter> parameters, int phases,
              bool with_wave, const char* meaning) {
    return {name,
            std::string("Analytic Double Product Integrals, Appendix B, Equation 7"),
            std::move(reference),
            std::move(parameters),
            {-largest, largest, "radians", meaning},
            stiffness::waves(phases, with_wave),
            stiffness::is_wave(with_wave ? static_cast<std::size_t>(2 + phases) : 0),
            "a reversed interval negates the result; an input that is not finite gives 0",
            not_finite_gives({})};
}

/// Where no denominator is small, no interval narrow, and no angle so large that its rounding shows.
std::function<bool(const Arguments&)> far_from_loci(std::size_t s) {
    return [s](const Arguments& arguments) {
        const auto& n = arguments.numbers;
        const auto far = [&](double locus) { return std::abs(std::abs(n[s]) - locus) > 0.1; };
        return std::abs(n[1] - n[0]) > 0.2 && std::abs(n[0]) < 20 && std::abs(n[1]) < 20 &&
               (s == 0 || (far(0) && far(1) && far(2) && std::abs(n[s]) < 40));
    };
}

} // namespace

std::vector<Case> wave_cases() {
    const Quantity c0_ =
        wave("c0", reference_by<double(double, double)>(c0), {phi0(), phi1()}, 0, false, "the width");
    const Quantity c1_ = wave("c1", reference_by<double(double, double, double)>(c1),
                              {phi0(), phi1(), phase("p")}, 1, false, "integral of sin(phi + p)");
    const Quantity c2_ =
        wave("c2", reference_by<double(double, double, double, double)>(c2),
             {phi0(), phi1(), frequency(), phase("t")}, 0, true, "integral of cos(s phi + t)");
    const Quantity c3_ = wave("c3", reference_by<double(double, double, double)>(c3),
                              {phi0(), phi1(), phase("p")}, 1, false, "integral of phi sin(phi + p)");
    const Quantity c4_ = wave("c4", reference_by<double(double, double, double, double, double)>(c4),
                              {phi0(), phi1(), phase("p"), frequency(), phase("t")}, 1, true,
                              "integral of sin(phi + p) sin(s phi + t)");
    const Quantity c5_ = wave("c5", reference_by<double(double, double, double, double, double, double)>(c5),
                              {phi0(), phi1(), phase("p"), phase("q"), frequency(), phase("t")}, 2, true,
                              "integral of sin(phi + p) sin(phi + q) cos(s phi + t)");
    std::vector<Case> cases;
    // Terms as large as 1/0.1 are subtracted, of angles up to 20 (40 x 20): so absolute errors, three times
    // the largest that `gnomon worst` finds.
    cases.push_back(as_printed(in_form("printed", c0_, conditioned(1)), far_from_loci(0)));
    cases.push_back(as_printed(in_form("printed", c1_, absolute(1e-5)), far_from_loci(0)));
    cases.push_back(as_printed(in_form("printed", c2_, absolute(3e-5)), far_from_loci(2)));
    cases.push_back(as_printed(in_form("printed", c3_, absolute(2e-4)), far_from_loci(0)));
    // C4 at s = 1 itself by its limit: B0 asks for that on every input.
    const auto is_asked_of_c4 = [ordinary = far_from_loci(3),
                                 anywhere = far_from_loci(0)](const Arguments& with) {
        return with.numbers[3] == 1 ? anywhere(with) : ordinary(with);
    };
    cases.push_back(as_printed(in_form("printed", c4_, absolute(4e-5)), is_asked_of_c4));
    cases.push_back(as_printed(in_form("printed", c5_, absolute(2e-5)), far_from_loci(4)));
    Case exactly = in_form("as_printed", c4_, absolute(4e-5));
    exactly.defended = false;
    exactly.outside = nullptr;
    exactly.rule = "as printed: NaN at s = 1 and s = -1";
    exactly.fails = "divides by zero at s = 1 and s = -1, and loses 1e-7/d at a distance d from them";
    cases.push_back(std::move(exactly));
    for (const Quantity& q : {c1_, c2_, c3_}) cases.push_back(in_form("sinc", q, conditioned(12)));
    // Where both sines are small their waves, two or three, cancel: the error is one of the waves, whatever
    // is left.
    const auto is_plain = [](std::size_t s) {
        return [s](const Arguments& with) {
            const auto& n = with.numbers;
            return std::abs(n[0]) < 20 && std::abs(n[1]) < 20 && std::abs(n[s]) < 40;
        };
    };
    cases.push_back(good_where(in_form("sinc", c4_, absolute(1e-5)), is_plain(3)));
    cases.push_back(good_where(in_form("sinc", c5_, absolute(1e-5)), is_plain(4)));
    return cases;
}

} // namespace gnomon::integral
