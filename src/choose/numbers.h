// SPDX-License-Identifier: MIT
// What kind of scene it is: the pure numbers by which the rules (rules.h) judge methods. Computed from the scene at its
// start, with kinetic theory for what follows. Cost: O(n) for n spheres.
#pragma once

#include <string>
#include <vector>

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

struct SceneNumbers {
  int64_t count = 0;
  int dimensions = 3;
  bool has_gravity = false;
  bool loses_energy = false;      ///< restitution below 1, of spheres that can meet or of walls that can be met
  bool is_planar_motion = false;  ///< nothing moves along z
  bool has_equal_radii = true, has_equal_masses = true;

  double radius_min = 0, radius_max = 0;  ///< [m]
  double mass_min = 0, mass_max = 0;      ///< [kg]
  double packing = 0;                     ///< η: the volume of all spheres in that of the domain
  double typical_speed = 0;               ///< [m/s] RMS, or of a fall from the mean height
  double largest_speed = 0;               ///< [m/s] of the fastest sphere, also after its fall to the bottom
  double narrowest = 0;                   ///< [m] r_i + r_j of the fastest sphere and the smallest other one
  double collision_rate = 0;              ///< Γ [1/s] of a sphere, by kinetic theory
  double contact_duration = 0;            ///< t_c [s] of the scene's springs
  double gravity = 0;                     ///< [m/s²]
  double layers = 1;                      ///< n: spheres on top of each other, once they lie
  double load = 0;                        ///< [kg] of the spheres on top of each other, with the lowest
  double rest_time = 0;                   ///< [s] after which contacts last; infinite if they never do
  double reach = 0;                       ///< [m] the largest coordinate
  double start_overlap = 0;               ///< at the start, as a fraction of the smaller radius

  double size_ratio() const { return radius_min > 0 ? radius_max / radius_min : 1; }  ///< q
  double mass_ratio() const { return mass_min > 0 ? mass_max / mass_min : 1; }        ///< R

  /// v·dt/D of the fastest sphere.
  double flight(double dt) const { return narrowest > 0 ? largest_speed * dt / narrowest : 0; }

  /// v·dt of a typical sphere, in units of half the distance between two neighbouring floats at `reach`.
  double float_steps(double dt) const;
};

SceneNumbers numbers_of(const Scene& scene);

/// A number for people.
struct NamedNumber {
  std::string_view key;  ///< "contact_share", for other programs
  std::string symbol;    ///< "Γ·t_c"
  double value;
  std::string meaning;  ///< one short line
};

/// Those that are printed; `dt` [s] is the length of the steps that the scene has now.
std::vector<NamedNumber> named_numbers(const SceneNumbers& numbers, double dt);

/// The largest stable step [s] of the scene's springs in a packing, 0.7071·√(m/k), with Hertz's k at the overlap of a
/// typical hit. Twelve contacts of an fcc packing: 2/ω_max.
double stable_step(const Scene& scene, const SceneNumbers& numbers);

}  // namespace ballpit
