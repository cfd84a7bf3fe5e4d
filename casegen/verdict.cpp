#include "casegen/verdict.h"

#include "casegen/compare.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace gnomon {
namespace {

constexpr std::size_t records_per_task = 2048;

} // namespace

Judged judge_all(const Case& c, const Records& records, std::vector<std::uint32_t> results,
                 std::span<const Truth> truths, const Judged* earlier) {
    Judged judged;
    judged.results = std::move(results);
    judged.errors.resize(records.size());
    judged.failed.resize(records.size());
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    const auto result_of = [&](const Judged& from, std::size_t i) {
        return std::span(from.results).subspan(i * components, components);
    };
    const auto judge_one = [&](std::size_t i) {
        const std::span<const std::uint32_t> got = result_of(judged, i);
        if (earlier && std::ranges::equal(got, result_of(*earlier, i))) {
            judged.errors[i] = earlier->errors[i];
            judged.failed[i] = earlier->failed[i];
            return;
        }
        const Agreement agreement = judge(c, arguments(c, records.input(i), records.mask(i)), got,
                                          truths.empty() ? nullptr : &truths[i]);
        judged.errors[i] = agreement.error;
        judged.failed[i] = agreement.pass ? 0 : 1;
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, records.size(), records_per_task),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) judge_one(i);
                      });
    return judged;
}

void add_judged(const Case& c, const Records& records, std::size_t begin, const Judged& judged,
                CheckReport& report) {
    if (judged.errors.empty()) return;
    report.failures += static_cast<std::size_t>(std::ranges::count(judged.failed, 1));
    if (report.failures > 0) report.verdict = Verdict::wrong;
    const auto worst =
        static_cast<std::size_t>(std::ranges::max_element(judged.errors) - judged.errors.begin());
    if (report.worst && report.worst->error >= judged.errors[worst]) return;
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    report.worst =
        make_finding(c, records, worst, begin + worst,
                     std::span(judged.results).subspan(worst * components, components), judged.errors[worst]);
}

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
