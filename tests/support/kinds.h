// SPDX-License-Identifier: MIT
// All responses for the tests, with crowds of spheres for them.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/support/hits.h"
#include "tests/support/scenes.h"

namespace ballpit {

/// A response with what it goes by.
struct Kind {
  std::string response;
  std::string integrator = "auto";
  double restitution = 0.7;
  bool is_swept = false;
  std::string solver = "jacobi";
};

/// Without losses velocity Verlet keeps accelerations from step to step; event-driven spheres keep their latest events.
inline std::vector<Kind> kinds() {
  return {{"kinematic"},
          {"kinematic", "auto", 0.9, true},
          {"impulse"},
          {"impulse", "auto", 0.7, false, "gauss-seidel"},
          {"impulse", "auto", 0.7, true},
          {"penalty", "velocity-verlet"},
          {"penalty", "velocity-verlet", 1.0},
          {"penalty", "symplectic-euler"},
          {"penalty", "explicit-euler"},
          {"penalty", "rk4"},
          {"position-based"},
          {"event-driven"}};
}

/// One of its kind for each thing that a world may keep for each body.
inline std::vector<Kind> keepers() {
  return {{"kinematic"}, {"impulse"}, {"penalty", "velocity-verlet", 1.0}, {"penalty", "rk4"}, {"position-based"}};
}

inline std::ostream& operator<<(std::ostream& out, const Kind& kind) {
  return out << kind.response << ", integrator " << kind.integrator << ", e = " << kind.restitution
             << (kind.is_swept ? ", swept, " : ", ") << kind.solver;
}

inline Settings settings_of(const Kind& kind, int turn = 0) {
  constexpr const char* kBroadPhases[] = {"linked-cell", "sort-and-sweep", "sorted-grid", "brute-force", "auto"};
  Settings settings = settings_of(kind.response, 1.0 / 480, kind.integrator);
  settings.solver = named<Solver>(kind.solver);
  settings.is_swept = kind.is_swept;
  settings.broadphase = named<BroadPhase>(kBroadPhases[turn % 5]);
  settings.threads = 1 + turn % 2;
  settings.max_energy = 1e15;  // explicit Euler gains it
  settings.keeps_tally = true;
  return settings;
}

inline Scene crowd(int dimensions, int side, const Kind& kind, Boundary boundary = Boundary::walls) {
  const double largest = kind.response == "event-driven" ? 0.05 : 0.07;  // there none may overlap
  return make_crowd(dimensions, side, boundary, kind.restitution, 0.04, largest);
}

}  // namespace ballpit
