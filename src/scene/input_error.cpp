// SPDX-License-Identifier: MIT
#include "scene/input_error.h"

#include <algorithm>

#include "core/append_number.h"

namespace ballpit {

namespace {

/// Length of the UTF-8 character that `text` starts with, 0 if it starts with none. Overlong forms pass.
size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const size_t length = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (length > text.size()) return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
  }
  return length;
}

}  // namespace

std::string visible(std::string_view text) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string result;
  while (!text.empty()) {
    const auto byte = static_cast<unsigned char>(text[0]);
    const size_t length = byte < 0x20 || byte == 0x7F ? 0 : character_length(text);
    if (length == 0) {
      result += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(std::max<size_t>(length, 1));
  }
  return result;
}

UserError input_error(const Place& place, std::string_view key, std::string_view found, std::string_view allowed) {
  std::string where = place.file + ':' + std::to_string(place.line);
  if (!key.empty()) where.append(": ").append(key);
  return {visible(where), visible(found), visible(allowed)};
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string limits_text(const Limits& limits) { return number_text(limits.low) + " to " + number_text(limits.high); }

std::string quoted(std::string_view text) {
  constexpr size_t kLongest = 60;
  std::string result = "\"";
  size_t end = std::min(text.size(), kLongest);
  // Cut between characters of UTF-8, not inside one.
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  result.append(text.substr(0, end));
  return result + (end < text.size() ? "…\"" : "\"");
}

}  // namespace ballpit
