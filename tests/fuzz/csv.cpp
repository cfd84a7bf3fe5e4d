// CSV tables: any, and as inputs of kernels (of eval, and the files of pins and worst inputs). The first byte
// chooses the kernel.
#include "casegen/csv.h"
#include "casegen/catalogue.h"
#include "tests/fuzz/target.h"

#include <array>

FUZZ_TARGET(csv) {
    using namespace gnomon;
    if (size == 0) return 0;
    static const std::array kernels{&find_case("smsr/case_09"), &find_case("smsr/visibility"),
                                    &find_case("revectorize/walk"), &find_case("rsmss/decision")};
    const Case& c = *kernels[data[0] % kernels.size()];
    Csv csv;
    if (!fuzzing::is_read([&] { csv = parse_csv(fuzzing::text_of(data + 1, size - 1), "table"); })) return 0;
    REQUIRE(!csv.rows.empty());
    for (const std::vector<std::string>& row : csv.rows) REQUIRE(row.size() == csv.header.size());
    std::vector<CsvInput> inputs;
    if (!fuzzing::is_read([&] { inputs = read_inputs(c, csv); })) return 0;
    REQUIRE(inputs.size() == csv.rows.size());
    for (const CsvInput& input : inputs) {
        REQUIRE(input.words.size() == word_count(c));
        REQUIRE(c.reference.takes_mask == !input.mask.texels.empty());
        for (std::size_t i = 0; i < input.words.size(); ++i) {
            const std::string cell = format_word(c.reference.words[i], input.words[i]);
            if (cell == "nan") continue;
            REQUIRE(parse_word(c.reference.words[i], cell, "again") == input.words[i]);
        }
        in_domain(c, arguments(c, input.words, &input.mask));
    }
    return 0;
}
