// Masks as text: files with lines, CSV cells with '/'.
#include "casegen/mask.h"
#include "tests/fuzz/target.h"

FUZZ_TARGET(mask) {
    using namespace gnomon;
    for (const char separator : {'\n', '/'}) {
        Mask mask;
        if (!fuzzing::is_read([&] { mask = parse_mask(fuzzing::text_of(data, size), separator, "mask"); }))
            continue;
        REQUIRE(mask.width > 0 && mask.height > 0);
        REQUIRE(parse_mask(format_mask(mask, separator), separator, "again").texels == mask.texels);
        REQUIRE(transposed(transposed(mask)) == mask);
        REQUIRE(without_isolated(mask).texels.size() == mask.texels.size());
    }
    return 0;
}
