// SPDX-License-Identifier: MIT
// One table of all methods, for the command line, the panel, tests and documentation.
#pragma once

#include <span>

#include "methods/choices.h"

namespace ballpit {

enum class Family { broadphase, response, solver, integrator, precision, backend };
template <>
inline constexpr auto kNames<Family> = in_order("broadphase", "response", "solver", "integrator", "precision",
                                                "backend");

constexpr Family family_of(BroadPhase) { return Family::broadphase; }
constexpr Family family_of(Response) { return Family::response; }
constexpr Family family_of(Solver) { return Family::solver; }
constexpr Family family_of(Integrator) { return Family::integrator; }
constexpr Family family_of(Precision) { return Family::precision; }
constexpr Family family_of(BackendName) { return Family::backend; }

struct MethodId {
  template <class Enum>
  constexpr MethodId(Enum value) : family(family_of(value)), name(name_of(value)) {}

  Family family;
  std::string_view name;  ///< as on the command line
};

struct Method : MethodId {
  std::string_view label;     ///< as the audience reads it
  std::string_view backends;  ///< where it runs
  std::string_view cost;
  std::string_view source;
  std::string_view integrators = "";              ///< of a response: its own first, then the others that fit it
  std::string_view options = "";                  ///< of a broad phase or a response: the options that it uses
  std::string_view precisions = "float, double";  ///< of a response
};

std::span<const Method> methods();

/// The entry of a method.
const Method& find_method(MethodId id);

/// What is allowed if `--option value` does not fit the response: "symplectic-euler with --response impulse"; empty if it fits.
std::string allowed_instead(Response response, std::string_view option, std::string_view value);

/// Whether a broad phase or a response uses an option.
bool uses(const Method& method, std::string_view option);

/// Whether `--option value` fits the response.
inline bool goes_with(Response response, std::string_view option, std::string_view value) {
  return allowed_instead(response, option, value).empty();
}

}  // namespace ballpit
