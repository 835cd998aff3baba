// SPDX-License-Identifier: MIT
// The executor interface of exec/cpu_executor.h on a GPU: one stream, one thread per index, sort and scan by CUB.
//
// Memory is reused from step to step, since an allocation waits for the GPU. The host runs ahead of the device and
// waits only where it reads a number: the total of a scan that sizes a buffer, a reduction, a download.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <thrust/iterator/tabulate_output_iterator.h>

#include "bin_kernels.h"
#include "core/span.h"
#include "cuda_timer.h"
#include "device_buffer.h"
#include "exec/stage_times.h"

namespace ballpit {

inline constexpr int kCudaBlock = 256;  // threads

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

struct AddInt64 {
  HOST_DEVICE int64_t operator()(int64_t a, int64_t b) const { return a + b; }
};

/// Receives the sums of a scan, in any order: stores them as offsets, and the last one in 64 bits.
struct StoreSum {
  int n;
  int* offsets;
  int64_t* total;

  HOST_DEVICE void operator()(int64_t i, int64_t sum) const {
    if (i == 0) offsets[0] = 0;
    offsets[i + 1] = static_cast<int>(sum);
    if (i + 1 == n) *total = sum;
  }
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

  /// The total of a scan. Converting it to a number waits for the device; callers that ignore it do not wait.
  class Total {
   public:
    Total(const CudaExecutor& exec, Span<const int64_t> total) : exec_(exec), total_(total) {}
    operator int64_t() const { return total_.empty() ? 0 : exec_.download(total_)[0]; }

   private:
    const CudaExecutor& exec_;
    Span<const int64_t> total_;  // invalid after the next scan
  };

  StageTimes& stage_times() { return timer_.times(); }

  static constexpr bool runs_in_order() { return false; }

  template <class Kernel>
  void parallel_for(const char* name, int64_t n, const Kernel& kernel) {
    if (n == 0) return;
    timer_.start(name);
    launch(name, n, kernel);
    timer_.stop();
  }

  template <class T>
  void fill(const char* name, Span<T> span, T value) {
    parallel_for(name, span.size(), FillSpan<T>{span, value});
  }

  /// As on the CPU.
  Total exclusive_scan(const char* name, Span<const int> counts, Span<int> offsets) {
    const auto n = static_cast<int>(counts.size());
    if (n == 0) {
      clear(offsets);
      return {*this, {}};
    }
    const Span<int64_t> total = memory<int64_t>(kTotal, 1);
    const auto sums = thrust::make_tabulate_output_iterator(StoreSum{n, offsets.data(), total.data()});
    timer_.start(name);
    run_cub(name, [&](void* scratch, size_t& bytes) {
      return cub::DeviceScan::InclusiveScan(scratch, bytes, counts.data(), sums, AddInt64{}, n, stream_.get());
    });
    timer_.stop();
    return {*this, total};
  }

  /// As on the CPU: radix sort.
  template <class Key, class Value>
  void sort_pairs(const char* name, Span<Key> keys, Span<Value> values, int bits = int(sizeof(Key) * 8)) {
    static_assert(std::is_unsigned_v<Key>, "digits are taken by shifting");
    const int64_t n = keys.size();
    if (n == 0) return;
    cub::DoubleBuffer<Key> key_buffers(keys.data(), memory<Key>(kOtherKeys, n).data());
    cub::DoubleBuffer<Value> value_buffers(values.data(), memory<Value>(kOtherValues, n).data());
    timer_.start(name);
    radix_sort(name, key_buffers, value_buffers, n, bits);
    move_back(keys, key_buffers);
    move_back(values, value_buffers);
    timer_.stop();
  }

  /// As on the CPU, by the kernels of bin_kernels.h.
  template <class KeyOf, class ValueOf, class T>
  void bin(const char* name, const KeyOf& key_of, const ValueOf& value_of, Span<int> offsets, Span<T> values) {
    const int64_t n = values.size();
    timer_.start(name);
    const Span<int> order = bin_indices(name, key_of, offsets, memory<int>(kValues, n));
    if (n > 0) launch(name, n, GatherValue<ValueOf, T>{value_of, order, values});
    timer_.stop();
  }

  template <class KeyOf>
  void bin(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    timer_.start(name);
    const Span<int> sorted = bin_indices(name, key_of, offsets, order);
    if (sorted.data() != order.data()) copy(order.data(), sorted.data(), order.size(), cudaMemcpyDeviceToDevice);
    timer_.stop();
  }

  /// Memory for n values that lasts until the next call with this index, 0 or 1.
  template <class T>
  Span<T> scratch(int index, int64_t n) {
    return memory<T>(kScratch + index, n);
  }

