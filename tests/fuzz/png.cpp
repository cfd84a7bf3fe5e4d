// Images: any PNG, and masks in PNG.
#include "casegen/mask.h"
#include "runtime/image.h"
#include "tests/fuzz/target.h"

FUZZ_TARGET(png) {
    using namespace gnomon;
    static const fuzzing::InputFile file("image.png");
    const std::filesystem::path& path = file.write(fuzzing::text_of(data, size));
    Image image;
    if (fuzzing::is_read([&] { image = read_png(path); })) {
        REQUIRE(image.width > 0 && image.height > 0);
        REQUIRE(image.pixels.size() ==
                static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    }
    fuzzing::is_read([&] { load_mask(path); });
    return 0;
}
