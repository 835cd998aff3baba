// SPDX-License-Identifier: MIT
// HOST_DEVICE marks functions that run on the CPU and, when compiled by nvcc, on the GPU as well.
// One of the few places that know of CUDA; kernels everywhere else are plain C++.
#pragma once

#ifdef __CUDACC__
#define HOST_DEVICE __host__ __device__
#else
#define HOST_DEVICE
#endif
