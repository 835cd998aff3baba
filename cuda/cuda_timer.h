// SPDX-License-Identifier: MIT
// Stage times of a stream: while they are wanted, records events around each launch and reads them later, so that a step
// never waits for timing.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "cuda_error.h"
#include "exec/stage_times.h"

namespace ballpit {

class CudaEvent {
 public:
  CudaEvent() { BALLPIT_CUDA_CHECK(cudaEventCreate(&event_)); }
  ~CudaEvent() {
    if (event_ != nullptr) (void)cudaEventDestroy(event_);
  }
  CudaEvent(CudaEvent&& other) noexcept : event_(std::exchange(other.event_, nullptr)) {}
  CudaEvent& operator=(CudaEvent&& other) noexcept {
    std::swap(event_, other.event_);
    return *this;
  }
  cudaEvent_t get() const { return event_; }

 private:
  cudaEvent_t event_ = nullptr;
};

class CudaTimer {
 public:
  explicit CudaTimer(cudaStream_t stream) : stream_(stream) {}

  /// Off at first: then nothing is recorded.
  void turn(bool is_on) { is_on_ = is_on; }
  bool is_on() const { return is_on_; }

  /// Records the start of a stage. Call stop() next, unless the launch failed.
  void start(const char* name) {
    if (!is_on_) return;
    if (used_ == kPending) collect();
    if (used_ == pending_.size()) pending_.emplace_back();
    pending_[used_].name = name;
    BALLPIT_CUDA_CHECK(cudaEventRecord(pending_[used_].begin.get(), stream_));
  }

  void stop() {
    if (!is_on_) return;
    BALLPIT_CUDA_CHECK(cudaEventRecord(pending_[used_].end.get(), stream_));
    ++used_;
  }

  /// Waits for the stream and returns the times of all stages so far.
  StageTimes& times() {
    collect();
    return times_;
  }

 private:
  struct Pending {
    const char* name = "";
    CudaEvent begin, end;
  };
  static constexpr size_t kPending = 512;

  void collect() {
    if (used_ == 0) return;
    BALLPIT_CUDA_CHECK(cudaStreamSynchronize(stream_));
    for (size_t k = 0; k < used_; ++k) {
      float milliseconds = 0;
      BALLPIT_CUDA_CHECK(cudaEventElapsedTime(&milliseconds, pending_[k].begin.get(), pending_[k].end.get()));
      times_.add(pending_[k].name, milliseconds * 1e-3);
    }
    used_ = 0;
  }

  cudaStream_t stream_;
  bool is_on_ = false;
  std::vector<Pending> pending_;
  size_t used_ = 0;
  StageTimes times_;
};

}  // namespace ballpit
