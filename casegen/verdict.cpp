#include "casegen/verdict.h"

#include <algorithm>
#include <limits>

namespace gnomon {

Finding make_finding(const Case& c, const Records& records, std::size_t i, std::size_t index,
                     std::span<const std::uint32_t> got, double error) {
    const std::span<const std::uint32_t> input = records.input(i);
    const Mask* mask = records.mask(i);
    const Arguments with = arguments(c, input, mask);
    Finding finding{index, {input.begin(), input.end()}, {},   {got.begin(), got.end()},
                    {},    in_domain(c, with),           error};
    if (mask) finding.mask = *mask;
    if (finding.in_domain) finding.want = c.reference.call(with);
    return finding;
}

bool add_complaint(const Case& c, const Records& records, std::size_t begin, const Outputs& outputs,
                   CheckReport& report) {
    report.message = outputs.complaint();
    if (report.message.empty()) return false;
    const auto gap = std::ranges::find(outputs.unwritten, 1);
    report.verdict = gap != outputs.unwritten.end() ? Verdict::unwritten
                     : outputs.stray_write          ? Verdict::stray_write
                                                    : Verdict::unstable;
    if (report.verdict == Verdict::unwritten) {
        const auto i = static_cast<std::size_t>(gap - outputs.unwritten.begin());
        report.worst = make_finding(c, records, i, begin + i, {}, std::numeric_limits<double>::infinity());
    }
    return true;
}

void expect_what_the_table_says(CheckReport& report) {
    const std::string& why = report.kernel->fails;
    if (why.empty()) return;
    // What a division by zero gives is undefined: a driver may also leave it unwritten, or other each time.
    if (report.verdict == Verdict::wrong || report.verdict == Verdict::unwritten ||
        report.verdict == Verdict::unstable) {
        report.verdict = Verdict::expected;
    } else if (report.verdict == Verdict::pass) {
        report.verdict = Verdict::passes_wrongly;
        report.message = "passes, but its table says that it fails: " + why;
    }
}

} // namespace gnomon
