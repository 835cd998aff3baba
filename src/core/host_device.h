// SPDX-License-Identifier: MIT
// HOST_DEVICE marks functions that run on the CPU and, when compiled by nvcc, on the GPU as well.
// One of the few places that know of CUDA; kernels everywhere else are plain C++.
#pragma once

#ifdef __CUDACC__
#define HOST_DEVICE __host__ __device__
#else
#define HOST_DEVICE
#endif

namespace ballpit {

/// Whether this code is being compiled for the GPU: for the few places where what suits one processor hurts the other.
#ifdef __CUDA_ARCH__
inline constexpr bool kOnDevice = true;
#else
inline constexpr bool kOnDevice = false;
#endif

}  // namespace ballpit
