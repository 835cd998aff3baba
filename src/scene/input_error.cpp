// SPDX-License-Identifier: MIT
#include "scene/input_error.h"

#include <algorithm>

#include <fmt/format.h>

namespace ballpit {

namespace {

/// Length of the UTF-8 character at the start of `text`, 0 if there is none. Overlong forms are accepted.
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
  std::string result;
  while (!text.empty()) {
    const auto byte = static_cast<unsigned char>(text[0]);
    const size_t length = byte < 0x20 || byte == 0x7F ? 0 : character_length(text);
    result += length == 0 ? fmt::format("\\x{:02X}", byte) : std::string(text.substr(0, length));
    text.remove_prefix(std::max<size_t>(length, 1));
  }
  return result;
}

UserError input_error(const Place& place, std::string_view key, std::string_view found, std::string_view allowed) {
  const std::string where = fmt::format("{}:{}{}{}", place.file, place.line, key.empty() ? "" : ": ", key);
  return {visible(where), visible(found), visible(allowed)};
}

std::string limits_text(const Limits& limits) { return number_text(limits.low) + " to " + number_text(limits.high); }

std::string in_quotes(std::string_view text) {
  constexpr size_t kMaxLength = 60;
  size_t end = std::min(text.size(), kMaxLength);
  // Cut between characters of UTF-8, not inside one.
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return fmt::format("\"{}{}\"", text.substr(0, end), end < text.size() ? "…" : "");
}

double default_mass(double radius, double density, const Place& place, std::string_view key) {
  const double mass = sphere_mass(radius, density);
  if (kMass.contains(mass)) return mass;
  throw input_error(place, key, fmt::format("{}, which makes a mass of {} kg", number_text(radius), number_text(mass)),
                    limits_text(kMass) + " kg");
}

}  // namespace ballpit
