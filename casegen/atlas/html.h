// Bits of an HTML page that needs nothing but itself.
#pragma once

#include "runtime/image.h"

#include <string>
#include <string_view>

namespace gnomon::atlas {

/// Text for an element or for an attribute in double quotes. Control characters but \n and \t become '?'.
std::string escape_html(std::string_view text);

/// RFC 4648, with padding, without line breaks.
std::string base64(std::string_view bytes);

/// "data:image/png;base64,…".
std::string data_uri(const Image& image);

/// GLSL as HTML text in which comments, directives, keywords with types, and numbers stand in
/// <span class="c">, "d", "k" and "n".
std::string glsl_to_html(std::string_view text);

} // namespace gnomon::atlas
