#include "casegen/versus/report.h"

#include "casegen/check.h"
#include "casegen/measure/pareto.h"

#include <fmt/format.h>

namespace gnomon::versus {
namespace {

std::string failure_text(const SideReport& side) {
    if (!side.ran) return side.message.empty() ? side.failure : side.failure + ": " + side.message;
    if (side.wrong > 0) return fmt::format("{} of {} samples fail", side.wrong, side.samples);
    return side.message.empty() ? side.failure : side.message;
}

/// More, or less, by a factor that is no accident of which inputs were drawn.
const char* trend(const measure::Quantiles& a, const measure::Quantiles& b) {
    const auto more = [](double x, double y) { return x > y * measure::same_error; };
    const bool worse = more(b.most, a.most) || more(b.p99, a.p99);
    const bool better = more(a.most, b.most) || more(a.p99, b.p99);
    if (worse == better) return "";
    return worse ? ", but less accurate" : ", and more accurate";
}

} // namespace

bool is_worse(const Comparison& comparison) {
    const SideReport &a = comparison.a, &b = comparison.b;
    if (is_right(a)) return !is_right(b);
    if (!a.ran || a.failure != "wrong") return false; // none of its results is to be trusted
    return comparison.compared ? comparison.difference.lost > 0 : a.wrong < a.samples;
}

std::string accuracy_verdict(const Comparison& comparison) {
    const SideReport &a = comparison.a, &b = comparison.b;
    std::string errors;
    if (a.ran && b.ran)
        errors = a.error.most == b.error.most && a.error.p99 == b.error.p99
                     ? fmt::format("max error {} {} either way", format_error(b.error.most), b.unit)
                     : fmt::format("max error {} → {} {}", format_error(a.error.most),
                                   format_error(b.error.most), b.unit);
    else if (b.ran)
        errors = fmt::format("max error {} {}", format_error(b.error.most), b.unit);
    const std::string behind = errors.empty() ? "" : "; " + errors;
    if (is_right(a) && is_right(b)) return fmt::format("B is right{}: {}", trend(a.error, b.error), errors);
    if (is_right(b)) return fmt::format("B is right where A is not ({}){}", failure_text(a), behind);
    if (is_right(a)) return fmt::format("B is WRONG where A is right: {}{}", failure_text(b), behind);
    std::string lost;
    if (is_worse(comparison))
        lost = comparison.compared ? fmt::format(", B on {} samples where A is", comparison.difference.lost)
                                   : ", B on all samples where A is";
    return fmt::format("neither is right{}: A: {}; B: {}{}", lost, failure_text(a), failure_text(b), behind);
}

} // namespace gnomon::versus
