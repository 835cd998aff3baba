// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <time.h>

#include "world/world.h"

namespace ballpit {

namespace {

double now_in_seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// As LAMMPS does: `warmup` steps before the clocks start, and the report after they stop.
Measured run_ours(const Bed& bed, const Settings& settings, const Stretch& stretch) {
  const std::unique_ptr<World> world = cpu_backend().make_world(bed.scene, settings);
  for (int64_t k = 0; k < stretch.warmup; ++k) world->step();
  const double wall = now_in_seconds(CLOCK_MONOTONIC), cpu = now_in_seconds(CLOCK_PROCESS_CPUTIME_ID);
  for (int64_t k = 0; k < stretch.steps; ++k) world->step();
  Measured measured;
  measured.seconds = now_in_seconds(CLOCK_MONOTONIC) - wall;
  measured.cpu_seconds = now_in_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  const Report report = world->report();
  measured.kinetic_energy = report.kinetic_energy;
  measured.contacts = report.contacts;
  measured.searches = report.searches;
  return measured;
}

/// Adds the speed of a turn, by the chosen clock.
void add_turn(Turns& turns, const Measured& measured, int64_t count, const BedProtocol& protocol) {
  const double seconds = protocol.clock == BedClock::wall ? measured.seconds : measured.cpu_seconds;
  turns.speed.push_back(1e-6 * static_cast<double>(count) * static_cast<double>(protocol.stretch.steps) / seconds);
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
    if (row.ours) add_turn(*row.ours, run_ours(bed, protocol.settings, protocol.stretch), row.count, protocol);
    if (row.theirs) add_turn(*row.theirs, lammps->run(folder), row.count, protocol);
  }
  return row;
}

}  // namespace ballpit
