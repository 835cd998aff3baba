// SPDX-License-Identifier: MIT
#include "app/notes.h"

#include <iostream>

#include "scene/input_error.h"

namespace ballpit {

void tell_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) std::cerr << "ballpit: warning: " << visible(note) << "\n";
}

}  // namespace ballpit
