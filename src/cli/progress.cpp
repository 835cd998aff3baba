// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

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
  const int filled = static_cast<int>(kWidth * std::clamp(share, 0.0, 1.0));
  std::fprintf(stderr, "\r\033[K[%s%s] %s", std::string(static_cast<size_t>(filled), '#').c_str(),
               std::string(static_cast<size_t>(kWidth - filled), ' ').c_str(), text.c_str());
  std::fflush(stderr);
}

void Progress::show(int64_t done) {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0.0;
  const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0.0;
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "%lld/%lld %s, %.1f a second, %.0f s left", static_cast<long long>(done),
                static_cast<long long>(total_), unit_.c_str(), rate, std::ceil(left));
  bar_.show(static_cast<double>(done) / static_cast<double>(std::max<int64_t>(total_, 1)), text.data());
}

}  // namespace ballpit
