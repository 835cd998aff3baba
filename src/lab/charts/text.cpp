// SPDX-License-Identifier: MIT
#include "lab/charts/text.h"

namespace ballpit {

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string html_text(std::string_view text) {
  const std::string tags = replaced(replaced(replaced(std::string(text), "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
  return replaced(tags, "\"", "&quot;");
}

}  // namespace ballpit
