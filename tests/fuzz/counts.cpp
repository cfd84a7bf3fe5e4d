// The counts that a publication prints.
#include "cli/reproduce/counts.h"
#include "tests/fuzz/target.h"

FUZZ_TARGET(counts) {
    using namespace gnomon;
    static const fuzzing::InputFile file("counts.csv");
    std::vector<cli::PrintedCount> counts;
    if (!fuzzing::is_read(
            [&] { counts = cli::read_printed_counts(file.write(fuzzing::text_of(data, size))); }))
        return 0;
    for (const cli::PrintedCount& count : counts)
        REQUIRE(count.table >= 0 && count.key.width >= 0 && count.key.height >= 0 && count.key.map >= 0);
    return 0;
}
