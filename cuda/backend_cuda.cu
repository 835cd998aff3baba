// SPDX-License-Identifier: MIT
// The CUDA backend: worlds and pair searches on an NVIDIA GPU.
#include "cuda_executor.h"
#include "methods/methods.h"
#include "world/make_world.h"
#include "world/pair_search_on.h"

namespace ballpit {

namespace {

/// Initializes the CUDA runtime; returns why it is unavailable, or nothing. Without a driver the runtime does not set
/// the count and remembers the error, so this checks the returned code and clears the error.
std::string why_unavailable() {
  int devices = 0;
  const cudaError_t status = cudaGetDeviceCount(&devices);
  if (status != cudaSuccess) {
    (void)cudaGetLastError();
    return cudaGetErrorString(status);
  }
  return devices > 0 ? "" : "no CUDA device";
}

std::string describe_device() {
  cudaDeviceProp properties{};
  BALLPIT_CUDA_CHECK(cudaGetDeviceProperties(&properties, 0));
  return std::string(properties.name) + ", compute capability " + std::to_string(properties.major) + "." +
         std::to_string(properties.minor);
}

}  // namespace

Backend cuda_backend() {
  const std::string reason = why_unavailable();
  return {"cuda", reason, reason.empty() ? describe_device() : "",
          [](const Scene& scene, const Settings& settings) {
            const std::string allowed = allowed_instead(settings.response, "backend", "cuda");
            if (!allowed.empty()) throw UserError("--backend", "cuda", allowed);
            return make_world_on(std::make_unique<CudaExecutor>(), scene, settings);
          },
          [](const Settings& settings) -> std::unique_ptr<PairSearch> {
            return std::make_unique<PairSearchOn<CudaExecutor>>(std::make_unique<CudaExecutor>(), settings);
          }};
}

}  // namespace ballpit
