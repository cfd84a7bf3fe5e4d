// What a comparison and the child that does it say to each other: CBOR, in which infinities survive.
#pragma once

#include "casegen/versus/report.h"

#include <string>

namespace gnomon::versus {

enum class Question { same_code, run_a, run_b, difference, draw, time };

struct Request {
    Question question = Question::run_a;
    std::string a, b; ///< the kernels' names
};

/// What the child says; the part that was asked for is set.
struct Reply {
    std::string timeout;  ///< a kernel did not end: what the device said; the child is of no more use
    std::string obstacle; ///< why else there is no answer; a side that does not compile says so itself
    bool same_code = false;
    SideReport side;
    DifferenceReport difference;
    PictureReport picture;
    measure::Pairing time;
};

std::string format_request(const Request& request);
Request parse_request(const std::string& bytes);
/// Only the part that answers `question`.
std::string format_reply(const Reply& reply, Question question);
Reply parse_reply(const std::string& bytes, Question question);

} // namespace gnomon::versus
