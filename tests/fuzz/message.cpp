// What a campaign and its workers say to each other.
#include "casegen/fuzz/message.h"
#include "tests/fuzz/target.h"

FUZZ_TARGET(message) {
    using namespace gnomon;
    const std::string text(fuzzing::text_of(data, size));
    fuzz::Request request;
    if (fuzzing::is_read([&] { request = fuzz::parse_request(text); })) {
        const std::string again = fuzz::format_request(request);
        REQUIRE(fuzz::format_request(fuzz::parse_request(again)) == again);
    }
    fuzz::Reply reply;
    if (fuzzing::is_read([&] { reply = fuzz::parse_reply(text); })) {
        const std::string again = fuzz::format_reply(reply);
        REQUIRE(fuzz::format_reply(fuzz::parse_reply(again)) == again);
        if (reply.result) // what a campaign writes to files
            for (const fuzz::Found& found : reply.result->found) {
                if (found.regression.input.words.empty()) continue;
                fuzz::format_regression(found.regression);
                fuzz::file_name(found.regression);
            }
    }
    return 0;
}
