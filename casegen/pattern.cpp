#include "casegen/pattern.h"

#include "runtime/error.h"

#include <fnmatch.h>

#include <algorithm>

namespace gnomon {

std::vector<std::string> split_patterns(const std::string& patterns) {
    if (patterns.empty()) return {""};
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= patterns.size();) {
        const std::size_t end = std::min(patterns.find(',', at), patterns.size());
        if (end == at) throw Error("a pattern in \"{}\" is empty; commas stand between patterns", patterns);
        parts.push_back(patterns.substr(at, end - at));
        at = end + 1;
    }
    return parts;
}

bool matches(const std::string& name, const std::string& patterns) {
    return std::ranges::any_of(split_patterns(patterns), [&](const std::string& part) {
        const bool glob = part.find_first_of("*?[") != std::string::npos;
        return glob ? fnmatch(part.c_str(), name.c_str(), 0) == 0 : name.find(part) != std::string::npos;
    });
}

std::string exactly_named(const std::string& name) { return "[" + name.substr(0, 1) + "]" + name.substr(1); }

} // namespace gnomon
