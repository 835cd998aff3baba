// SPDX-License-Identifier: MIT
// A text file compiled into the program; cmake/embed.cmake generates tables of them.
#pragma once

#include <string_view>

namespace ballpit {

struct EmbeddedFile {
  std::string_view name;  ///< "bouncing-balls.toml"
  std::string_view text;
};

}  // namespace ballpit
