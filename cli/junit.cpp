#include "cli/junit.h"

#include "casegen/atlas/html.h"

#include <boost/locale/encoding_utf.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace gnomon::cli {
namespace {

/// Without what XML cannot hold: bytes that are no UTF-8 and control characters. A message may quote any
/// file.
std::string characters(const std::string& text) {
    std::u32string all = boost::locale::conv::utf_to_utf<char32_t>(text);
    std::erase_if(all, [](char32_t c) {
        return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0xfffe || c == 0xffff;
    });
    return boost::locale::conv::utf_to_utf<char>(all);
}

} // namespace

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
    return characters(text + "</testsuite>");
}

} // namespace gnomon::cli
