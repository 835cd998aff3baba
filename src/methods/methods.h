// SPDX-License-Identifier: MIT
// One table of all methods; command line, panel, tests and documentation are fed from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ballpit {

enum class Family { broadphase, response, solver, integrator, precision, backend };

struct Method {
  Family family;
  std::string_view name;      ///< as on the command line
  std::string_view label;     ///< as the audience reads it
  std::string_view backends;  ///< where it runs
  std::string_view cost;
  std::string_view source;
  std::string_view integrators = "";  ///< of a response: those it goes with, its own choice first
  std::string_view options = "";      ///< of a broad phase or a response: those options of its kind that it uses
  std::string_view precisions = "float, double";  ///< of a response: those it computes in
};

std::span<const Method> methods();

/// The names of a family's methods, in the table's order.
std::vector<std::string_view> method_names(Family family);

/// The entry of this name. Throws UserError where there is none.
const Method& find_method(Family family, std::string_view name);

/// A value that does not go with a response: "rk4", and "symplectic-euler with --response impulse".
struct Misfit {
  std::string found, allowed;
};

/// What is wrong with `--option value` for a response, if anything.
std::optional<Misfit> misfit(std::string_view response, std::string_view option, std::string_view value);

/// Whether a broad phase or a response uses an option of its kind.
bool uses(const Method& method, std::string_view option);

/// Whether `--option value` can be asked for with a response.
bool goes_with(std::string_view response, std::string_view option, std::string_view value);

/// "broadphase", …
std::string_view family_name(Family family);

}  // namespace ballpit
