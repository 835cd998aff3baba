// SPDX-License-Identifier: MIT
#include "scene/line_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "core/file.h"

namespace ballpit {

static constexpr size_t kBufferSize = 1 << 20;

LineReader::LineReader(std::string_view text, std::string_view file_name)
    : place_{std::string(file_name), 0}, rest_(text) {
  start();
}

LineReader::LineReader(const std::filesystem::path& path) : place_{path.string(), 0} {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw UserError(place_.file, "a folder", "a file");
  file_.reset(std::fopen(path.c_str(), "rb"));
  if (!file_) fail_reading(place_.file);
  const auto size = std::filesystem::file_size(path, unknown);
  bytes_to_come_ = unknown ? 0 : static_cast<int64_t>(size);
  buffer_ = std::make_unique_for_overwrite<char[]>(kBufferSize);
  rest_ = {buffer_.get(), 0};
  refill();
  start();
}

bool LineReader::next(std::string_view& line) {
  size_t end = rest_.find(line_end_);
  while (end == std::string_view::npos && refill()) end = rest_.find(line_end_);
  if (rest_.empty()) return false;
  ++place_.line;
  line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

int64_t LineReader::expected_lines() const {
  const auto lines = std::count(rest_.begin(), rest_.end(), line_end_) + 1;
  if (bytes_to_come_ <= 0 || rest_.empty()) return lines;
  const double times = static_cast<double>(bytes_to_come_) / static_cast<double>(rest_.size());
  return lines + static_cast<int64_t>(1.01 * times * static_cast<double>(lines));
}

/// Moves the rest to the front of the buffer and reads more after it; false at the end of the file.
bool LineReader::refill() {
  if (!file_) return false;
  if (rest_.size() == kBufferSize) {
    ++place_.line;
    throw input_error(place_, "line", fmt::format("more than {} bytes", kBufferSize), "lines of at most so many");
  }
  std::memmove(buffer_.get(), rest_.data(), rest_.size());
  errno = 0;
  const size_t read = std::fread(buffer_.get() + rest_.size(), 1, kBufferSize - rest_.size(), file_.get());
  if (std::ferror(file_.get()) != 0) fail_reading(place_.file);
  if (read == 0) file_.reset();
  rest_ = {buffer_.get(), rest_.size() + read};
  bytes_to_come_ -= static_cast<int64_t>(read);
  return read > 0;
}

/// Skips the byte order mark. Some spreadsheets end lines with a carriage return only.
void LineReader::start() {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  const size_t end = rest_.find_first_of("\r\n");
  if (end < rest_.size() && end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] != '\n') line_end_ = '\r';
}

}  // namespace ballpit
