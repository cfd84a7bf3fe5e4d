// JUnit's XML, for continuous integration: one suite of cases that pass or fail.
#pragma once

#include <span>
#include <string>

namespace gnomon::cli {

struct JunitCase {
    std::string group;   ///< "smsr": the class's name in reports
    std::string name;    ///< "smsr/case_09"
    double seconds = 0;  ///< that it took
    std::string failure; ///< what kind it is, in a word or two; empty if it passes
    std::string text;    ///< of a failure: the lines that tell of it
};

std::string junit_xml(const std::string& suite, std::span<const JunitCase> cases);

} // namespace gnomon::cli
