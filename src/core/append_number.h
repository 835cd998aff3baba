// SPDX-License-Identifier: MIT
// Numbers as files hold them.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace ballpit {

/// Appends the shortest text that reads back as the same double: "0.1", "1e-06", "nan".
inline void append_number(std::string& text, double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  text.append(buffer.data(), end);
}

}  // namespace ballpit
