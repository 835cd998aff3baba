// SPDX-License-Identifier: MIT
// HOST_DEVICE marks functions that run on the CPU and, when compiled by nvcc, also on the GPU.
// Only a few headers depend on CUDA; all kernels are plain C++.
#pragma once

#ifdef __CUDACC__
#define HOST_DEVICE __host__ __device__
#else
#define HOST_DEVICE
#endif

namespace ballpit {

/// Whether this code is compiled for the GPU, for the few places that need different code there.
#ifdef __CUDA_ARCH__
inline constexpr bool kOnDevice = true;
#else
inline constexpr bool kOnDevice = false;
#endif

}  // namespace ballpit
