// SPDX-License-Identifier: MIT
// What HTML and SVG need of texts.
#pragma once

#include <string>
#include <string_view>

namespace ballpit {

/// With &, <, > and " as entities.
std::string html_text(std::string_view text);

/// "data:image/svg+xml;base64,…": a picture inside the page.
std::string svg_address(std::string_view svg);

}  // namespace ballpit
