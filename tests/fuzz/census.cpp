// Shares of cases, as gnomon census writes them.
#include "casegen/atlas/frequency.h"
#include "tests/fuzz/target.h"

FUZZ_TARGET(census) {
    using namespace gnomon;
    static const fuzzing::InputFile file("shares.json");
    atlas::Census census;
    if (!fuzzing::is_read([&] { census = atlas::read_census(file.write(fuzzing::text_of(data, size))); }))
        return 0;
    for (const auto& [family, shares] : census.shares)
        for (const auto& [number, share] : shares) REQUIRE(share >= 0 && share <= 1);
    return 0;
}
