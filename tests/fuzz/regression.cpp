// Files of fixtures/regressions.
#include "casegen/fuzz/regression.h"
#include "tests/fuzz/target.h"

FUZZ_TARGET(regression) {
    using namespace gnomon;
    fuzz::Regression regression;
    if (!fuzzing::is_read(
            [&] { regression = fuzz::parse_regression(fuzzing::text_of(data, size), "regression"); }))
        return 0;
    const std::string text = fuzz::format_regression(regression);
    REQUIRE(fuzz::format_regression(fuzz::parse_regression(text, "again")) == text);
    REQUIRE(fuzz::file_name(regression).find('/') == std::string::npos);
    return 0;
}
