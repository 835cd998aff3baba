// SPDX-License-Identifier: MIT
// The executor interface of exec/cpu_executor.h on a GPU: one stream, one thread per index, sort and scan by CUB.
//
// Memory is reused from step to step, since an allocation waits for the GPU. The host runs ahead of the device and
// waits only where it reads a number: the total of a scan that sizes a buffer, a reduction, a download. In defer() it
// reads none of those that deferred.h names, and what is launched waits to be submitted at once (cuda_queue.h).
#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <type_traits>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/tabulate_output_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include "bin_kernels.h"
#include "cuda_launcher.h"
#include "scan_kernels.h"

namespace ballpit {

template <class T>
struct FillSpan {
  Span<T> span;
  T value;
  HOST_DEVICE void operator()(int i) const { span[i] = value; }
};

class CudaExecutor : public CudaLauncher {
 public:
  template <class T>
  using Buffer = DeviceBuffer<T>;

  /// The total of a scan. Converting it to a number waits for the device; callers that ignore it do not wait.
  class Total {
   public:
    Total(CudaExecutor& exec, Span<const int64_t> total) : exec_(exec), total_(total) {}
    operator int64_t() const { return total_.empty() ? 0 : exec_.download(total_)[0]; }

   private:
    CudaExecutor& exec_;
    Span<const int64_t> total_;  // invalid after the next scan
  };

  template <class T>
  void fill(const char* name, Span<T> span, T value) {
    parallel_for(name, span.size(), FillSpan<T>{span, value});
  }

  /// As on the CPU.
  Total exclusive_scan(const char* name, Span<const int> counts, Span<int> offsets) {
    return scan(name, counts, {}, offsets, {});
  }
  Total exclusive_scan(const char* name, Span<const int> a, Span<const int> b, Span<int> a_offsets,
                       Span<int> b_offsets) {
    return scan(name, a, b, a_offsets, b_offsets);
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
    queue_.submit();
    radix_sort(name, key_buffers, value_buffers, n, bits);
    move_back(keys, key_buffers);
    move_back(values, value_buffers);
    timer_.stop();
  }

  /// As on the CPU, by the kernels of bin_kernels.h: radix sort, whatever the bins hold.
  template <class KeyOf, class ValueOf, class T>
  void bin(const char* name, const KeyOf& key_of, const ValueOf& value_of, Span<int> offsets, Span<T> values) {
    const int64_t n = values.size();
    timer_.start(name);
    queue_.submit();
    const Span<int> order = bin_indices(name, key_of, offsets, memory<int>(kValues, n));
    if (n > 0) launch_now(name, {n}, GatherValue<ValueOf, T>{value_of, order, values});
    timer_.stop();
  }

  template <class KeyOf>
  void bin(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    timer_.start(name);
    queue_.submit();
    const Span<int> sorted = bin_indices(name, key_of, offsets, order);
    if (sorted.data() != order.data()) copy(order.data(), sorted.data(), order.size(), cudaMemcpyDeviceToDevice);
    timer_.stop();
  }

  /// The same by counters, where bins hold few.
  template <class KeyOf>
  void bin_few(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    const int64_t n = order.size(), bins = offsets.size() - 1;
    if (n == 0) return clear(offsets);
    const Span<int> keys = memory<int>(kKeys, n), unsorted = memory<int>(kValues, n),
                    counts = memory<int>(kOtherKeys, bins);
    timer_.start(name);
    clear(counts);
    launch(name, {n}, CountKey<KeyOf>{key_of, keys, counts});
    add_up(name, counts, {}, offsets, {});
    launch(name, {n}, PlaceIndex{keys, offsets, counts, unsorted});
    launch(name, {n}, RankIndex{keys, offsets, unsorted, order});
    timer_.stop();
  }

  /// Memory for n values that lasts until the next call with this index, 0 or 1.
  template <class T>
  Span<T> scratch(int index, int64_t n) {
    return memory<T>(kScratch + index, n);
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

  Total scan(const char* name, Span<const int> a, Span<const int> b, Span<int> a_offsets, Span<int> b_offsets) {
    if (a.empty()) {
      for (const Span<int> offsets : {a_offsets, b_offsets}) clear(offsets);
      return {*this, {}};
    }
    timer_.start(name);
    const Span<int64_t> total = add_up(name, a, b, a_offsets, b_offsets);
    timer_.stop();
    return {*this, total};
  }

  /// Returns where the total will be.
  Span<int64_t> add_up(const char* name, Span<const int> a, Span<const int> b, Span<int> a_offsets,
                       Span<int> b_offsets) {
    const auto n = static_cast<int>(a.size());
    const Span<int64_t> total = memory<int64_t>(kTotal, 1);
    const auto counts =
        thrust::make_transform_iterator(thrust::make_counting_iterator(int64_t(0)), ReadCounts{a.data(), b.data()});
    const auto sums =
        thrust::make_tabulate_output_iterator(StoreSums{n, a_offsets.data(), b_offsets.data(), total.data()});
    const auto algorithm = [=, stream = stream_.get()](void* scratch, size_t& bytes) {
      return cub::DeviceScan::InclusiveScan(scratch, bytes, counts, sums, AddSums{}, n, stream);
    };
    auto known = scan_bytes_.find(n);
    if (known == scan_bytes_.end()) {
      size_t bytes = 0;
      check_cuda(algorithm(nullptr, bytes), name);
      known = scan_bytes_.emplace(n, bytes).first;
    }
    const size_t bytes = known->second;
    const Span<char> scratch = memory<char>(kCub, static_cast<int64_t>(bytes));
    submit_later(key_of(a.data(), b.data(), a_offsets.data(), b_offsets.data(), total.data(), scratch.data(), n), [=] {
      size_t room = bytes;
      check_cuda(algorithm(scratch.data(), room), name);
    });
    return total;
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
    launch_now(name, {n}, StoreKey<KeyOf>{key_of, {keys.Current(), n}, {indices.Current(), n}});
    radix_sort(name, keys, indices, n, bits);
    launch_now(name, {(offsets.size() + kBinsPerThread - 1) / kBinsPerThread}, FindBins{{keys.Current(), n}, offsets});
    return {indices.Current(), n};
  }

  DeviceBuffer<char> memory_[kMemories];
  std::map<int, size_t> scan_bytes_;  // of scratch memory, by the number of values
};

}  // namespace ballpit
