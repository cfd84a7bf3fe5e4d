// What a frame did without, and why it could.
#pragma once

#include <string>

namespace gnomon {

struct LeftOut {
    std::string step; ///< of the five: "create maps"
    std::string what; ///< "the ray buffer and the BVH"
    std::string why;  ///< "no pixel is uncertain"
};

} // namespace gnomon
