// SPDX-License-Identifier: MIT
// Checks every CUDA call when it returns. The message names the expression that failed, or the stage of a failed
// launch.
#pragma once

#include <string>

#include <cuda_runtime.h>

#include "core/error.h"

namespace ballpit {

inline void check_cuda(cudaError_t status, const char* expression) {
  if (status == cudaSuccess) return;
  (void)cudaGetLastError();  // so that a later check does not report it again
  throw RunError("CUDA", std::string(expression) + ": " + cudaGetErrorString(status));
}

}  // namespace ballpit

#define BALLPIT_CUDA_CHECK(expression) ::ballpit::check_cuda((expression), #expression)
