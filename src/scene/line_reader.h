// SPDX-License-Identifier: MIT
// Lines of a text, or of a file of any size: a file passes through one buffer of fixed size, a line is a view into it.
// Cost: one pass, and a megabyte.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "scene/input_error.h"

namespace ballpit {

class LineReader {
 public:
  /// Lines of `text`, which must outlive the reader; `file_name` is what errors call it.
  LineReader(std::string_view text, std::string_view file_name);

  /// Lines of a file, or of whatever else can be opened and read. Throws UserError naming path and reason.
  explicit LineReader(const std::filesystem::path& path);

  /// Takes the next line, without its end; false after the last. The view holds until the next call. Throws UserError
  /// for a line of a file that the buffer cannot hold, and where reading fails.
  bool next(std::string_view& line);

  /// Where the line taken last stands.
  const Place& place() const { return place_; }

  /// How many lines are still to come: exact where the rest is in memory, else estimated from the part that is.
  int64_t expected_lines() const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  bool refill();
  void skip_byte_order_mark();
  void find_line_end();

  Place place_;
  char line_end_ = '\n';
  std::unique_ptr<std::FILE, Close> file_;  // none where the text is in memory, or read to its end
  std::unique_ptr<char[]> buffer_;
  std::string_view rest_;      // what is in memory and not taken yet
  int64_t bytes_to_come_ = 0;  // in the file behind it, as far as the file system tells
};

}  // namespace ballpit
