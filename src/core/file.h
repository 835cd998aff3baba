// SPDX-License-Identifier: MIT
// All outputs of the program. A regular file is written whole or not at all: under a temporary name in the same folder, then
// renamed. Links are followed. What is no regular file is written to as it is, and never replaced, removed or shortened.
//
//     out.csv, missing or a regular file   out.csv.part ──rename──▶ out.csv
//     out.csv ─link▶ far/state.csv         far/state.csv.part ──rename──▶ far/state.csv; out.csv stays a link
//     a pipe, a device                     opened and written to; of a pipe, once somebody reads
//     /dev/stdout, /dev/fd/N               written to our own descriptor, whatever it leads to
//
// A file that is replaced keeps its permissions and, where the system allows it, its owner. The temporary file is locked while
// it is written: a second run with the same output takes the name out.csv.2.part, and what an interrupted run has left is
// used again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ballpit {

/// An output in the making, for what comes piece by piece. A regular file stands in its place after commit() only; left
/// without that, its temporary file is removed. Everything throws RunError naming the path and the system's reason (no space,
/// no permission, …).
class NewFile {
 public:
  explicit NewFile(std::filesystem::path path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Appends; where that fails, some of the bytes may stand.
  void write(std::string_view bytes);

  /// Cuts off what stands behind the first `bytes`. Nothing may be written after it. What went into a pipe, a device or a
  /// descriptor cannot be taken back: then it does nothing.
  void cut_to(int64_t bytes);

  /// Puts the file into its place.
  void commit();

 private:
  std::filesystem::path path_;    // as it was given
  std::filesystem::path target_;  // what it leads to
  std::filesystem::path part_;    // the temporary file; empty where there is none
  int descriptor_ = -1;
};

/// Writes `bytes` to `path` as NewFile does.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws now what writing to `path` would throw later, as far as that can be known, and changes nothing. For commands, before
/// they start to work.
void check_output(const std::filesystem::path& path);

/// The same for a folder that is made where it is missing, and for new files in it.
void check_output_folder(const std::filesystem::path& folder);

/// Whether two paths lead to the same file, pipe or device, be it through links; also to one that is still missing.
/// Empty paths lead nowhere.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Makes a folder, and those that it lies in, where they are missing. Throws RunError.
void make_folder(const std::filesystem::path& folder);

/// Appends whole lines to a file that grows, made where it is missing; all at once, so that no end of the program leaves less.
/// Throws RunError.
void append_to_file(const std::filesystem::path& path, std::string_view lines);

/// Shortens such a file to the first `bytes`. Throws RunError.
void shorten_file(const std::filesystem::path& path, int64_t bytes);

/// For readers of files: throws the UserError of one that cannot be read, with the system's reason in errno.
[[noreturn]] void fail_reading(const std::filesystem::path& path);

/// The whole content of a file. Throws UserError naming the path and the system's reason.
std::string read_file(const std::filesystem::path& path);

}  // namespace ballpit
