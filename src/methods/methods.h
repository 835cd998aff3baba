// SPDX-License-Identifier: MIT
// One table of all methods; command line, panel, tests and documentation are fed from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

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
  std::string_view integrators = "";  ///< of a response: those it goes with, its own choice first
  std::string_view options = "";      ///< of a broad phase or a response: those options of its kind that it uses
  std::string_view precisions = "float, double";  ///< of a response: those it computes in
};

std::span<const Method> methods();

/// The entry of a value.
const Method& find_method(MethodId id);

/// A value that does not go with a response: "rk4", and "symplectic-euler with --response impulse".
struct Misfit {
  std::string found, allowed;
};

/// What is wrong with `--option value` for a response, if anything.
std::optional<Misfit> misfit(Response response, std::string_view option, std::string_view value);

/// Whether a broad phase or a response uses an option of its kind.
bool uses(const Method& method, std::string_view option);

/// Whether `--option value` can be asked for with a response.
bool goes_with(Response response, std::string_view option, std::string_view value);

}  // namespace ballpit
