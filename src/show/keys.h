// SPDX-License-Identifier: MIT
// The keys: one table for the window, the list that F1 shows, and the README.
#pragma once

#include <span>
#include <string_view>

namespace ballpit {

enum class Action {
  pause,
  step,
  step_back,
  restart,
  use_method,
  toggle_overlay,
  change_theme,
  save_picture,
  show_keys,
  reset_view
};

struct Key {
  int code;               ///< as GLFW has it: the ASCII code of letters and digits
  std::string_view name;  ///< as it is printed: "Space"
  std::string_view help;
  Action action;
  std::string_view argument;  ///< a method or an overlay by name
};

inline constexpr int kKeyF1 = 290;

std::span<const Key> key_table();

}  // namespace ballpit
