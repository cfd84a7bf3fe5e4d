// What a session has to tell.
#pragma once

#include "casegen/measure/verdict.h"
#include "casegen/watch/message.h"

#include <optional>
#include <string>
#include <variant>

namespace gnomon {
struct Case;
}

namespace gnomon::watch {

// An edit is whatever changed at once and changed at least one kernel's text; the
// first check is edit 0. Milliseconds count from when the change was seen.

struct Began {
    std::size_t kernels = 0;
    unsigned workers = 0;
    bool polls = false; ///< the folder; else inotify tells
};
struct Judged {
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    Judgement judgement;                ///< never of the same code
    std::optional<double> worst_before; ///< of the last state that ran
    double milliseconds = 0;
};
struct SameCode { ///< the text is another, what it compiles to is not
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    bool good = false; ///< as it was
    double milliseconds = 0;
};
struct Timed {
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    double before = 0, after = 0; ///< nanoseconds per evaluation: medians, with reading the inputs
    double reading = 0;           ///< of them for reading alone
    bool with_reading = false;    ///< `pace` compares them so: without, nothing would be left
    measure::PaceVerdict pace;
    bool same_results = true; ///< optimised code gives the bits that were judged
};
struct NotTimed {
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    std::string why;
};
/// No verdict is due any more.
struct Settled {
    std::size_t edit = 0, judged = 0, same = 0; ///< kernels since the last one
    std::size_t good = 0, bad = 0;              ///< of all
    double milliseconds = 0;
};
using Event = std::variant<Began, Judged, SameCode, Timed, NotTimed, Settled>;

} // namespace gnomon::watch
