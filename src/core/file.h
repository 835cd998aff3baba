// SPDX-License-Identifier: MIT
// Writes all files of the program. A regular file is written completely or not at all: under a temporary name in the same
// folder, then renamed. Links are followed. Pipes and devices are written directly, and never replaced, removed or shortened.
//
//     out.csv, missing or a regular file   out.csv.part ──rename──▶ out.csv
//     out.csv ─link▶ far/state.csv         far/state.csv.part ──rename──▶ far/state.csv; out.csv stays a link
//     a pipe, a device                     opened and written; a pipe as soon as it has a reader
//     /dev/stdout, /dev/fd/N               written to our own descriptor
//
// A replaced file keeps its permissions and, if the system allows it, its owner. The temporary file is locked while it is
// written: a second run with the same output uses out.csv.2.part, and the file of an interrupted run is reused.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ballpit {

/// An output that is written in pieces. A regular file gets its name in commit(); without it, the destructor removes the
/// temporary file. All functions throw RunError naming the path and the system's reason (no space, no permission, …).
class NewFile {
 public:
  explicit NewFile(std::filesystem::path path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Appends `bytes`. If it fails, a part of them may be written.
  void write(std::string_view bytes);

  /// Removes everything after the first `bytes`. Do not write after it. Has no effect on a pipe, a device or a descriptor.
  void cut_to(int64_t bytes);

  /// Gives the file its final name.
  void commit();

  /// The temporary file, for another program that writes it; empty for a pipe or a device.
  const std::filesystem::path& part() const { return part_; }

 private:
  std::filesystem::path path_;    // as given
  std::filesystem::path target_;  // after following links
  std::filesystem::path part_;    // the temporary file; empty if there is none
  int descriptor_ = -1;
};

/// Writes `bytes` to `path` as NewFile does.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws the error that writing to `path` would throw later, as far as it is known, and changes nothing.
void check_output(const std::filesystem::path& path);

/// The same for new files in a folder, which may be missing.
void check_output_folder(const std::filesystem::path& folder);

/// Whether two paths lead to the same file, pipe or device, which may be missing. False for empty paths.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Makes a folder and its parents if they are missing. Throws RunError.
void make_folder(const std::filesystem::path& folder);

/// Appends whole lines to a file, which it makes if it is missing, in a single write. Throws RunError.
void append_to_file(const std::filesystem::path& path, std::string_view lines);

/// Shortens a file to the first `bytes`. Throws RunError.
void shorten_file(const std::filesystem::path& path, int64_t bytes);

/// For readers of files: throws the UserError for an unreadable file, with the system's reason in errno.
[[noreturn]] void fail_reading(const std::filesystem::path& path);

/// The whole content of a file. Throws UserError naming the path and the system's reason.
std::string read_file(const std::filesystem::path& path);

/// A text file that is compiled into the program. cmake/embed_files.cmake generates tables of them.
struct EmbeddedFile {
  std::string_view name;  ///< "bouncing-balls.toml"
  std::string_view text;
};

}  // namespace ballpit
