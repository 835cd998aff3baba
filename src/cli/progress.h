// SPDX-License-Identifier: MIT
// Progress bars on standard error, where that is a terminal; silent otherwise.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace ballpit {

/// One line that is drawn over, and gone at the end.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Redraws the bar, a share from 0 to 1 of it filled, with a text behind it: at most ten times a second.
  void show(double share, const std::string& text);

 private:
  bool is_shown_;
  std::chrono::steady_clock::time_point last_{};
};

/// Counts what is done of a known number, at a steady pace.
class Progress {
 public:
  /// `unit` names what is counted: "frames".
  Progress(std::string unit, int64_t total) : unit_(std::move(unit)), total_(total) {}

  void show(int64_t done);

 private:
  ProgressBar bar_;
  std::string unit_;
  int64_t total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ballpit
