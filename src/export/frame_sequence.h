// SPDX-License-Identifier: MIT
// Writes a film as numbered pictures: frame_00000.png, frame_00001.png, … A thread encodes the frames from a short queue while
// the next frames are drawn, so a frame takes the longer of the two times, and memory is bounded.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "render/image.h"

namespace ballpit {

class FrameSequence {
 public:
  /// Makes the folder if it is missing. Throws RunError naming it if that fails. Each frame contains `key`, see encode_png().
  explicit FrameSequence(std::filesystem::path folder, int first_index = 0, std::string key = {});
  FrameSequence(const FrameSequence&) = delete;
  FrameSequence& operator=(const FrameSequence&) = delete;

  /// Writes the pushed frames; ignores errors if finish() was not called.
  ~FrameSequence();

  /// Adds the next frame; waits while the queue is full. Throws the error of an earlier frame.
  void push(Image frame);

  /// Waits until every frame is written. Throws the error of the first that failed. Do not push after it.
  void finish();

  int next_index() const { return next_index_; }  ///< of the next frame

 private:
  void encode_frames();
  void stop_and_join();

  static constexpr size_t kQueueLength = 3;

  std::filesystem::path folder_;
  std::string key_;
  int next_index_;
  int next_written_;  ///< used by the encoder only
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Image> queue_;   ///< guarded by mutex_
  bool closed_ = false;       ///< guarded by mutex_
  std::exception_ptr error_;  ///< guarded by mutex_
  std::thread encoder_;
};

/// "frame_00012.png"
std::string frame_name(int index);

/// The index at which an interrupted sequence continues: the number of complete frames from frame_00000.png on without a gap.
/// Removes temporary files of interrupted writes. 0 if the folder is missing. Pipes and devices do not count as frames.
int next_frame_index(const std::filesystem::path& folder);

/// Removes the frames from `first` to `end` − 1, which a new run will write. Otherwise a run that is interrupted and continued
/// would take them for its own. Throws RunError.
void remove_frames(const std::filesystem::path& folder, int first, int end);

}  // namespace ballpit
