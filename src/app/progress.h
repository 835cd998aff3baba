// SPDX-License-Identifier: MIT
// A progress bar on standard error, where that is a terminal; silent otherwise.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace ballpit {

class Progress {
 public:
  /// `unit` names what is counted: "frames".
  Progress(std::string unit, int64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Redraws the bar at most ten times a second.
  void show(int64_t done);

 private:
  std::string unit_;
  int64_t total_;
  bool is_shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace ballpit
