// SPDX-License-Identifier: MIT
// Progress bars on standard error, if that is a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace ballpit {

/// A line that is redrawn in place and cleared at the end.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws the bar, filled to a share from 0 to 1, and a text; at most ten times a second.
  void show(double share, const std::string& text);

 private:
  bool is_shown_;
  std::chrono::steady_clock::time_point last_{};
};

/// Counts items of a known number and predicts the time left.
class Progress {
 public:
  /// `unit` names the items: "frames".
  Progress(std::string unit, int64_t total) : unit_(std::move(unit)), total_(total) {}

  void show(int64_t done);

 private:
  ProgressBar bar_;
  std::string unit_;
  int64_t total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ballpit
