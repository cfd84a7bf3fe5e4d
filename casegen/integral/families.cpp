// The folders of kernels/integral, and what a quantity and a form have in common with others of theirs.
#include "casegen/integral/quantity.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gnomon {
namespace integral {

Case in_form(const std::string& form, const Quantity& quantity, Tolerance tolerance) {
    Case c;
    c.name = "integral/" + form + "/" + quantity.name;
    c.source = quantity.source;
    c.reference = quantity.reference;
    c.parameters = quantity.parameters;
    c.result = quantity.result;
    c.tolerance = tolerance;
    c.where = quantity.where;
    c.quantity = "integral/" + quantity.name;
    c.generator = quantity.generator;
    c.rule = quantity.rule;
    c.outside = quantity.outside;
    return c;
}

std::function<std::optional<Bounds>(std::span<const double>)> not_finite_gives(const Numbers& answer) {
    return [answer](std::span<const double> numbers) -> std::optional<Bounds> {
        if (std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); })) return {};
        return exactly(answer);
    };
}

Case good_where(Case c, std::function<bool(const Arguments&)> ordinary) {
    c.where = [within = std::move(c.where), ordinary = std::move(ordinary)](const Arguments& arguments) {
        return (!within || within(arguments)) && ordinary(arguments);
    };
    return c;
}

Case as_printed(Case c, std::function<bool(const Arguments&)> ordinary) {
    c = good_where(std::move(c), std::move(ordinary));
    c.defended = false;
    c.outside = nullptr;
    c.rule = "as printed: whatever comes of it, NaN included, where it divides by zero or its input is none";
    return c;
}

} // namespace integral

std::vector<Family> integral_families() {
    using namespace integral;
    std::vector<Family> families{
        {"integral/elementary",
         "sin, cos, exp and what avoids their cancellations, the same on every device",
         {}},
        {"integral/interval", "the interval of a dot product over a cell", {}},
        {"integral/fit", "the linear fit of a lobe by versines, and its error", {}},
        {"integral/fit_printed", "the linear fit of a lobe as printed", {}},
        {"integral/cell", "cells in the form that keeps their digits", {}},
        {"integral/as_printed", "the printed integrals, the division by zero included", {}},
        {"integral/printed", "the printed integrals, C4's division by zero mended", {}},
        {"integral/sinc", "the integrals by waves without a division", {}},
        {"integral/exact_theta", "exact in theta, Gauss-Legendre with 12 nodes in phi", {}},
        {"integral/exact_theta_4", "exact in theta, Gauss-Legendre with 4 nodes in phi", {}},
        {"integral/exact_theta_8", "exact in theta, Gauss-Legendre with 8 nodes in phi", {}},
        {"integral/centred_4", "Gauss-Legendre with 4 x 4 nodes, the fit about its middle", {}},
        {"integral/centred_8", "Gauss-Legendre with 8 x 8 nodes, the fit about its middle", {}},
        {"integral/centred_12", "Gauss-Legendre with 12 x 12 nodes, the fit about its middle", {}},
        {"integral/columns_4", "4 columns, each exact in theta about its middle", {}},
        {"integral/columns_8", "8 columns, each exact in theta about its middle", {}},
        {"integral/columns_12", "12 columns, each exact in theta about its middle", {}},
        {"integral/columns_16", "16 columns, each exact in theta about its middle", {}},
        {"integral/mix", "the default: as many columns as the cell asks for", {}},
    };
    for (auto* table : {elementary_cases, lobe_cases, wave_cases, boundary_cases, radiance_cases})
        for (Case& c : table()) {
            const std::string folder = c.name.substr(0, c.name.rfind('/'));
            const auto family = std::ranges::find(families, folder, &Family::name);
            assert(family != families.end() && "a kernel in a folder that is not listed here");
            family->cases.push_back(std::move(c));
        }
    return families;
}

} // namespace gnomon
