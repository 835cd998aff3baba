// SPDX-License-Identifier: MIT
// In formulas: n spheres in d dimensions, m, v, y a sphere's mass, velocity and height, V the domain's volume (in the plane its
// area), T the time of observation, since the start or since --observe-from, ⟨…⟩ a mean over spheres.
#include "world/observables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ballpit {

namespace {

/// No value. Ratios with a denominator of 0 have none either.
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double count_of(const Observation& o) { return static_cast<double>(o.bodies.size()); }

double total_mass(const Bodies& bodies) { return std::accumulate(bodies.mass.begin(), bodies.mass.end(), 0.0); }

/// [m/s] The mean velocity, which is not thermal motion. Momentum is conserved only in a periodic domain.
Vec3d drift_of(const Observation& o) {
  if (o.domain.boundary != Boundary::periodic) return Vec3d(0.0);
  Vec3d momentum(0.0);
  for (size_t i = 0; i < o.bodies.mass.size(); ++i) momentum += o.bodies.mass[i] * o.bodies.velocity[i];
  return momentum / total_mass(o.bodies);
}

/// ⟨|v − drift|^power⟩ for an even power
double mean_speed_power(const Observation& o, const Vec3d& drift, int power) {
  double sum = 0;
  for (const Vec3d& v : o.bodies.velocity) sum += std::pow(dot(v - drift, v - drift), power / 2);
  return sum / count_of(o);
}

double thermal_energy(const Observation& o) {
  const Vec3d drift = drift_of(o);
  double sum = 0;
  for (size_t i = 0; i < o.bodies.mass.size(); ++i) {
    const Vec3d v = o.bodies.velocity[i] - drift;
    sum += 0.5 * o.bodies.mass[i] * dot(v, v);
  }
  return sum;
}

/// kT [J] by equipartition: each degree of freedom has kT/2. If momentum is conserved, one sphere has no freedom (Allen and Tildesley, Computer Simulation of Liquids, 2017, section 2.4).
double temperature(const Observation& o) {
  const double n = count_of(o);
  if (n < 2) return kNone;  // the motion of one sphere is not thermal
  const double free = o.domain.boundary == Boundary::periodic ? n - 1 : n;
  return 2 * thermal_energy(o) / (o.domain.dimensions * free);
}

/// V [m³], in the plane [m²]; none under an open top.
double volume(const Domain& domain) {
  if (domain.boundary == Boundary::open_top) return kNone;
  const Vec3d size = domain.max - domain.min;
  return domain.dimensions == 2 ? size.x * size.y : size.x * size.y * size.z;
}

/// Allen and Tildesley 2017, section 2.4: PV = N·kT + ⟨internal virial⟩, which for impulses is their sum over time (Erpenbeck and
/// Wood 1977, Molecular dynamics techniques for hard-core systems).
double pressure(const Observation& o) {
  const double virial_rate = o.report.tally.virial / (o.domain.dimensions * o.report.time);  // [J]
  return (count_of(o) * temperature(o) + virial_rate) / volume(o.domain);
}

double compressibility(const Observation& o) { return pressure(o) * volume(o.domain) / (count_of(o) * temperature(o)); }

/// Each collision counts for both spheres. Counted so, hard spheres of mass m and diameter σ collide at the rate
/// Γ = (6/√π)·(Z − 1)·√(kT/m)/σ (by Enskog's theory, and by the virial).
double collisions_per_sphere(const Observation& o) {
  return 2 * static_cast<double>(o.report.tally.collisions) / count_of(o);
}

double collisions(const Observation& o) {
  return static_cast<double>(o.report.tally.collisions + o.report.tally.wall_hits);
}

double collision_rate(const Observation& o) { return collisions_per_sphere(o) / o.report.time; }

double mean_free_time(const Observation& o) { return 1 / collision_rate(o); }

/// Einstein's relation (Allen and Tildesley 2017, section 2.7). In a periodic domain the mean way is that of the centre
/// of mass, which is not diffusion.
double diffusion(const Observation& o) {
  if (o.domain.boundary != Boundary::periodic || o.ways.empty()) return kNone;
  const double n = count_of(o);
  Vec3d mean(0.0);
  for (const Vec3d& way : o.ways) mean += way / n;
  double sum = 0;
  for (const Vec3d& way : o.ways) sum += dot(way - mean, way - mean);
  return sum / n / (2 * o.domain.dimensions * o.report.time);
}

double floor_force(const Observation& o) {
  return o.domain.boundary == Boundary::periodic ? kNone : o.report.tally.floor_impulse / o.report.time;
}

double velocity_moment(const Observation& o) {
  const Vec3d drift = drift_of(o);
  const double square = mean_speed_power(o, drift, 2);
  return mean_speed_power(o, drift, 4) / (square * square);
}

double mean_square_speed(const Observation& o) { return mean_speed_power(o, Vec3d(0.0), 2); }

double centre_of_mass_height(const Observation& o) {
  if (o.domain.boundary == Boundary::periodic) return kNone;  // its images have other heights
  double moment = 0;
  for (size_t i = 0; i < o.bodies.mass.size(); ++i) moment += o.bodies.mass[i] * o.bodies.position[i].y;
  return moment / total_mass(o.bodies) - o.domain.min.y;
}

double missed_contacts(const Observation& o) {
  return o.missed_contacts ? static_cast<double>(o.missed_contacts()) : kNone;
}

double kinetic_energy(const Observation& o) { return o.report.kinetic_energy; }
double potential_energy(const Observation& o) { return o.report.potential_energy; }
double elastic_energy(const Observation& o) { return o.report.elastic_energy; }
double total_energy(const Observation& o) { return kinetic_energy(o) + potential_energy(o) + elastic_energy(o); }
double max_overlap(const Observation& o) { return o.report.max_overlap; }

template <double (*kCompute)(const Observation&)>
ObservedValue number(const Observation& o) {
  return {kCompute(o)};
}

ObservedValue momentum(const Observation& o) { return {o.report.momentum.x, o.report.momentum.y, o.report.momentum.z}; }

constexpr std::array kObservables{
    Observable{"kinetic-energy", "Kinetic energy", "J", "J", "Σ m·v²/2", false, number<kinetic_energy>},
    Observable{"potential-energy", "Potential energy", "J", "J", "−Σ m·g·x, zero at the origin", false,
               number<potential_energy>},
    Observable{"elastic-energy", "Elastic energy", "J", "J",
               "energy in the springs of the penalty response, 0 with any other", false, number<elastic_energy>},
    Observable{"total-energy", "Total energy", "J", "J", "kinetic, potential and elastic energy together", false,
               number<total_energy>},
    Observable{"momentum", "Momentum", "kg·m/s", "kg·m/s", "Σ m·v, along x, y and z", false, momentum},
    Observable{
        "temperature", "Temperature kT", "J", "J",
        "2K/(d·n) within walls; 2K/(d·(n − 1)) in a periodic domain, K without the motion of the centre of mass; "
        "none of one sphere",
        false, number<temperature>},
    Observable{"mean-square-speed", "Mean square speed", "m²/s²", "m²/s²", "⟨v²⟩", false, number<mean_square_speed>},
    Observable{"velocity-moment", "Fourth velocity moment", "1", "1",
               "⟨v⁴⟩/⟨v²⟩², in a periodic domain relative to the centre of mass; 1 for equal speeds, 1 + 2/d for equal "
               "masses in equilibrium",
               false, number<velocity_moment>},
    Observable{
        "collisions", "Collisions", "1", "1",
        "of two spheres, or of a sphere and a wall, since the start or since --observe-from; what lies on a wall "
        "does not hit it",
        true, number<collisions>},
    Observable{"collisions-per-sphere", "Collisions per sphere", "1", "1",
               "2·C/n with the number C of collisions of two spheres, walls left out: each is one of either sphere",
               true, number<collisions_per_sphere>},
    Observable{"collision-rate", "Collision rate", "1/s", "1/s",
               "collisions per sphere / T: those of one sphere in a second", true, number<collision_rate>},
    Observable{"mean-free-time", "Mean free time", "s", "s", "1/collision rate: between two collisions of a sphere",
               true, number<mean_free_time>},
    Observable{"diffusion", "Self-diffusion coefficient", "m²/s", "m²/s",
               "⟨way²⟩/(2·d·T), the way being that of a sphere relative to the centre of mass; only in a periodic "
               "domain",
               false, number<diffusion>, true},
    Observable{
        "pressure", "Pressure", "Pa", "N/m",
        "(n·kT + W/(d·T))/V with the virial W = Σ over collisions of impulse · distance of the centres; kT of the "
        "present state; none under an open top",
        true, number<pressure>},
    Observable{"compressibility", "Compressibility factor Z", "1", "1", "pressure·V/(n·kT); 1 for an ideal gas", true,
               number<compressibility>},
    Observable{"floor-force", "Floor force", "N", "N",
               "impulse given to the wall at the bottom / T; none in a periodic domain", true, number<floor_force>},
    Observable{"centre-of-mass-height", "Height of the centre of mass", "m", "m",
               "Σ m·y/Σ m above the bottom of the domain; none in a periodic one", false,
               number<centre_of_mass_height>},
    Observable{"max-overlap", "Largest overlap", "1", "1",
               "of two spheres, or of a sphere and a wall, as a fraction of the smaller radius", false,
               number<max_overlap>},
    Observable{
        "missed-contacts", "Missed contacts", "1", "1",
        "pairs that touch in the present state, by another search without options of its own, and that the run's "
        "method did not find",
        false, number<missed_contacts>},
};

}  // namespace

std::span<const Observable> observables() { return kObservables; }

ObservedValue measure(const Observable& observable, const Observation& observation) {
  ObservedValue value = observable.compute(observation);
  const bool is_finite = std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); });
  return is_finite ? value : ObservedValue{};
}

std::string_view unit_of(const Observable& observable, const Domain& domain) {
  return domain.dimensions == 2 ? observable.planar_unit : observable.unit;
}

}  // namespace ballpit
