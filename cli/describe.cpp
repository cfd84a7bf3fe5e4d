#include "casegen/catalogue.h"
#include "casegen/csv.h"
#include "casegen/witness.h"
#include "cli/commands.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <sstream>

namespace gnomon::cli {
namespace {

void describe(const Case& c, const std::filesystem::path& kernels) {
    fmt::print("{}\n", signature(c));
    std::istringstream comment(leading_comment(read_file(kernels / (c.name + ".glsl"))));
    for (std::string line; std::getline(comment, line);) fmt::print("  {}\n", line);
    fmt::print("\n");
    fmt::print("source     {}\n", c.source);
    fmt::print("columns    {}\n", fmt::join(columns(c), ","));
    if (c.reference.takes_mask) {
        fmt::print("  {:<10} texels, rows parted by '/', the first is y = 0: # shadow, . lit; \"#./..\"\n",
                   "mask");
        fmt::print("  {:<10} what lies beyond the mask: clamp, lit or shadow\n", "outside");
    }
    for (const Parameter& p : c.parameters)
        fmt::print("  {:<10} {} [{}], {}\n", p.name, to_string(p.domain), p.unit, p.meaning);
    if (c.where) fmt::print("             (not every combination: see `where` in the table)\n");
    fmt::print("result     {:g} to {:g} [{}], {}\n", c.result.lower, c.result.upper, c.result.unit,
               c.result.meaning);
    fmt::print("tolerance  {}{}{}\n", to_string(c.tolerance),
               c.within ? "; and within bounds besides: see `within` in the table" : "",
               c.defended ? "; for inputs outside the ranges above: any result within its range, never NaN"
                          : "");
    if (!c.rule.empty()) fmt::print("otherwise  {}\n", c.rule);
    if (!c.fails.empty()) fmt::print("must fail  {}\n", c.fails);
    if (!c.quantity.empty()) {
        fmt::print("computes   {}, as do:", c.quantity);
        for (const Case* other : find_cases(""))
            if (other->quantity == c.quantity && other != &c) fmt::print(" {}", other->name);
        fmt::print("\n");
    }
    if (c.generator) {
        std::vector<std::string> names;
        for (const Locus& locus : c.generator->loci) names.push_back(locus.name);
        fmt::print("stiff at   {}\n", fmt::join(names, "; "));
    }
    if (c.number == 0) return;
    fmt::print("applies to {}\n", in_words(c.condition));
    fmt::print("value      {}\n", c.formula);
    if (const auto witness = smallest_witness(c)) {
        fmt::print("witness    texel {},{} of this mask, {} outside, leads to the case:\n", witness->texel.x,
                   witness->texel.y, to_string(witness->mask.outside));
        fmt::print("  {}\n", fmt::join(std::vector{format_mask(witness->mask, '\n')}, ""));
    }
}

} // namespace

void add_describe(CLI::App& app, Common& common) {
    CLI::App* verb =
        app.add_subcommand("describe", "show a kernel's signature, columns, ranges, tolerance and source");
    auto name = std::make_shared<std::string>();
    verb->add_option("KERNEL", *name, "as gnomon list prints it: smsr/case_09")->required();
    verb->callback([name, &common] { describe(find_case(*name), common.kernels); });
}

} // namespace gnomon::cli
