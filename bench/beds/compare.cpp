// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>

#include "simulate/world.h"

namespace ballpit {

namespace {

/// The same as LAMMPS does: lists are made before the first step, and `warmup` steps before the clock starts.
Measured run_ours(const Bed& bed, const Settings& settings, const Stretch& stretch) {
  const std::unique_ptr<World> world = cpu_backend().make_world(bed.scene, settings);
  for (int64_t k = 0; k < stretch.warmup; ++k) world->step();
  const auto start = std::chrono::steady_clock::now();
  for (int64_t k = 0; k < stretch.steps; ++k) world->step();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Report report = world->report();
  return {seconds, report.kinetic_energy, report.contacts, report.searches};
}

void add_turn(Turns& turns, const Measured& measured, int64_t count, int64_t steps) {
  turns.speed.push_back(1e-6 * static_cast<double>(count) * static_cast<double>(steps) / measured.seconds);
  turns.last = measured;
}

double volume_fraction(const Scene& scene) {
  double top = 0, volume = 0;
  for (size_t i = 0; i < scene.bodies.position.size(); ++i) {
    top = std::max(top, scene.bodies.position[i].y);
    volume += 4.0 / 3 * std::numbers::pi * std::pow(scene.bodies.radius[i], 3);
  }
  const Vec3d size = scene.domain.max - scene.domain.min;
  return volume / (size.x * size.z * top);
}

}  // namespace

Spread BedRow::ratio() const {
  std::vector<double> ratios;
  for (size_t k = 0; k < ours->speed.size(); ++k) ratios.push_back(ours->speed[k] / theirs->speed[k]);
  return spread_of(ratios);
}

double BedRow::energy_difference() const {
  return std::abs(ours->last.kinetic_energy - theirs->last.kinetic_energy) / theirs->last.kinetic_energy;
}

BedRow compare_bed(const Bed& bed, std::optional<Lammps>& lammps, const BedProtocol& protocol,
                   const std::filesystem::path& folder) {
  BedRow row;
  row.bed = bed.name;
  row.count = bed.scene.bodies.size();
  row.fraction = volume_fraction(bed.scene);
  if (protocol.runs_ours) row.ours.emplace();
  if (lammps) {
    row.theirs.emplace();
    lammps->prepare(folder, bed, protocol.lammps, protocol.stretch);
  }
  for (int turn = 0; turn < protocol.repeat; ++turn) {
    const int64_t steps = protocol.stretch.steps;
    if (row.ours) add_turn(*row.ours, run_ours(bed, protocol.settings, protocol.stretch), row.count, steps);
    if (row.theirs) add_turn(*row.theirs, lammps->run(folder), row.count, steps);
  }
  return row;
}

}  // namespace ballpit
