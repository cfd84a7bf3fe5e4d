#include "casegen/capture.h"
#include "casegen/catalogue.h"
#include "casegen/check.h"
#include "casegen/csv.h"
#include "casegen/standalone.h"
#include "casegen/versus/side.h"
#include "cli/commands.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

namespace gnomon::cli {
namespace {

struct EvalCommand {
    std::string kernel;
    std::filesystem::path in, out, file;
    std::string at, expect;
    std::vector<std::string> readings;
    bool reference = false;
};

/// The words of the columns that --expect names. Throws Error if a cell is no such value.
std::vector<std::uint32_t> expected_words(const Case& c, const Csv& csv, const std::string& name) {
    std::vector<std::uint32_t> words;
    for (std::size_t row = 0; row < csv.rows.size(); ++row)
        for (const std::string& title : result_columns(c, name)) {
            const std::size_t column = csv.column(title);
            words.push_back(
                parse_word(c.reference.result.scalar, csv.rows[row][column], csv.place(row, column)));
        }
    return words;
}

/// Says how many results are not what `name` says; 1 if any is not.
int judge(const Case& c, const Csv& csv, const std::string& name, std::span<const std::uint32_t> wanted,
          std::span<const std::uint32_t> got) {
    const std::vector<std::size_t> rows = differing_rows(c, wanted, got);
    if (rows.empty()) {
        fmt::print(stderr, "gnomon: {}: all {} results are those of column {}, bit for bit\n", c.name,
                   csv.rows.size(), name);
        return 0;
    }
    fmt::print(stderr, "gnomon: {}: {} of {} results are not those of column {}; the first is row {}\n",
               c.name, rows.size(), csv.rows.size(), name, rows.front() + 1);
    return 1;
}

void run(const EvalCommand& options, const Common& common, int& exit_code) {
    const Case& c = find_case(options.kernel);
    if (options.in.empty() == options.at.empty()) throw Error("eval takes either --in FILE or --at VALUES");
    const Csv csv = options.at.empty()
                        ? read_csv(options.in)
                        : parse_csv(fmt::format("{}\n{}\n", fmt::join(columns(c), ","), options.at), "--at");
    const std::vector<CsvInput> inputs = read_inputs(c, csv);
    std::vector<std::string> header = csv.header;
    for (const std::string added : {"result", "reference"}) {
        if (added == "reference" && !options.reference) continue;
        for (const std::string& name : result_columns(c, added)) {
            if (std::ranges::find(csv.header, name) != csv.header.end())
                throw Error("{}: has a column \"{}\" already, which eval would add; rename it", csv.name,
                            name);
            header.push_back(name);
        }
    }
    std::vector<std::uint32_t> expected;
    if (!options.expect.empty()) expected = expected_words(c, csv, options.expect);
    const Readings readings = parse_readings(options.readings);
    if (!options.out.empty()) require_writable(options.out);

    Records records(c);
    for (const CsvInput& input : inputs) records.add(input.words, &input.mask);
    gpu::Device device(common.device);
    glsl::Sources sources = kernel_sources(common.kernels, readings);
    if (!options.file.empty()) sources.overlaid[c.name + ".glsl"] = versus::text_for(c, options.file);
    const Outputs outputs = evaluate(device, sources, c, records);
    require_no_validation_messages();
    // Of a kernel that must fail even an unwritten result is no surprise: it reads as NaN.
    if (const std::string complaint = outputs.complaint(); !complaint.empty() && c.fails.empty())
        throw Error("{}: {}; gnomon check {} tells more", c.name, complaint, c.name);

    std::string text = fmt::format("{}\n", fmt::join(header, ","));
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    const Scalar scalar = c.reference.result.scalar;
    for (std::size_t row = 0; row < inputs.size(); ++row) {
        std::vector<std::string> cells = csv.rows[row];
        for (std::size_t k = 0; k < components; ++k)
            cells.push_back(format_word(scalar, outputs.words[row * components + k]));
        if (options.reference) {
            const Arguments with = arguments(c, inputs[row].words, &inputs[row].mask);
            const bool defined = in_domain(c, with);
            const Numbers want = defined ? c.reference.call(with) : Numbers{};
            for (std::size_t k = 0; k < components; ++k)
                cells.push_back(defined ? format_word(scalar, narrow(scalar, want[k])) : "undefined");
        }
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    if (options.out.empty())
        fmt::print("{}", text);
    else
        write_file(options.out, text);
    if (!options.expect.empty()) exit_code = judge(c, csv, options.expect, expected, outputs.words);
}

} // namespace

void add_eval(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb =
        app.add_subcommand("eval", "run a kernel on your own inputs (CSV; columns as in describe)");
    auto options = std::make_shared<EvalCommand>();
    verb->add_option("KERNEL", options->kernel, "as gnomon list prints it: smsr/case_09")->required();
    verb->add_option("--in", options->in, "CSV file with a header row");
    verb->add_option("--out", options->out,
                     "CSV file to write: the input's columns and `result` (default: print)");
    verb->add_option("--at", options->at,
                     "one input on the command line: the values of all columns, in their order");
    verb->add_option("--file", options->file, "a GLSL file that is run in place of the kernel's own")
        ->check(not_empty());
    verb->add_flag("--reference", options->reference,
                   "add the reference's value as `reference` (`undefined` outside the kernel's domain)");
    verb->add_option("--expect", options->expect,
                     "column that the results must equal, bit for bit (exit code 1 if any does not); "
                     "gnomon capture writes one: captured")
        ->check(not_empty());
    add_reading_option(*verb, options->readings);
    verb->footer("Numbers are decimal, or hexadecimal floats that name every bit (0x1.8p-1); nan and inf are "
                 "numbers too.\n\n"
                 "  gnomon eval smsr/case_09 --in inputs.csv --out outputs.csv --reference\n"
                 "  gnomon eval smsr/case_09 --at 0.5,0x1p-2,0.75 --reference\n"
                 "  gnomon eval smsr/visibility --at '..#/###,lit,0,0,0.5,0.5'");
    verb->callback([options, &common, &exit_code] { run(*options, common, exit_code); });
}

} // namespace gnomon::cli
