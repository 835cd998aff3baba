// SPDX-License-Identifier: MIT
// What `show --remember` keeps from one start to the next: scene, options, view and the window's size, as JSON in the user's
// configuration folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "show/given_options.h"
#include "show/view.h"

namespace ballpit {

struct Remembered {
  std::string scene;               ///< by name, or a file
  std::vector<GivenOption> given;  ///< shared options that were set
  View view;                       ///< without the picked sphere
  std::string size;                ///< of the window, "1600x900"
};

/// $XDG_CONFIG_HOME/ballpit/show.json, or ~/.config/ballpit/show.json. Throws UserError where neither is known.
std::filesystem::path remembered_file();

/// None where there is no such file yet. Throws UserError naming the file where it cannot be read, or is not what this version
/// writes.
std::optional<Remembered> read_remembered(const std::filesystem::path& file);

/// Throws RunError where write_remembered() would; changes nothing.
void check_remembered(const std::filesystem::path& file);

/// Throws RunError naming the file.
void write_remembered(const std::filesystem::path& file, const Remembered& remembered);

}  // namespace ballpit
