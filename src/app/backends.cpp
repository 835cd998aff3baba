// SPDX-License-Identifier: MIT
#include "app/backends.h"

#include "core/error.h"

namespace ballpit {

Backend select_backend(const std::string& name) {
  if (name == "cpu") return cpu_backend();
  Backend cuda = cuda_backend();
  if (cuda.unavailable_reason.empty()) return cuda;
  if (name == "auto") return cpu_backend();
  throw UserError("--backend: found cuda, which cannot serve here: " + cuda.unavailable_reason + "; allowed auto, cpu");
}

}  // namespace ballpit
