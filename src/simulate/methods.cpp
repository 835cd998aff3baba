// SPDX-License-Identifier: MIT
#include "simulate/methods.h"

#include <array>

namespace ballpit {

namespace {

constexpr std::array kMethods{
    Method{Family::broadphase, "auto", "Best predicted", "cpu, cuda",
           "chosen by predicted time, with a candidate list (skin 0.1)", ""},
    Method{Family::broadphase, "brute-force", "Brute force", "cpu, cuda", "O(n²) tests, no structure",
           "slides 5 and 6"},
    Method{Family::broadphase, "sort-and-sweep", "Sort and sweep", "cpu, cuda",
           "O(n) sort by radix, O(n^(5/3)) tests in a cube; 24 bytes a sphere", "slides 2 to 4; Baraff 1992"},
    Method{Family::broadphase, "linked-cell", "Linked cell", "cpu, cuda",
           "O(n) while cells hold O(1) spheres; 4 bytes a cell and 4 a sphere", "slides 8 to 17"},
    Method{Family::broadphase, "sorted-grid", "Sorted grid", "cpu, cuda",
           "O(n), a grid for each size class; 4 bytes a cell and 20 a sphere", "Green 2010; Ericson 2005, section 7.2"},
    Method{Family::response, "impulse", "Impulse", "cpu, cuda", "O(n + contacts) an iteration",
           "Tonge et al. 2012, doi 10.1145/2185520.2185601"},
    Method{Family::integrator, "symplectic-euler", "Symplectic Euler", "cpu, cuda", "first order, bounded energy error",
           "Hairer, Lubich, Wanner 2006, section I.1"},
    Method{Family::precision, "float", "Single precision", "cpu, cuda", "4 bytes a number", "IEEE 754"},
    Method{Family::backend, "auto", "Best available", "cpu, cuda", "CUDA where a device answers, else the CPU", ""},
    Method{Family::backend, "cpu", "CPU", "cpu", "all cores, by oneTBB", ""},
    Method{Family::backend, "cuda", "CUDA", "cuda", "an NVIDIA GPU of compute capability 7.5 or later", ""},
};

}  // namespace

std::span<const Method> methods() { return kMethods; }

std::vector<std::string_view> method_names(Family family) {
  std::vector<std::string_view> names;
  for (const Method& method : kMethods) {
    if (method.family == family) names.push_back(method.name);
  }
  return names;
}

std::string_view family_name(Family family) {
  constexpr std::array<std::string_view, 5> names{"broadphase", "response", "integrator", "precision", "backend"};
  return names[static_cast<size_t>(family)];
}

}  // namespace ballpit
