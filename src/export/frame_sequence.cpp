// SPDX-License-Identifier: MIT
#include "export/frame_sequence.h"

#include <cassert>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/file.h"
#include "export/png.h"

namespace ballpit {

namespace fs = std::filesystem;

FrameSequence::FrameSequence(fs::path folder, int first_index, std::string key)
    : folder_(std::move(folder)), key_(std::move(key)), next_index_(first_index), next_written_(first_index) {
  make_folder(folder_);
  encoder_ = std::thread([this] { encode_frames(); });
}

FrameSequence::~FrameSequence() { stop_and_join(); }

void FrameSequence::push(Image frame) {
  std::unique_lock lock(mutex_);
  assert(!closed_);
  changed_.wait(lock, [this] { return queue_.size() < kQueueLength || error_; });
  if (error_) std::rethrow_exception(error_);
  queue_.push_back(std::move(frame));
  ++next_index_;
  changed_.notify_all();
}

void FrameSequence::finish() {
  stop_and_join();
  if (error_) std::rethrow_exception(error_);  // no lock: the encoder has ended
}

void FrameSequence::stop_and_join() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  if (encoder_.joinable()) encoder_.join();
}

void FrameSequence::encode_frames() {
  for (;;) {
    Image frame;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !queue_.empty() || closed_; });
      if (queue_.empty()) return;
      frame = std::move(queue_.front());
      queue_.pop_front();
    }
    changed_.notify_all();
    try {
      write_file(folder_ / frame_name(next_written_), encode_png(frame, key_));
      ++next_written_;
    } catch (...) {  // no more frames: they would hide the gap
      const std::lock_guard lock(mutex_);
      error_ = std::current_exception();
      changed_.notify_all();
      return;
    }
  }
}

std::string frame_name(int index) { return fmt::format("frame_{:05}.png", index); }

int next_frame_index(const fs::path& folder) try {
  if (!fs::exists(folder)) return 0;
  std::vector<fs::path> left_overs;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("frame_") && name.ends_with(".part")) left_overs.push_back(entry.path());
  }
  for (const fs::path& path : left_overs) fs::remove(path);
  int count = 0;
  while (fs::is_regular_file(folder / frame_name(count))) ++count;
  if (count > 0 && !is_whole_png(read_file(folder / frame_name(count - 1)))) --count;
  return count;
} catch (const fs::filesystem_error& error) {
  throw RunError(folder.string(), "cannot look for frames: " + error.code().message());
}

void remove_frames(const fs::path& folder, int first, int end) {
  for (int index = first; index < end; ++index) {
    const fs::path path = folder / frame_name(index);
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (fs::is_symlink(status) || fs::is_other(status)) continue;  // pipes and devices are written to
    fs::remove(path, error);
    const bool absent = error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
    if (error && !absent) throw RunError(path.string(), "cannot remove: " + error.message());
  }
}

}  // namespace ballpit
