// SPDX-License-Identifier: MIT
#include "methods/methods.h"

#include <algorithm>

namespace ballpit {

namespace {

constexpr std::array kMethods{
    Method{BroadPhase::automatic, "Best predicted", "cpu, cuda",
           "chosen by predicted time, with a candidate list (skin 0.1)", "", "", "cell-size, table, axis"},
    Method{BroadPhase::brute_force, "Brute force", "cpu, cuda", "O(n²) tests, no structure", "slides 5 and 6"},
    Method{BroadPhase::sort_and_sweep, "Sort and sweep", "cpu, cuda",
           "O(n) sort by radix, O(n^(5/3)) tests in a cube; 24 bytes a sphere", "slides 2 to 4; Baraff 1992", "",
           "axis"},
    Method{BroadPhase::linked_cell, "Linked cell", "cpu, cuda",
           "O(n) while cells hold O(1) spheres; 4 bytes a cell and 4 a sphere", "slides 8 to 17", "",
           "cell-size, table"},
    Method{BroadPhase::sorted_grid, "Sorted grid", "cpu, cuda",
           "O(n), a grid for each size class; 4 bytes a cell and 20 a sphere", "Green 2010; Ericson 2005, section 7.2",
           "", "cell-size, table"},
    Method{BroadPhase::lecture_brute_force, "Brute force, as on the slides", "cpu, cuda", "O(n²) tests, one by one",
           "slide 5"},
    Method{BroadPhase::lecture_sort_and_sweep, "Sort and sweep, as on the slides", "cpu, cuda",
           "as sort-and-sweep; a thread per list entry, which walks the list", "slides 2 to 4", "", "axis"},
    Method{BroadPhase::lecture_linked_cell, "Linked cell, as on the slides", "cpu, cuda",
           "as linked-cell; contacts are appended by an atomic operation", "slides 8 to 17", "", "cell-size"},
    Method{Response::automatic, "Cheapest that is good enough", "cpu, cuda", "chosen by [needs], with pilots",
           "docs/choice.md", "exact, symplectic-euler, velocity-verlet, explicit-euler, rk4",
           "iterations, solver, correction, contact-end, compliance, contact-duration, swept"},
    Method{Response::kinematic, "Kinematic", "cpu, cuda", "O(n + contacts)",
           "exercise sheet 2; plausible, not physical", "symplectic-euler", "swept"},
    Method{Response::impulse, "Impulse", "cpu, cuda", "O(n + contacts) an iteration",
           "Tonge et al. 2012, doi 10.1145/2185520.2185601", "symplectic-euler",
           "iterations, solver, correction, swept"},
    Method{Response::penalty, "Penalty", "cpu, cuda", "O(n + contacts), steps well below a contact's duration",
           "exercise sheet 2; Cundall and Strack 1979, doi 10.1680/geot.1979.29.1.47",
           "velocity-verlet, symplectic-euler, explicit-euler, rk4", "contact-end"},
    Method{Response::position_based, "Position-based", "cpu, cuda", "O(n + contacts) an iteration",
           "XPBD: Macklin et al. 2016, doi 10.1145/2994258.2994272", "symplectic-euler", "iterations, compliance"},
    Method{Response::event_driven, "Event-driven", "cpu", "O(log n) a collision; exact",
           "Alder and Wainwright 1959, doi 10.1063/1.1730376", "exact", "contact-duration", "double"},
    Method{Solver::jacobi, "Jacobi", "cpu, cuda", "all contacts at once; one launch an iteration",
           "mass splitting: Tonge et al. 2012, doi 10.1145/2185520.2185601"},
    Method{Solver::gauss_seidel, "Gauss-Seidel", "cpu, cuda", "colour by colour, one after the other; fewer iterations",
           "Fratarcangeli et al. 2016, doi 10.1145/2980179.2982437"},
    Method{Integrator::automatic, "The response's own", "cpu, cuda", "", ""},
    Method{Integrator::explicit_euler, "Explicit Euler", "cpu, cuda", "first order, energy grows",
           "Hairer, Lubich, Wanner 2006, section I.1"},
    Method{Integrator::symplectic_euler, "Symplectic Euler", "cpu, cuda", "first order, bounded energy error",
           "Hairer, Lubich, Wanner 2006, section I.1"},
    Method{Integrator::velocity_verlet, "Velocity Verlet", "cpu, cuda", "second order, bounded energy error",
           "Swope et al. 1982, doi 10.1063/1.442716"},
    Method{Integrator::rk4, "Runge-Kutta 4", "cpu, cuda", "fourth order, four force evaluations a step",
           "Hairer, Norsett, Wanner 1993, section II.1"},
    Method{Integrator::exact, "Exact flight", "cpu", "parabolas from event to event", "event-driven alone"},
    Method{Precision::float32, "Single precision", "cpu, cuda", "4 bytes a number", "IEEE 754"},
    Method{Precision::float64, "Double precision", "cpu, cuda", "8 bytes a number", "IEEE 754"},
    Method{BackendName::automatic, "Best available", "cpu, cuda", "CUDA where a device answers, else the CPU", ""},
    Method{BackendName::cpu, "CPU", "cpu", "all cores, by oneTBB", ""},
    Method{BackendName::cuda, "CUDA", "cuda", "an NVIDIA GPU of compute capability 7.5 or later", ""},
};

/// Whether the list "a, b, c" has this name.
bool lists(std::string_view names, std::string_view name) {
  for (size_t start = 0; start < names.size();) {
    const size_t end = std::min(names.find(", ", start), names.size());
    if (names.substr(start, end - start) == name) return true;
    start = end + 2;
  }
  return false;
}

}  // namespace

std::span<const Method> methods() { return kMethods; }

const Method& find_method(MethodId id) {
  return *std::find_if(kMethods.begin(), kMethods.end(),
                       [&](const Method& method) { return method.family == id.family && method.name == id.name; });
}

std::string allowed_instead(Response response, std::string_view option, std::string_view value) {
  const Method& method = find_method(response);
  const std::string name(method.name), with = " with --response " + name;
  const auto refuses = [&](std::string_view key, std::string_view values) {
    return option == key && value != "auto" && !lists(values, value);
  };
  if (refuses("integrator", method.integrators)) return std::string(method.integrators) + with;
  if (refuses("backend", method.backends)) return "auto, " + std::string(method.backends) + with;
  if (refuses("precision", method.precisions)) return std::string(method.precisions) + with;
  std::vector<std::string_view> users;
  for (const Method& other : kMethods) {
    const bool is_response = other.family == Family::response && other.name != name_of(Response::automatic);
    if (is_response && lists(other.options, option)) users.push_back(other.name);
  }
  if (users.empty() || lists(method.options, option)) return "";
  return "with --response " + join(users) + ", not " + name;
}

bool uses(const Method& method, std::string_view option) { return lists(method.options, option); }

}  // namespace ballpit
