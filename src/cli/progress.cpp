// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace ballpit {

ProgressBar::ProgressBar() : is_shown_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (is_shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(double share, const std::string& text) {
  const auto now = std::chrono::steady_clock::now();
  if (!is_shown_ || (now - last_ < std::chrono::milliseconds(100) && share < 1)) return;
  last_ = now;
  constexpr int kWidth = 30;
  const auto filled = static_cast<size_t>(kWidth * std::clamp(share, 0.0, 1.0));
  std::fputs(fmt::format("\r\033[K[{:<{}}] {}", std::string(filled, '#'), kWidth, text).c_str(), stderr);
  std::fflush(stderr);
}

void Progress::show(int64_t done) {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0.0;
  const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0.0;
  bar_.show(static_cast<double>(done) / static_cast<double>(std::max<int64_t>(total_, 1)),
            fmt::format("{}/{} {}, {:.1f} a second, {:.0f} s left", done, total_, unit_, rate, std::ceil(left)));
}

}  // namespace ballpit
