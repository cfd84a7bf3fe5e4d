#include "casegen/measure/page.h"

#include "casegen/atlas/html.h"

#include <fmt/format.h>

namespace gnomon::measure {
namespace {

// Pictures are drawn for paper (they are files of their own, too): by night their colours are exchanged here,
// one by one, for ones that can be told apart on a dark card.
constexpr const char* style = R"(
:root { color-scheme: light dark; --page: #fbfaf7; --card: #fff; --ink: #1d2129; --soft: #5d6470; --rule: #dedbd2;
  --link: #1c5d99; --good: #27703a; --bad: #b3170a; --wash: #f2f0ea; }
@media (prefers-color-scheme: dark) {
  :root { --page: #14161b; --card: #1b1e25; --ink: #e4e3df; --soft: #9aa1ad; --rule: #323743; --link: #82b4e6;
    --good: #7cc78d; --bad: #ff8a78; --wash: #232730; }
  svg { fill: #e4e3df; } svg [fill="#fff"] { fill: #1b1e25; } svg [fill="#5d6470"] { fill: #9aa1ad; }
  svg [stroke="#5d6470"] { stroke: #9aa1ad; } svg [stroke="#e4e1d9"] { stroke: #373c48; }
  svg [stroke="#f1efe9"] { stroke: #272b34; } svg [stroke="#d5d2c8"] { stroke: #373c48; }
  svg [stroke="#eeece6"] { stroke: #272b34; } svg [fill="#9a9a94"] { fill: #7d828c; } svg [stroke="#9a9a94"] { stroke: #7d828c; }
  svg [fill="#f6e3df"] { fill: #3d2320; } svg [fill="#8a5248"] { fill: #d69a8f; }
  svg [fill="#e6f1e6"] { fill: #1f3324; } svg [fill="#3f6b45"] { fill: #93c79b; }
  svg [fill="#332288"] { fill: #9a94f0; } svg [stroke="#332288"] { stroke: #9a94f0; }
  svg [fill="#117733"] { fill: #4fb873; } svg [stroke="#117733"] { stroke: #4fb873; }
  svg [fill="#882255"] { fill: #d9709f; } svg [stroke="#882255"] { stroke: #d9709f; }
  svg [fill="#777711"] { fill: #b8b84a; } svg [stroke="#777711"] { stroke: #b8b84a; }
  svg [fill="#aa4499"] { fill: #d783c8; } svg [stroke="#aa4499"] { stroke: #d783c8; }
}
body { margin: 0 auto; max-width: 84rem; padding: 2rem 1.5rem 5rem; color: var(--ink); background: var(--page);
  font: 16px/1.5 "Source Sans 3", "Segoe UI", system-ui, "DejaVu Sans", sans-serif; }
h1, h2 { line-height: 1.2; } h2 { margin: 3rem 0 .4rem; } h3 { margin: 1.6rem 0 .2rem; font-size: 1.05rem; }
p { margin: 0 0 .4rem; } .soft { color: var(--soft); font-size: .92rem; max-width: 68rem; }
a, summary { color: var(--link); } nav { margin: 1rem 0 0; } nav a { margin-right: 1.1rem; white-space: nowrap; }
.wide, figure { overflow-x: auto; } figure { margin: 1.2rem 0 0; border: 1px solid var(--rule); border-radius: 8px; background: var(--card); }
figure svg { display: block; }
table { border-collapse: collapse; margin: .6rem 0 0; font-size: .9rem; background: var(--card); }
caption { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
th, td { padding: .25rem .6rem; text-align: left; border-bottom: 1px solid var(--rule); white-space: nowrap; }
th { font-size: .8rem; color: var(--soft); } .number { text-align: right; font-variant-numeric: tabular-nums; }
th button { all: unset; cursor: pointer; } th button:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
th[aria-sort=ascending] button::after { content: " \25B2"; } th[aria-sort=descending] button::after { content: " \25BC"; }
.sortable .wide { max-height: 44rem; overflow: auto; border: 1px solid var(--rule); border-radius: 8px; margin: .6rem 0 0; }
.sortable table { margin: 0; font-size: .84rem; } .sortable td, .sortable th { padding: .22rem .5rem; } .sortable + p, .sortable p { margin-top: .6rem; } .sortable th { position: sticky; top: 0; background: var(--wash); }
form { margin: 1rem 0 0; color: var(--soft); font-size: .92rem; }
input { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--rule); border-radius: 6px; padding: .2rem .5rem; }
details { margin: 1rem 0 0; } summary { cursor: pointer; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 36rem), 1fr)); gap: 1rem; margin: 1rem 0 0; }
.pair { margin: 0; padding: .6rem; } .pair img { width: calc(50% - .3rem); height: auto; border-radius: 4px; vertical-align: top; }
.pair img + img { margin-left: .6rem; } figcaption { margin: 0 0 .4rem; font-size: .92rem; }
.bad { color: var(--bad); font-weight: 600; } .good { color: var(--good); }
)";

// Without it every table is whole, in the order it was written in.
constexpr const char* script = R"js("use strict";
for (const box of document.querySelectorAll(".sortable")) {
    const table = box.querySelector("table"), body = table.tBodies[0], form = box.querySelector("form");
    const heads = [...table.tHead.rows[0].cells], rows = [...body.rows];
    const value = (cell) => {
        const text = cell.textContent.trim();
        if (text === "" || text === "-") return null;
        const number = text === "inf" ? Infinity : Number.parseFloat(text.replace(/^</, ""));
        return Number.isFinite(number) ? number : text;
    };
    const order = (a, b) => {
        if (a === null || b === null) return (a === null) - (b === null);
        if (typeof a === "number" && typeof b === "number") return a === b ? 0 : a < b ? -1 : 1;
        return String(a).localeCompare(String(b));
    };
    heads.forEach((head, k) => {
        const button = document.createElement("button");
        button.type = "button";
        button.append(...head.childNodes);
        head.append(button);
        button.addEventListener("click", () => {
            const down = head.getAttribute("aria-sort") === "ascending";
            for (const other of heads) other.removeAttribute("aria-sort");
            head.setAttribute("aria-sort", down ? "descending" : "ascending");
            const keyed = rows.map((row) => [value(row.cells[k]), row]);
            keyed.sort(([a], [b]) => (down && a !== null && b !== null ? -order(a, b) : order(a, b)));
            body.append(...keyed.map(([, row]) => row));
        });
    });
    const search = () => {
        const words = form.elements.search.value.toLowerCase().split(/\s+/).filter(Boolean);
        let shown = 0;
        for (const row of rows) {
            const text = row.textContent.toLowerCase();
            row.hidden = !words.every((word) => text.includes(word));
            if (!row.hidden) ++shown;
        }
        form.querySelector("output").value = `${shown} of ${rows.length}`;
    };
    form.addEventListener("input", search);
    form.addEventListener("submit", (event) => event.preventDefault());
    form.hidden = false;
    search();
}
)js";

} // namespace

std::string html_page(const std::string& title, const std::string& body) {
    const bool sortable = body.find("class=\"sortable\"") != body.npos;
    return fmt::format("<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width\">\n"
                       "<title>{}</title>\n<style>{}</style>\n<body>\n{}{}</body>\n</html>\n",
                       atlas::escape_html(title), style, body,
                       sortable ? fmt::format("<script>{}</script>\n", script) : "");
}

std::string figure(const std::string& svg) { return svg.empty() ? "" : "<figure>" + svg + "</figure>\n"; }

} // namespace gnomon::measure
