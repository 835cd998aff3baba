// SPDX-License-Identifier: MIT
#include "tests/cuda/fault_injection.h"

#include <set>

// clang-format off
#include <epoxy/gl.h>  // before any other of OpenGL's
#include <cuda_gl_interop.h>
// clang-format on

namespace ballpit::faults {

namespace {

int64_t calls_left = 0;
std::string always;                 // this call fails
cudaError_t pending = cudaSuccess;  // what cudaGetLastError() is to tell, as the runtime would
std::string failed;
std::map<std::string, int64_t> counts;
std::set<void*> allocations;
std::set<cudaStream_t> streams;
std::set<cudaEvent_t> events;
std::set<void*> graphs;  // and executable ones
int64_t to_host = 0;     // [byte]
int64_t strangers = 0;   // handles given back that were not held

/// Counts a call; whether it is the one to fail.
bool fails(const char* name) {
  ++counts[name];
  if (always != name && (calls_left == 0 || --calls_left > 0)) return false;
  failed = name;
  pending = cudaErrorUnknown;
  return true;
}

template <class Set, class Handle>
void note_made(Set& handles, Handle handle) {
  if (handle != nullptr) handles.insert(handle);
}

/// Whether a handle may be given back: it was made, and not given back before.
template <class Set, class Handle>
bool note_released(Set& handles, Handle handle) {
  const bool is_known = handle == nullptr || handles.erase(handle) == 1;
  strangers += !is_known;
  return is_known;
}

}  // namespace

void fail_at(int64_t call) {
  calls_left = call;
  always.clear();
  pending = cudaSuccess;
  failed.clear();
  counts.clear();
  to_host = 0;
}
void fail_always(const std::string& name) {
  fail_at(0);
  always = name;
}
std::string failed_call() { return failed; }
Held held() {
  return {static_cast<int64_t>(allocations.size()), static_cast<int64_t>(streams.size()),
          static_cast<int64_t>(events.size()), static_cast<int64_t>(graphs.size()), strangers};
}
int64_t bytes_to_host() { return to_host; }
const std::map<std::string, int64_t>& calls() { return counts; }

}  // namespace ballpit::faults

using namespace ballpit::faults;

// NAME as it is called, and the runtime's own: fails on demand, else calls it.
#define BALLPIT_WRAP(NAME, PARAMETERS, ARGUMENTS)  \
  extern "C" cudaError_t __real_##NAME PARAMETERS; \
  extern "C" cudaError_t __wrap_##NAME PARAMETERS { return fails(#NAME) ? cudaErrorUnknown : __real_##NAME ARGUMENTS; }
// The same for what makes a handle.
#define BALLPIT_WRAP_MAKER(NAME, PARAMETERS, ARGUMENTS, HANDLES, HANDLE) \
  extern "C" cudaError_t __real_##NAME PARAMETERS;                       \
  extern "C" cudaError_t __wrap_##NAME PARAMETERS {                      \
    if (fails(#NAME)) return cudaErrorUnknown;                           \
    const cudaError_t status = __real_##NAME ARGUMENTS;                  \
    if (status == cudaSuccess) note_made(HANDLES, HANDLE);               \
    return status;                                                       \
  }
// Calls that release a handle report failures of earlier launches only, and do not fail here.
#define BALLPIT_WRAP_RELEASER(NAME, TYPE, HANDLES)                                         \
  extern "C" cudaError_t __real_##NAME(TYPE handle);                                       \
  extern "C" cudaError_t __wrap_##NAME(TYPE handle) {                                      \
    return note_released(HANDLES, handle) ? __real_##NAME(handle) : cudaErrorInvalidValue; \
  }

BALLPIT_WRAP_MAKER(cudaMalloc, (void** at, size_t bytes), (at, bytes), allocations, *at)
BALLPIT_WRAP_MAKER(cudaStreamCreate, (cudaStream_t * stream), (stream), streams, *stream)
BALLPIT_WRAP_MAKER(cudaEventCreate, (cudaEvent_t * event), (event), events, *event)
BALLPIT_WRAP_MAKER(cudaHostAlloc, (void** at, size_t bytes, unsigned flags), (at, bytes, flags), allocations, *at)
BALLPIT_WRAP_MAKER(cudaGraphInstantiate, (cudaGraphExec_t * made, cudaGraph_t graph, unsigned long long flags),
                   (made, graph, flags), graphs, *made)
BALLPIT_WRAP_RELEASER(cudaFreeHost, void*, allocations)
BALLPIT_WRAP_RELEASER(cudaGraphDestroy, cudaGraph_t, graphs)
BALLPIT_WRAP_RELEASER(cudaGraphExecDestroy, cudaGraphExec_t, graphs)
BALLPIT_WRAP_RELEASER(cudaFree, void*, allocations)
BALLPIT_WRAP_RELEASER(cudaStreamDestroy, cudaStream_t, streams)
BALLPIT_WRAP_RELEASER(cudaEventDestroy, cudaEvent_t, events)