  template <class T>
  void upload(DeviceBuffer<T>& buffer, const T* values, int64_t n) {
    buffer.resize(n);
    copy(buffer.span().data(), values, n, cudaMemcpyHostToDevice);
    BALLPIT_CUDA_CHECK(cudaStreamSynchronize(stream_.get()));
  }
  template <class T>
  void upload(DeviceBuffer<T>& buffer, const std::vector<T>& values) {
    upload(buffer, values.data(), static_cast<int64_t>(values.size()));
  }

  template <class T>
  std::vector<std::remove_const_t<T>> download(Span<T> span) const {
    std::vector<std::remove_const_t<T>> values(static_cast<size_t>(span.size()));
    copy(values.data(), span.data(), span.size(), cudaMemcpyDeviceToHost);
    BALLPIT_CUDA_CHECK(cudaStreamSynchronize(stream_.get()));
    return values;
  }

 private:
  /// The buffers that the executor reuses, by purpose.
  enum Memory { kScratch, kScratch1, kKeys, kOtherKeys, kValues, kOtherValues, kTotal, kCub, kMemories };
  static constexpr int kDigitBits = 8;  // of CUB's radix sort; a wrong value would only cost one more copy

  template <class T>
  Span<T> memory(int index, int64_t n) {
    DeviceBuffer<char>& buffer = memory_[index];
    buffer.resize(n * int64_t(sizeof(T)));
    return {reinterpret_cast<T*>(buffer.span().data()), n};
  }

  template <class Kernel>
  void launch(const char* name, int64_t n, const Kernel& kernel) {
    const auto blocks = static_cast<unsigned>((n + kCudaBlock - 1) / kCudaBlock);
    run_kernel<<<blocks, kCudaBlock, 0, stream_.get()>>>(static_cast<int>(n), kernel);
    check_cuda(cudaGetLastError(), name);
  }

  /// Calls a CUB algorithm twice, as CUB requires: for the size of its scratch memory, and to run it.
  template <class Algorithm>
  void run_cub(const char* name, Algorithm&& algorithm) {
    size_t bytes = 0;
    check_cuda(algorithm(nullptr, bytes), name);
    check_cuda(algorithm(memory<char>(kCub, static_cast<int64_t>(bytes)).data(), bytes), name);
  }

  template <class Key, class Value>
  void radix_sort(const char* name, cub::DoubleBuffer<Key>& keys, cub::DoubleBuffer<Value>& values, int64_t n,
                  int bits) {
    run_cub(name, [&](void* scratch, size_t& bytes) {
      return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys, values, static_cast<int>(n), 0, bits, stream_.get());
    });
  }

  /// Copies sorted values back if an odd number of passes has left them in the other buffer.
  template <class T>
  void move_back(Span<T> span, cub::DoubleBuffer<T>& buffers) {
    if (buffers.Current() != span.data()) copy(span.data(), buffers.Current(), span.size(), cudaMemcpyDeviceToDevice);
  }

  /// The indices in the order of their keys: in `order`, or in a buffer of the executor.
  template <class KeyOf>
  Span<int> bin_indices(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    const int64_t n = order.size(), bins = offsets.size() - 1;
    if (n == 0) {
      clear(offsets);
      return order;
    }
    const int bits = std::bit_width(static_cast<uint64_t>(bins - 1));
    cub::DoubleBuffer<uint32_t> keys(memory<uint32_t>(kKeys, n).data(), memory<uint32_t>(kOtherKeys, n).data());
    cub::DoubleBuffer<int> indices(order.data(), memory<int>(kOtherValues, n).data());
    // Each pass sorts from one buffer into the other. With an odd number of passes, the other one comes first, so that
    // the last pass ends in `order`.
    indices.selector = (bits + kDigitBits - 1) / kDigitBits % 2;
    launch(name, n, StoreKey<KeyOf>{key_of, {keys.Current(), n}, {indices.Current(), n}});
    radix_sort(name, keys, indices, n, bits);
    launch(name, (offsets.size() + kBinsPerThread - 1) / kBinsPerThread, FindBins{{keys.Current(), n}, offsets});
    return {indices.Current(), n};
  }

  void clear(Span<int> span) {
    const auto bytes = static_cast<size_t>(span.size()) * sizeof(int);
    BALLPIT_CUDA_CHECK(cudaMemsetAsync(span.data(), 0, bytes, stream_.get()));
  }

  template <class T>
  void copy(T* to, const T* from, int64_t n, cudaMemcpyKind kind) const {
    if (n == 0) return;
    BALLPIT_CUDA_CHECK(cudaMemcpyAsync(to, from, static_cast<size_t>(n) * sizeof(T), kind, stream_.get()));
  }

  CudaStream stream_;
  CudaTimer timer_{stream_.get()};
  DeviceBuffer<char> memory_[kMemories];
};

}  // namespace ballpit
