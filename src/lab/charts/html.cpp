// SPDX-License-Identifier: MIT
#include "lab/charts/html.h"

#include <algorithm>
#include <cstdint>

namespace ballpit {

std::string html_text(std::string_view text) {
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

std::string svg_address(std::string_view svg) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result = "data:image/svg+xml;base64,";
  for (size_t k = 0; k < svg.size(); k += 3) {
    uint32_t bits = 0;
    const size_t size = std::min<size_t>(3, svg.size() - k);
    for (size_t b = 0; b < 3; ++b) bits = bits << 8 | (b < size ? static_cast<uint8_t>(svg[k + b]) : 0u);
    for (size_t d = 0; d < 4; ++d) result += d <= size ? kDigits[bits >> (18 - 6 * d) & 63u] : '=';
  }
  return result;
}

}  // namespace ballpit
