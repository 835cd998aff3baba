// SPDX-License-Identifier: MIT
// `show --remember` stores scene, options, view and the window's size as JSON in the user's configuration folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "show/options.h"
#include "show/view.h"

namespace ballpit {

struct Remembered {
  std::string scene;               ///< name, or path of a file
  std::vector<GivenOption> given;  ///< shared options that were set
  View view;                       ///< without the picked sphere
  PictureSize size;                ///< of the window
};

/// $XDG_CONFIG_HOME/ballpit/show.json, or ~/.config/ballpit/show.json. Throws UserError if neither is known.
std::filesystem::path remembered_file();

/// Empty if there is no such file yet. Throws UserError naming the file if it cannot be read, or if this version does
/// not write such files.
std::optional<Remembered> read_remembered(const std::filesystem::path& file);

/// Throws RunError if write_remembered() would; changes nothing.
void check_remembered(const std::filesystem::path& file);

/// Throws RunError naming the file.
void write_remembered(const std::filesystem::path& file, const Remembered& remembered);

}  // namespace ballpit
