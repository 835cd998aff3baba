// SPDX-License-Identifier: MIT
// What searches are tried on: scenes from harmless to adversarial, and every way to search them.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

struct Input {
  std::string name;
  std::function<Scene(uint64_t seed)> make;
};

/// Each in space and in the plane, with contacts.
const std::vector<Input>& inputs();

/// A broad phase with its options.
struct Way {
  std::string broadphase = "linked-cell";
  std::string table = "auto";
  std::string axis = "auto";
  double cell_size = 0;  ///< 0: the method chooses
  int threads = 1;
  double skin = 0;
};

/// All methods with all tables and axes, on one thread and on two.
std::vector<Way> ways(int dimensions);

/// Methods with cells of one to four diameters.
std::vector<Way> ways_with_cell_sizes();

Settings settings_of(const Way& way);
std::ostream& operator<<(std::ostream& out, const Way& way);

}  // namespace ballpit
