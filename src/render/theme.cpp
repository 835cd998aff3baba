// SPDX-License-Identifier: MIT
#include "render/theme.h"

#include "core/error.h"

namespace ballpit {

const std::vector<Theme>& themes() {
  static const std::vector<Theme> table = {
      {.name = "projector",
       .label = "Projector (white)",
       .background = rgb(0xFFFFFF),
       .text = rgb(0x1A1A1A),
       .floor = rgb(0xEEF0F2),
       .shadow = 0.45f,
       .ambient = 0.55f,
       .key = 0.62f},
      {.name = "dark",
       .label = "Dark",
       .background = rgb(0x14171C),
       .text = rgb(0xE8EAED),
       .floor = rgb(0x23272E),
       .shadow = 0.6f,
       .ambient = 0.38f,
       .key = 0.65f},
  };
  return table;
}

const Theme& theme_named(std::string_view name) { return entry_named(themes(), name, "--theme"); }

}  // namespace ballpit
