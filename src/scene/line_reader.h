// SPDX-License-Identifier: MIT
// Reads the lines of a text, or of a file of any size through a buffer of fixed size. A line is a view into the buffer.
// Cost: one pass, and a megabyte.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "scene/input_error.h"

namespace ballpit {

class LineReader {
 public:
  /// Lines of `text`, which must outlive the reader; `file_name` is what errors call it.
  LineReader(std::string_view text, std::string_view file_name);

  /// Lines of a file, a pipe or a device. Throws UserError naming path and reason.
  LineReader(const std::filesystem::path& path);

  /// Takes the next line, without its end; false after the last. The view is valid until the next call. Throws UserError for
  /// a line of a file that is larger than the buffer, and if reading fails.
  bool next(std::string_view& line);

  /// The place of the line taken last.
  const Place& place() const { return place_; }

  /// The number of remaining lines: exact if the rest is in memory, else estimated from the part in memory.
  int64_t expected_lines() const;

 private:
  bool refill();
  void start();

  Place place_;
  char line_end_ = '\n';
  // None if the text is in memory, or the file was read completely.
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, std::fclose};
  std::unique_ptr<char[]> buffer_;
  std::string_view rest_;      // in memory and not yet taken
  int64_t bytes_to_come_ = 0;  // in the file after it, if the file system knows its size
};

}  // namespace ballpit
