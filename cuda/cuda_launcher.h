// SPDX-License-Identifier: MIT
// How CudaExecutor launches: a stream, a queue for launches that are deferred, a timer for stages, and what halts a device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "core/span.h"
#include "cuda_queue.h"
#include "cuda_timer.h"
#include "device_buffer.h"
#include "exec/deferred.h"
#include "exec/stage_times.h"
#include "phase_kernel.h"

namespace ballpit {

/// Calls kernel(i) for i in 0 … most − 1, or as many as `count` says; for none if halted.
template <class Kernel>
__global__ void run_kernel(int most, const int* count, const int* halted, Kernel kernel) {
  const int64_t i = int64_t(blockIdx.x) * blockDim.x + threadIdx.x;
  if (i >= most) return;
  if (halted != nullptr && *halted != 0) return;
  if (count != nullptr && i >= *count) return;
  kernel(static_cast<int>(i));
}

class CudaStream {
 public:
  CudaStream() { BALLPIT_CUDA_CHECK(cudaStreamCreate(&stream_)); }
  ~CudaStream() { (void)cudaStreamDestroy(stream_); }
  CudaStream(const CudaStream&) = delete;
  CudaStream& operator=(const CudaStream&) = delete;
  cudaStream_t get() const { return stream_; }

 private:
  cudaStream_t stream_ = nullptr;
};

/// A number that the device writes and the host reads at any time.
class SharedFlag {
 public:
  SharedFlag() { BALLPIT_CUDA_CHECK(cudaHostAlloc(&host_, sizeof(int), cudaHostAllocMapped)); }
  ~SharedFlag() { (void)cudaFreeHost(host_); }
  SharedFlag(const SharedFlag&) = delete;
  SharedFlag& operator=(const SharedFlag&) = delete;

  bool is_raised() const { return *static_cast<const volatile int*>(host_) != 0; }
  void lower() { *static_cast<volatile int*>(host_) = 0; }
  int* on_device() const {
    void* address = nullptr;
    BALLPIT_CUDA_CHECK(cudaHostGetDevicePointer(&address, host_, 0));
    return static_cast<int*>(address);
  }

 private:
  int* host_ = nullptr;
};

class CudaLauncher {
 public:
  static constexpr bool kDefers = true;
  static constexpr bool runs_in_order() { return false; }

  StageTimes& stage_times() { return timer_.times(); }

  /// Whether stages are timed from now on, by events around each launch.
  void time_stages(bool is_timed) { timer_.turn(is_timed); }

  /// Runs work() without waiting for counts and conditions (deferred.h). Unless stages are timed, launches are
  /// submitted as a graph.
  template <class Work>
  void defer(const Work& work) {
    prepare_halt();
    is_deferring_ = true;
    try {
      if (timer_.is_on()) {
        work();
      } else {
        queue_.collect(work);
      }
    } catch (...) {
      is_deferring_ = false;
      throw;
    }
    is_deferring_ = false;
  }
  bool is_deferring() const { return is_deferring_; }
  Halt halt() const { return is_deferring_ ? halt_ : Halt{}; }

  /// Whether the device has halted: as far as the host knows, or after it has finished all that was launched.
  bool seems_halted() const { return flag_ && flag_->is_raised(); }
  bool has_halted() {
    wait();
    return seems_halted();
  }
  void go_on() {
    clear(halted_.span());
    wait();
    flag_->lower();
  }

  template <class Kernel>
  void parallel_for(const char* name, int64_t n, const Kernel& kernel) {
    parallel_for(name, Bounded{n, nullptr}, kernel);
  }

  template <class Kernel>
  void parallel_for(const char* name, const Bounded& n, const Kernel& kernel) {
    if (n.most == 0) return;
    timer_.start(name);
    launch(name, n, kernel);
    timer_.stop();
  }

