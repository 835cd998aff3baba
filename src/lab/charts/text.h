// SPDX-License-Identifier: MIT
// Text that has to be changed to stand in scripts, tables and pages.
#pragma once

#include <string>
#include <string_view>

namespace ballpit {

/// The text with `with` in all places of `what`.
std::string replaced(std::string text, std::string_view what, std::string_view with);

/// For HTML and SVG: with &, <, > and " as entities.
std::string html_text(std::string_view text);

}  // namespace ballpit