extern "C" cudaError_t __real_cudaMemcpyAsync(void*, const void*, size_t, cudaMemcpyKind, cudaStream_t);
extern "C" cudaError_t __wrap_cudaMemcpyAsync(void* to, const void* from, size_t bytes, cudaMemcpyKind kind,
                                              cudaStream_t stream) {
  if (fails("cudaMemcpyAsync")) return cudaErrorUnknown;
  if (kind == cudaMemcpyDeviceToHost) to_host += static_cast<int64_t>(bytes);
  return __real_cudaMemcpyAsync(to, from, bytes, kind, stream);
}
BALLPIT_WRAP(cudaMemsetAsync, (void* at, int value, size_t bytes, cudaStream_t stream), (at, value, bytes, stream))
BALLPIT_WRAP(cudaStreamSynchronize, (cudaStream_t stream), (stream))
BALLPIT_WRAP(cudaEventRecord, (cudaEvent_t event, cudaStream_t stream), (event, stream))
BALLPIT_WRAP(cudaEventElapsedTime, (float* milliseconds, cudaEvent_t begin, cudaEvent_t end),
             (milliseconds, begin, end))
BALLPIT_WRAP(cudaStreamBeginCapture, (cudaStream_t stream, cudaStreamCaptureMode mode), (stream, mode))
BALLPIT_WRAP(cudaGraphLaunch, (cudaGraphExec_t graph, cudaStream_t stream), (graph, stream))
BALLPIT_WRAP(cudaHostGetDevicePointer, (void** device, void* host, unsigned flags), (device, host, flags))
BALLPIT_WRAP(cudaGetDeviceCount, (int* count), (count))
BALLPIT_WRAP(cudaGetDeviceProperties, (cudaDeviceProp * properties, int device), (properties, device))
BALLPIT_WRAP(cudaGetDevice, (int* device), (device))
BALLPIT_WRAP(cudaSetDevice, (int device), (device))
BALLPIT_WRAP(cudaDeviceGetAttribute, (int* value, cudaDeviceAttr attribute, int device), (value, attribute, device))
BALLPIT_WRAP(cudaFuncGetAttributes, (cudaFuncAttributes * attributes, const void* function), (attributes, function))
BALLPIT_WRAP(cudaOccupancyMaxActiveBlocksPerMultiprocessor,
             (int* blocks, const void* function, int threads, size_t shared), (blocks, function, threads, shared))
BALLPIT_WRAP(cudaOccupancyMaxActiveBlocksPerMultiprocessorWithFlags,
             (int* blocks, const void* function, int threads, size_t shared, unsigned flags),
             (blocks, function, threads, shared, flags))
BALLPIT_WRAP(cudaGLGetDevices, (unsigned* count, int* devices, unsigned most, cudaGLDeviceList list),
             (count, devices, most, list))
BALLPIT_WRAP(cudaGraphicsGLRegisterBuffer, (cudaGraphicsResource * *resource, GLuint buffer, unsigned flags),
             (resource, buffer, flags))
BALLPIT_WRAP(cudaGraphicsMapResources, (int count, cudaGraphicsResource_t* resources, cudaStream_t stream),
             (count, resources, stream))
// Ends the capture also where it fails, as the runtime does.
extern "C" cudaError_t __real_cudaStreamEndCapture(cudaStream_t, cudaGraph_t*);
extern "C" cudaError_t __wrap_cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph) {
  const cudaError_t status = __real_cudaStreamEndCapture(stream, graph);
  if (fails("cudaStreamEndCapture")) {
    if (status == cudaSuccess) (void)__real_cudaGraphDestroy(*graph);
    *graph = nullptr;
    return cudaErrorUnknown;
  }
  if (status == cudaSuccess) note_made(graphs, static_cast<void*>(*graph));
  return status;
}
// What <<<…>>> calls.
BALLPIT_WRAP(__cudaLaunchKernel,
             (cudaKernel_t kernel, dim3 grid, dim3 block, void** arguments, size_t shared, cudaStream_t stream),
             (kernel, grid, block, arguments, shared, stream))
BALLPIT_WRAP(cudaLaunchCooperativeKernel,
             (const void* kernel, dim3 grid, dim3 block, void** arguments, size_t shared, cudaStream_t stream),
             (kernel, grid, block, arguments, shared, stream))

extern "C" cudaError_t __real_cudaGetLastError();
extern "C" cudaError_t __wrap_cudaGetLastError() {
  const cudaError_t status = __real_cudaGetLastError(), injected = pending;
  pending = cudaSuccess;
  return injected != cudaSuccess ? injected : status;
}

extern "C" cudaError_t __real_cudaPeekAtLastError();
extern "C" cudaError_t __wrap_cudaPeekAtLastError() {
  return pending != cudaSuccess ? pending : __real_cudaPeekAtLastError();
}