  /// All phases, each of at most so many indices (phases.h).
  template <Phases P>
  void run_phases(const char* name, int64_t most, const P& phases) {
    if (most == 0) return;
    timer_.start(name);
    const auto blocks = static_cast<unsigned>(std::min<int64_t>(blocks_for(most), resident_(&run_phases_kernel<P>)));
    submit_later(key_of(&run_phases_kernel<P>, blocks, phases), [this, name, blocks, phases] {
      const int* halted = is_deferring_ ? halt_.device : nullptr;
      P own = phases;
      void* arguments[] = {&halted, &own};
      const auto kernel = reinterpret_cast<const void*>(&run_phases_kernel<P>);
      check_cuda(cudaLaunchCooperativeKernel(kernel, blocks, kCudaBlock, arguments, 0, stream_.get()), name);
    });
    timer_.stop();
  }

  /// Sets all to 0.
  void clear(Span<int> span) {
    if (span.empty()) return;
    const auto bytes = static_cast<size_t>(span.size()) * sizeof(int);
    submit_later(key_of(span.data(), bytes),
                 [this, span, bytes] { BALLPIT_CUDA_CHECK(cudaMemsetAsync(span.data(), 0, bytes, stream_.get())); });
  }

  template <class T>
  void upload(DeviceBuffer<T>& buffer, const T* values, int64_t n) {
    queue_.submit();
    buffer.resize(n);
    copy(buffer.span().data(), values, n, cudaMemcpyHostToDevice);
    wait();
  }
  template <class T>
  void upload(DeviceBuffer<T>& buffer, const std::vector<T>& values) {
    upload(buffer, values.data(), static_cast<int64_t>(values.size()));
  }

  template <class T>
  std::vector<std::remove_const_t<T>> download(Span<T> span) {
    queue_.submit();
    std::vector<std::remove_const_t<T>> values(static_cast<size_t>(span.size()));
    copy(values.data(), span.data(), span.size(), cudaMemcpyDeviceToHost);
    wait();
    return values;
  }

  /// Waits for all that was launched.
  void wait() {
    queue_.submit();
    BALLPIT_CUDA_CHECK(cudaStreamSynchronize(stream_.get()));
  }

 protected:
  /// All that determines a launch or a call, as bytes.
  template <class... Parts>
  static std::string key_of(const Parts&... parts) {
    std::string key;
    const auto add = [&](auto part) {
      __builtin_clear_padding(&part);
      key.append(reinterpret_cast<const char*>(&part), sizeof(part));
    };
    (add(parts), ...);
    return key;
  }

  template <class Issue>
  void submit_later(const std::string& key, const Issue& issue) {
    if (queue_.is_open()) {
      queue_.add(key, issue);
    } else {
      issue();
    }
  }

  template <class Kernel>
  void launch(const char* name, const Bounded& n, const Kernel& kernel) {
    if (queue_.is_open()) {
      queue_.add(key_of(&run_kernel<Kernel>, n, kernel), [this, name, n, kernel] { launch_now(name, n, kernel); });
    } else {
      launch_now(name, n, kernel);
    }
  }

  template <class Kernel>
  void launch_now(const char* name, const Bounded& n, const Kernel& kernel) {
    run_kernel<<<static_cast<unsigned>(blocks_for(n.most)), kCudaBlock, 0, stream_.get()>>>(
        static_cast<int>(n.most), n.count, is_deferring_ ? halt_.device : nullptr, kernel);
    check_cuda(cudaGetLastError(), name);
  }

  static int64_t blocks_for(int64_t threads) { return (threads + kCudaBlock - 1) / kCudaBlock; }

  /// What is needed to halt; the first time only.
  void prepare_halt() {
    if (flag_) return;
    halted_.resize(1);
    clear(halted_.span());
    flag_ = std::make_unique<SharedFlag>();
    flag_->lower();
    halt_ = {halted_.span().data(), flag_->on_device()};
  }

  template <class T>
  void copy(T* to, const T* from, int64_t n, cudaMemcpyKind kind) const {
    if (n == 0) return;
    BALLPIT_CUDA_CHECK(cudaMemcpyAsync(to, from, static_cast<size_t>(n) * sizeof(T), kind, stream_.get()));
  }

  CudaStream stream_;
  CudaTimer timer_{stream_.get()};
  CudaQueue queue_{stream_.get()};

 private:
  ResidentBlocks resident_;
  bool is_deferring_ = false;
  std::unique_ptr<SharedFlag> flag_;
  DeviceBuffer<int> halted_;
  Halt halt_;
};

}  // namespace ballpit
