// SPDX-License-Identifier: MIT
// The execution contract of exec/cpu_executor.h on a GPU: one stream, one thread per index, sort and scan by CUB.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_reduce.cuh>
#include <cub/device/device_scan.cuh>

#include "core/span.h"
#include "cuda_timer.h"
#include "device_buffer.h"
#include "exec/stage_times.h"

namespace ballpit {

template <class Kernel>
__global__ void run_kernel(int n, Kernel kernel) {
  const int64_t i = int64_t(blockIdx.x) * blockDim.x + threadIdx.x;
  if (i < n) kernel(static_cast<int>(i));
}

template <class T>
struct FillSpan {
  Span<T> span;
  T value;
  HOST_DEVICE void operator()(int i) const { span[i] = value; }
};

struct ToInt64 {
  HOST_DEVICE int64_t operator()(int value) const { return value; }
};

struct AddInt64 {
  HOST_DEVICE int64_t operator()(int64_t a, int64_t b) const { return a + b; }
};

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

class CudaExecutor {
 public:
  template <class T>
  using Buffer = DeviceBuffer<T>;

  StageTimes& stage_times() { return timer_.times(); }

  template <class Kernel>
  void parallel_for(const char* name, int64_t n, const Kernel& kernel) {
    if (n == 0) return;
    const auto blocks = static_cast<unsigned>((n + kThreads - 1) / kThreads);
    timer_.start(name);
    run_kernel<<<blocks, kThreads, 0, stream_.get()>>>(static_cast<int>(n), kernel);
    check_cuda(cudaGetLastError(), name);
    timer_.stop();
  }

  template <class T>
  void fill(const char* name, Span<T> span, T value) {
    parallel_for(name, span.size(), FillSpan<T>{span, value});
  }

  /// As on the CPU. Waits for the total, the one number of a step that sizes a buffer.
  int64_t exclusive_scan(const char* name, Span<const int> counts, Span<int> offsets) {
    const int64_t n = counts.size();
    BALLPIT_CUDA_CHECK(cudaMemsetAsync(offsets.data(), 0, sizeof(int), stream_.get()));
    if (n == 0) return 0;
    total_.resize(1);
    timer_.start(name);
    with_scratch([&](void* scratch, size_t& bytes) {
      return cub::DeviceReduce::TransformReduce(scratch, bytes, counts.data(), total_.span().data(), n, AddInt64{},
                                                ToInt64{}, int64_t{0}, stream_.get());
    });
    with_scratch([&](void* scratch, size_t& bytes) {
      return cub::DeviceScan::InclusiveSum(scratch, bytes, counts.data(), offsets.data() + 1, n, stream_.get());
    });
    timer_.stop();
    return download(total_.span())[0];
  }

  template <class Key, class Value>
  void sort_pairs(const char* name, Span<Key> keys, Span<Value> values) {
    const int64_t n = keys.size();
    if (n == 0) return;
    DeviceBuffer<Key> sorted_keys;
    DeviceBuffer<Value> sorted_values;
    sorted_keys.resize(n);
    sorted_values.resize(n);
    timer_.start(name);
    with_scratch([&](void* scratch, size_t& bytes) {
      return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys.data(), sorted_keys.span().data(), values.data(),
                                             sorted_values.span().data(), n, 0, int(sizeof(Key) * 8), stream_.get());
    });
    copy(keys.data(), sorted_keys.span().data(), n, cudaMemcpyDeviceToDevice);
    copy(values.data(), sorted_values.span().data(), n, cudaMemcpyDeviceToDevice);
    timer_.stop();
  }

  template <class T>
  void upload(DeviceBuffer<T>& buffer, const std::vector<T>& values) {
    buffer.resize(static_cast<int64_t>(values.size()));
    copy(buffer.span().data(), values.data(), buffer.size(), cudaMemcpyHostToDevice);
    BALLPIT_CUDA_CHECK(cudaStreamSynchronize(stream_.get()));
  }

  template <class T>
  std::vector<std::remove_const_t<T>> download(Span<T> span) const {
    std::vector<std::remove_const_t<T>> values(static_cast<size_t>(span.size()));
    copy(values.data(), span.data(), span.size(), cudaMemcpyDeviceToHost);
    BALLPIT_CUDA_CHECK(cudaStreamSynchronize(stream_.get()));
    return values;
  }

 private:
  static constexpr int kThreads = 256;

  /// Calls a CUB algorithm twice, as it wants: for the size of its scratch memory, and to run.
  template <class Algorithm>
  void with_scratch(Algorithm&& algorithm) {
    size_t bytes = 0;
    check_cuda(algorithm(nullptr, bytes), "CUB: size of scratch memory");
    scratch_.resize(static_cast<int64_t>(bytes));
    check_cuda(algorithm(scratch_.span().data(), bytes), "CUB: run");
  }

  template <class T>
  void copy(T* to, const T* from, int64_t n, cudaMemcpyKind kind) const {
    if (n == 0) return;
    BALLPIT_CUDA_CHECK(cudaMemcpyAsync(to, from, static_cast<size_t>(n) * sizeof(T), kind, stream_.get()));
  }

  CudaStream stream_;
  CudaTimer timer_{stream_.get()};
  DeviceBuffer<char> scratch_;
  DeviceBuffer<int64_t> total_;
};

}  // namespace ballpit
