// SPDX-License-Identifier: MIT
#include "render/theme.h"

#include "core/error.h"

namespace ballpit {

namespace {

Vec3 rgb(unsigned hex) { return Vec3(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u) / 255.0f; }

Theme base_theme() {
  Theme theme;
  theme.body = rgb(0x8FA9C4);
  theme.contact = rgb(0xE69F00);
  theme.grid = rgb(0x009E73);
  theme.domain = rgb(0xE69F00);
  theme.candidate = rgb(0x56B4E9);
  theme.missed = rgb(0xD55E00);
  theme.selected = rgb(0xCC79A7);
  theme.begin = rgb(0x0072B2);
  theme.idle = rgb(0x808080);
  theme.on_body = rgb(0x1A1A1A);
  return theme;
}

Theme projector() {
  Theme theme = base_theme();
  theme.name = "projector";
  theme.label = "Projector (white)";
  theme.background = rgb(0xFFFFFF);
  theme.text = rgb(0x1A1A1A);
  theme.floor = rgb(0xEEF0F2);
  theme.shadow = 0.45f;
  theme.ambient = 0.55f;
  theme.key = 0.62f;
  return theme;
}

Theme dark() {
  Theme theme = base_theme();
  theme.name = "dark";
  theme.label = "Dark";
  theme.background = rgb(0x14171C);
  theme.text = rgb(0xE8EAED);
  theme.floor = rgb(0x23272E);
  theme.shadow = 0.6f;
  theme.ambient = 0.38f;
  theme.key = 0.65f;
  return theme;
}

}  // namespace

const std::vector<Theme>& themes() {
  static const std::vector<Theme> table = {projector(), dark()};
  return table;
}

const Theme& theme_named(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Theme& theme : themes()) {
    if (theme.name == name) return theme;
    names.push_back(theme.name);
  }
  throw UserError("--theme", name, join(names));
}

}  // namespace ballpit
