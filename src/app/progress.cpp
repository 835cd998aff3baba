// SPDX-License-Identifier: MIT
#include "app/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace ballpit {

Progress::Progress(std::string unit, int64_t total)
    : unit_(std::move(unit)), total_(total), is_shown_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (is_shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(int64_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (!is_shown_ || (now - last_ < std::chrono::milliseconds(100) && done < total_)) return;
  last_ = now;
  constexpr int kWidth = 30;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0.0;
  const int filled = static_cast<int>(kWidth * done / std::max<int64_t>(total_, 1));
  const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0.0;
  std::fprintf(stderr, "\r\033[K[%s%s] %lld/%lld %s, %.1f a second, %.0f s left",
               std::string(static_cast<size_t>(filled), '#').c_str(),
               std::string(static_cast<size_t>(kWidth - filled), ' ').c_str(), static_cast<long long>(done),
               static_cast<long long>(total_), unit_.c_str(), rate, std::ceil(left));
  std::fflush(stderr);
}

}  // namespace ballpit
