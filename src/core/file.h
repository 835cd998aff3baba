// SPDX-License-Identifier: MIT
// Files written whole or not at all: beside their place first, then renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ballpit {

/// A file in the making, for what comes piece by piece: it stands beside its place, as PATH.part, until commit() renames it.
/// Left without that, it is removed. Everything throws RunError naming the path and the system's reason (no space, no
/// permission, …).
class NewFile {
 public:
  explicit NewFile(std::filesystem::path path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Appends; where that fails, some of the bytes may stand.
  void write(std::string_view bytes);

  /// Cuts off what stands behind the first `bytes`. Nothing may be written after it.
  void cut_to(int64_t bytes);

  /// Puts the file into its place.
  void commit();

 private:
  std::filesystem::path path_, part_;
  int descriptor_ = -1;
};

/// Writes `bytes` to `path` through a temporary file in the same folder, which is removed on failure.
/// Throws RunError naming the path and the system's reason (no space, no permission, …).
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The whole content of a file. Throws UserError naming the path and the system's reason.
std::string read_file(const std::filesystem::path& path);

}  // namespace ballpit
