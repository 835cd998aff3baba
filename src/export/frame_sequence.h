// SPDX-License-Identifier: MIT
// A film as numbered pictures: frame_00000.png, frame_00001.png, … Encoded beside the drawing, by one thread
// that a short queue feeds, so that a frame costs whichever takes longer of the two and memory stays bounded.
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
  /// Makes the folder if it is missing. Throws RunError naming it if that fails. Each frame carries `key`, as png.h has it.
  explicit FrameSequence(std::filesystem::path folder, int first_index = 0, std::string key = {});
  FrameSequence(const FrameSequence&) = delete;
  FrameSequence& operator=(const FrameSequence&) = delete;

  /// Writes what was pushed; an error that nobody asked for by finish() is lost.
  ~FrameSequence();

  /// Takes the next frame; waits while the queue is full. Throws the error of an earlier frame.
  void push(Image frame);

  /// Waits until every frame is written. Throws the error of the first that could not be. Nothing may follow.
  void finish();

  int next_index() const { return next_index_; }  ///< of the frame that the next push takes

 private:
  void encode_frames();
  void stop_and_join();

  static constexpr size_t kQueueLength = 3;

  std::filesystem::path folder_;
  std::string key_;
  int next_index_;
  int next_written_;  ///< the encoder's own
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Image> queue_;   ///< guarded by mutex_
  bool closed_ = false;       ///< guarded by mutex_
  std::exception_ptr error_;  ///< guarded by mutex_
  std::thread encoder_;
};

/// "frame_00012.png"
std::string frame_name(int index);

/// Where a sequence goes on: the number of whole frames from frame_00000.png on without a gap. Removes
/// left-overs of interrupted writes. 0 where the folder is missing. What is no file (a pipe, a device) is no frame.
int next_frame_index(const std::filesystem::path& folder);

/// Removes the frames from `first` to `end` − 1: those that a new run is about to make. Left standing, they would be taken
/// for its own if it is interrupted and goes on later. Throws RunError.
void remove_frames(const std::filesystem::path& folder, int first, int end);

}  // namespace ballpit
