// SPDX-License-Identifier: MIT
// The settings that are chosen by name: an enum each, followed by its names on the command line, in the same order.
// These tables are the only places that map a value to a name, or back.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/error.h"

namespace ballpit {

template <class... Name>
constexpr std::array<std::string_view, sizeof...(Name)> in_order(Name... name) {
  return {name...};
}

template <class Enum>
inline constexpr auto kNames = in_order();

/// The last three run the slides' own kernels (src/lecture).
enum class BroadPhase {
  automatic,
  brute_force,
  sort_and_sweep,
  linked_cell,
  sorted_grid,
  lecture_brute_force,
  lecture_sort_and_sweep,
  lecture_linked_cell
};
template <>
inline constexpr auto kNames<BroadPhase> = in_order("auto", "brute-force", "sort-and-sweep", "linked-cell",
                                                    "sorted-grid", "lecture/brute-force", "lecture/sort-and-sweep",
                                                    "lecture/linked-cell");

/// Whether it is a slide's own kernel, which users must ask for by name.
constexpr bool is_of_lecture(BroadPhase method) { return method >= BroadPhase::lecture_brute_force; }

/// What a grid keeps its cells in: an array with an entry for each cell, or one with fewer entries, shared by hashing.
enum class CellTable { automatic, dense, hashed };
template <>
inline constexpr auto kNames<CellTable> = in_order("auto", "dense", "hashed");

/// The axis of sort and sweep; automatic: the one along which positions vary most.
enum class SweepAxis { automatic, x, y, z };
template <>
inline constexpr auto kNames<SweepAxis> = in_order("auto", "x", "y", "z");

/// automatic: the cheapest with which the scene shows what it needs (src/choose). Worlds are made of the others.
enum class Response { automatic, kinematic, impulse, penalty, position_based, event_driven };
template <>
inline constexpr auto kNames<Response> = in_order("auto", "kinematic", "impulse", "penalty", "position-based",
                                                  "event-driven");

/// How the impulse response iterates.
enum class Solver { jacobi, gauss_seidel };
template <>
inline constexpr auto kNames<Solver> = in_order("jacobi", "gauss-seidel");

/// What the impulse response does about overlap.
enum class Correction { split, none, surface };
template <>
inline constexpr auto kNames<Correction> = in_order("split", "none", "surface");

/// When a contact of the penalty response ends.
enum class ContactEnd { overlap, force };
template <>
inline constexpr auto kNames<ContactEnd> = in_order("overlap", "force");

/// automatic: the response's own.
enum class Integrator { automatic, explicit_euler, symplectic_euler, velocity_verlet, rk4, exact };
template <>
inline constexpr auto kNames<Integrator> = in_order("auto", "explicit-euler", "symplectic-euler", "velocity-verlet",
                                                    "rk4", "exact");

enum class Precision { float32, float64 };
template <>
inline constexpr auto kNames<Precision> = in_order("float", "double");

enum class BackendName { automatic, cpu, cuda };
template <>
inline constexpr auto kNames<BackendName> = in_order("auto", "cpu", "cuda");

enum class Language;  // core/language.h
template <>
inline constexpr auto kNames<Language> = in_order("en", "de");

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return kNames<Enum>[static_cast<size_t>(value)];
}

template <class Enum>
constexpr std::optional<Enum> find_named(std::string_view name) {
  const auto found = std::find(kNames<Enum>.begin(), kNames<Enum>.end(), name);
  if (found == kNames<Enum>.end()) return std::nullopt;
  return static_cast<Enum>(found - kNames<Enum>.begin());
}

/// The value of this name. Throws UserError if there is none.
template <class Enum>
Enum named(std::string_view name) {
  if (const std::optional<Enum> value = find_named<Enum>(name)) return *value;
  throw UserError("name", name, join(kNames<Enum>));
}

}  // namespace ballpit
