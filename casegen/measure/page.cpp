#include "casegen/measure/page.h"

#include "casegen/atlas/html.h"

#include <fmt/format.h>

namespace gnomon::measure {
namespace {

constexpr const char* style = R"(
body { margin: 0 auto; max-width: 84rem; padding: 2rem 1.5rem 5rem; color: #1d2129; background: #fbfaf7;
  font: 16px/1.5 "Source Sans 3", "Segoe UI", system-ui, "DejaVu Sans", sans-serif; }
h1, h2 { line-height: 1.2; } h2 { margin: 3rem 0 .4rem; } h3 { margin: 1.6rem 0 .2rem; font-size: 1.05rem; }
p { margin: 0 0 .4rem; } .soft { color: #5d6470; font-size: .92rem; }
.wide, figure { overflow-x: auto; } figure { margin: 1.2rem 0 0; border: 1px solid #dedbd2; border-radius: 8px; background: #fff; }
figure svg { display: block; }
table { border-collapse: collapse; margin: .6rem 0 0; font-size: .9rem; background: #fff; }
th, td { padding: .25rem .6rem; text-align: left; border-bottom: 1px solid #dedbd2; white-space: nowrap; }
th { font-size: .8rem; color: #5d6470; } .number { text-align: right; font-variant-numeric: tabular-nums; }
details { margin: 1rem 0 0; } summary { cursor: pointer; color: #1c5d99; }
)";

} // namespace

std::string html_page(const std::string& title, const std::string& body) {
    return fmt::format("<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width\">\n"
                       "<title>{}</title>\n<style>{}</style>\n<body>\n{}</body>\n</html>\n",
                       atlas::escape_html(title), style, body);
}

std::string figure(const std::string& svg) { return svg.empty() ? "" : "<figure>" + svg + "</figure>\n"; }

} // namespace gnomon::measure
