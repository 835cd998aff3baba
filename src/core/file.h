// SPDX-License-Identifier: MIT
// Files written whole or not at all: beside their place first, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ballpit {

/// Writes `bytes` to `path` through a temporary file in the same folder, which is removed on failure.
/// Throws RunError naming the path and the system's reason (no space, no permission, …).
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The whole content of a file. Throws UserError naming the path and the system's reason.
std::string read_file(const std::filesystem::path& path);

}  // namespace ballpit
