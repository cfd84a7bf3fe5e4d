#include "casegen/measure/hybrid/report.h"

#include "casegen/atlas/html.h"
#include "casegen/measure/hybrid/tables.h"
#include "casegen/measure/page.h"
#include "runtime/files.h"

#include <fmt/format.h>

namespace gnomon::measure {

std::string hybrid_page(const HybridBench& bench) {
    std::string body = "<h1>Hybrid shadows against a ray for every pixel</h1>\n";
    for (const std::string& line : broken_promises(bench))
        body += fmt::format("<p><strong>{}</strong></p>\n", atlas::escape_html(line));
    for (const std::string& remark : remarks(bench))
        body += fmt::format("<p class=\"soft\">{}</p>\n", atlas::escape_html(remark));
    body += figure(hybrid_chart(bench));
    for (const HybridCombination& c : bench.combinations) {
        const Table table = hybrid_table(c);
        body += fmt::format("<h2>{}</h2>\n{}", atlas::escape_html(table.title), to_html(table));
    }
    return html_page("gnomon bench hybrid", body);
}

void write_report(const std::filesystem::path& folder, const HybridBench& bench) {
    write_file(folder / "hybrid_pareto.svg", hybrid_chart(bench));
    write_file(folder / "hybrid.csv", hybrid_csv(bench));
    write_file(folder / "hybrid.json", hybrid_json(bench));
    write_file(folder / "report.html", hybrid_page(bench));
}

} // namespace gnomon::measure
