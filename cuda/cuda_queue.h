// SPDX-License-Identifier: MIT
// Launches of a stream that wait to be submitted at once. A sequence that comes again is submitted as a graph, by one
// call of the CUDA runtime:
//
//     first time     each launch by itself
//     second time    captured, made a graph, launched
//     from then on   launched                               found by what was launched: kernels, sizes, arguments
//
// So a graph is never wrong: whatever changes, a pointer or a size, is another sequence. Cost: a comparison of some
// kilobytes for each sequence.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cuda_error.h"
#include "device_buffer.h"

namespace ballpit {

class CudaGraph {
 public:
  CudaGraph() = default;
  CudaGraph(const CudaGraph&) = delete;
  CudaGraph& operator=(const CudaGraph&) = delete;
  ~CudaGraph() {
    if (executable_ != nullptr) (void)cudaGraphExecDestroy(executable_);
  }

  bool is_made() const { return executable_ != nullptr; }

  /// Captures what issue() launches on the stream.
  template <class Issue>
  void make(cudaStream_t stream, const Issue& issue) {
    cudaGraph_t graph = nullptr;
    BALLPIT_CUDA_CHECK(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal));
    try {
      issue();
    } catch (...) {
      if (cudaStreamEndCapture(stream, &graph) == cudaSuccess) (void)cudaGraphDestroy(graph);
      (void)cudaGetLastError();
      throw;
    }
    BALLPIT_CUDA_CHECK(cudaStreamEndCapture(stream, &graph));
    const cudaError_t status = cudaGraphInstantiate(&executable_, graph, 0);
    (void)cudaGraphDestroy(graph);
    check_cuda(status, "cudaGraphInstantiate(&executable_, graph, 0)");
  }

  void launch(cudaStream_t stream) const { BALLPIT_CUDA_CHECK(cudaGraphLaunch(executable_, stream)); }

 private:
  cudaGraphExec_t executable_ = nullptr;
};

class CudaQueue {
 public:
  explicit CudaQueue(cudaStream_t stream) : stream_(stream) {}
  CudaQueue(const CudaQueue&) = delete;
  CudaQueue& operator=(const CudaQueue&) = delete;

  bool is_open() const { return is_open_; }

  /// Launches of work() wait, and are submitted at its end. If it throws, those that wait are dropped.
  template <class Work>
  void collect(const Work& work) {
    std::vector<void*> freed;
    memory_in_use = &freed;
    is_open_ = true;
    try {
      work();
      submit();
    } catch (...) {
      close(freed);
      throw;
    }
    close(freed);
  }

  /// `key`: all that determines what issue() launches.
  void add(const std::string& key, std::function<void()> issue) {
    key_ += key;
    waiting_.push_back(std::move(issue));
  }

  /// Submits what waits.
  void submit() {
    if (waiting_.empty()) return;
    const auto issue = [&] {
      for (const std::function<void()>& launch : waiting_) launch();
    };
    const auto found = graphs_.find(key_);
    if (found == graphs_.end()) {
      if (graphs_.size() >= kMost) graphs_.clear();
      graphs_.try_emplace(key_);
      issue();
    } else {
      CudaGraph& graph = found->second;
      if (!graph.is_made()) graph.make(stream_, issue);
      graph.launch(stream_);
    }
    forget();
  }

 private:
  static constexpr size_t kMost = 64;  // sequences that are remembered

  void forget() {
    waiting_.clear();
    key_.clear();
  }

  void close(const std::vector<void*>& freed) {
    is_open_ = false;
    memory_in_use = nullptr;
    forget();
    for (void* const memory : freed) (void)cudaFree(memory);
  }

  cudaStream_t stream_;
  bool is_open_ = false;
  std::string key_;
  std::vector<std::function<void()>> waiting_;
  std::map<std::string, CudaGraph> graphs_;
};

}  // namespace ballpit
