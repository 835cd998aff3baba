// SPDX-License-Identifier: MIT
#include "show/backends.h"

#include "core/error.h"
#include "methods/methods.h"

namespace ballpit {

Backend select_backend(BackendName name, Response response) {
  const bool is_cpu_only = !goes_with(response, "backend", "cuda");
  if (name == BackendName::cpu || (name == BackendName::automatic && is_cpu_only)) return cpu_backend();
  Backend cuda = cuda_backend();
  if (cuda.unavailable_reason.empty()) return cuda;
  if (name == BackendName::automatic) return cpu_backend();
  throw UserError("--backend", "cuda, which cannot serve here: " + cuda.unavailable_reason, "auto, cpu");
}

}  // namespace ballpit
