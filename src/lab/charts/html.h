// SPDX-License-Identifier: MIT
// Text in HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace ballpit {

/// With &, <, > and " as entities.
std::string html_text(std::string_view text);

/// "data:image/svg+xml;base64,…": the address of a picture that the page itself contains.
std::string svg_address(std::string_view svg);

}  // namespace ballpit
