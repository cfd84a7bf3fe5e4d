// The frame of a report's page: one file that needs nothing but itself.
#pragma once

#include <string>

namespace gnomon::measure {

std::string html_page(const std::string& title, const std::string& body);

/// A picture in the page; nothing for an empty one.
std::string figure(const std::string& svg);

} // namespace gnomon::measure
