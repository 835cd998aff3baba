// SPDX-License-Identifier: MIT
#include "core/program.h"

#include <cstdlib>
#include <sstream>

#include <unistd.h>

namespace ballpit {

std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string candidate = folder + "/" + name;
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return "";
}

}  // namespace ballpit
