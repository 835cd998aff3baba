// SPDX-License-Identifier: MIT
// Every CUDA call is checked where it returns; the message names the expression that failed, or the stage whose launch did.
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
