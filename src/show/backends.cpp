// SPDX-License-Identifier: MIT
#include "show/backends.h"

#include "core/error.h"
#include "methods/methods.h"

namespace ballpit {

Backend select_backend(const std::string& name, const std::string& response) {
  const bool is_cpu_alone = misfit(response, "backend", "cuda").has_value();
  if (name == "cpu" || (name == "auto" && is_cpu_alone)) return cpu_backend();
  Backend cuda = cuda_backend();
  if (cuda.unavailable_reason.empty()) return cuda;
  if (name == "auto") return cpu_backend();
  throw UserError("--backend", "cuda, which cannot serve here: " + cuda.unavailable_reason, "auto, cpu");
}

}  // namespace ballpit
