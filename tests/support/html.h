// Whether a page is one that a browser reads as it was meant.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace gnomon::testing {

/// The first element that is not closed, or closes another; "" if all do. Scripts and styles are skipped.
inline std::string first_unbalanced(const std::string& page) {
    constexpr std::array voids{"meta", "img", "input", "br", "link", "!doctype"};
    std::vector<std::string> open;
    for (std::size_t at = page.find('<'); at != page.npos; at = page.find('<', at + 1)) {
        const std::size_t end = page.find('>', at);
        if (end == page.npos) return page.substr(at, 40);
        const std::string tag = page.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
        at = end;
        if (tag.ends_with('/') || std::find(voids.begin(), voids.end(), name) != voids.end()) continue;
        if (!tag.starts_with('/')) {
            open.push_back(name);
            if (name == "script" || name == "style") at = page.find("</" + name, end) - 1;
            continue;
        }
        if (open.empty() || tag.substr(1) != open.back()) return "<" + tag + ">";
        open.pop_back();
    }
    return open.empty() ? "" : "<" + open.back() + ">";
}

/// Balanced, every id once, every link to one of them, and nothing from elsewhere.
inline void expect_whole_page(const std::string& page) {
    EXPECT_EQ(first_unbalanced(page), "");
    std::set<std::string> ids;
    const auto each = [&](const std::string& attribute, auto&& visit) {
        const std::string begin = " " + attribute + "=\"";
        for (std::size_t at = page.find(begin); at != page.npos; at = page.find(begin, at + 1)) {
            const std::size_t from = at + begin.size();
            visit(page.substr(from, std::min(page.find('"', from) - from, std::size_t{80})));
        }
    };
    each("id", [&](const std::string& id) { EXPECT_TRUE(ids.insert(id).second) << id << " names two"; });
    each("href", [&](const std::string& to) {
        EXPECT_TRUE(to.starts_with('#') && ids.contains(to.substr(1))) << to;
    });
    each("src", [&](const std::string& from) { EXPECT_TRUE(from.starts_with("data:")) << from; });
    std::string text = page;
    const std::string name_space = "xmlns=\"http://www.w3.org/2000/svg\""; // a name, not an address
    for (std::size_t at = text.find(name_space); at != text.npos; at = text.find(name_space, at))
        text.erase(at, name_space.size());
    for (const char* part :
         {"http:", "https:", "@import", "url(", "/tmp/", "/home/", ">nan", "\"nan", ",nan", " nan"})
        EXPECT_EQ(text.find(part), text.npos) << part;
}

} // namespace gnomon::testing
