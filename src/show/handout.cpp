// SPDX-License-Identifier: MIT
#include "show/handout.h"

#include <fmt/format.h>

#include "core/file.h"
#include "core/language.h"
#include "handout_text.h"
#include "methods/choices.h"

namespace ballpit {

namespace {

/// For text and attributes of HTML.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string section_of(const HandoutPicture& picture) {
  std::string notes;
  if (!picture.notes.empty()) {
    notes =
        fmt::format("<details><summary>{}</summary><p>{}</p></details>\n", translated("Notes"), escaped(picture.notes));
  }
  return fmt::format(
      "<section id=\"{}\">\n<h2>{}</h2>\n<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n<p>{}</p>\n{}</section>\n",
      escaped(picture.id), escaped(picture.title), escaped(picture.caption), base64(picture.png),
      escaped(picture.caption), notes);
}

void replace(std::string& text, std::string_view name, std::string_view value) {
  const size_t at = text.find(name);
  if (at != std::string::npos) text.replace(at, name.size(), value);
}

}  // namespace

std::string handout_page(std::string_view title, const std::vector<HandoutPicture>& pictures) {
  std::string sections;
  for (const HandoutPicture& picture : pictures) sections += section_of(picture);
  std::string page(handout_text().front().text);
  replace(page, "{lang}", name_of(language()));
  replace(page, "{title}", escaped(title));
  replace(page, "{pages}", sections);
  return page;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t k = 0; k < bytes.size(); k += 3) {
    unsigned group = 0;
    for (size_t i = 0; i < 3; ++i)
      group = group << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0u);
    for (size_t i = 0; i < 4; ++i) result += k + i <= bytes.size() ? kDigits[group >> (18 - 6 * i) & 63] : '=';
  }
  return result;
}

}  // namespace ballpit
