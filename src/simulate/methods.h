// SPDX-License-Identifier: MIT
// One table of all methods; command line, panel, tests and documentation are fed from it.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace ballpit {

enum class Family { broadphase, response, integrator, precision, backend };

struct Method {
  Family family;
  std::string_view name;      ///< as on the command line
  std::string_view label;     ///< as the audience reads it
  std::string_view backends;  ///< where it runs
  std::string_view cost;
  std::string_view source;
};

std::span<const Method> methods();

/// The names of a family's methods, in the table's order.
std::vector<std::string_view> method_names(Family family);

/// "broadphase", …
std::string_view family_name(Family family);

}  // namespace ballpit
