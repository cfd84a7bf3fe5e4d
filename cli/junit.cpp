#include "cli/junit.h"

#include "casegen/atlas/html.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::cli {

std::string junit_xml(const std::string& suite, std::span<const JunitCase> cases) {
    using atlas::escape_html;
    const auto failed =
        std::ranges::count_if(cases, [](const JunitCase& one) { return !one.failure.empty(); });
    std::string text = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                   "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n",
                                   escape_html(suite), cases.size(), failed);
    for (const JunitCase& one : cases) {
        text += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"",
                            escape_html(one.group), escape_html(one.name), one.seconds);
        if (one.failure.empty())
            text += "/>\n";
        else
            text += fmt::format(">\n    <failure type=\"{0}\" message=\"{0}\">{1}</failure>\n  </testcase>\n",
                                escape_html(one.failure), escape_html(one.text));
    }
    return text + "</testsuite>";
}

} // namespace gnomon::cli
