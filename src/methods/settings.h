// SPDX-License-Identifier: MIT
// The shared options: how a scene is simulated. One table feeds command line, [defaults] of scene files, help and panel.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "methods/choices.h"

namespace ballpit {

struct Settings {
  BroadPhase broadphase = BroadPhase::linked_cell;
  std::optional<double> cell_size;  ///< in units of 2·r_max; empty: the method chooses, at least 1
  CellTable table = CellTable::automatic;
  SweepAxis axis = SweepAxis::automatic;
  std::optional<double> skin;  ///< of the candidate list, as a fraction of a radius; empty: see skin_of()
  Response response = Response::impulse;
  std::optional<int> iterations;  ///< of impulse and position-based in a substep; empty: the response's own number
  Solver solver = Solver::jacobi;
  Correction correction = Correction::split;
  ContactEnd contact_end = ContactEnd::overlap;
  double compliance = 0;           ///< [m/N] of position-based contacts; 0: rigid
  double contact_duration = 1e-6;  ///< [s] of event-driven collisions: those that follow sooner lose no energy
  bool is_swept = false;           ///< contacts are found along the step
  Integrator integrator = Integrator::automatic;
  Precision precision = Precision::float32;
  BackendName backend = BackendName::automatic;
  double dt = 1.0 / 240;         ///< [s]
  int substeps = 1;              ///< parts of dt, each detected and responded to by itself
  int threads = 0;               ///< 0: all cores
  std::optional<int64_t> count;  ///< spheres generated, in place of the scene's own number
  std::optional<uint64_t> seed;
  double max_overlap = 1;    ///< of the smaller radius; more stops the run
  double max_energy = 10;    ///< of the energy at the start; more stops the run
  bool keeps_tally = false;  ///< whether Report::tally is wanted; no option, follows from what is to be observed
};

/// The candidate list's skin: what was asked for; else a tenth where the program chooses the broad phase, and none where
/// one was named, which is then to be seen at work in every step.
double skin_of(const Settings& settings);

/// Whether the broad phase may miss contacts, and motion depend on it.
inline bool can_miss_contacts(const Settings& settings) { return settings.cell_size && *settings.cell_size < 1; }

/// The integrator, also where settings leave it to the response.
Integrator integrator_of(const Settings& settings);

/// float64 where the response computes in nothing else, whatever the settings say.
Precision precision_of(const Settings& settings);

/// Where the panel shows an option; `run` options are the command line's alone.
enum class SettingGroup { detection, response, time, run };

/// One shared option: "--name VALUE" on the command line, "name = value" in [defaults].
struct SettingInfo {
  std::string_view name;
  std::string_view value_name;  ///< for help: NAME, SECONDS, …
  std::string_view help;
  SettingGroup group;
  std::string (*allowed)();                   ///< for help and errors: "brute-force, linked-cell", "0 to 10"
  std::span<const std::string_view> choices;  ///< of an option with names; empty for numbers
  bool (*set)(Settings&, std::string_view);   ///< stores a value; false where it is not allowed
  std::string (*get)(const Settings&);        ///< as it would be typed; empty where it is left to the program
};

std::span<const SettingInfo> setting_table();

/// Applies one option. `where` names its place: "--dt", or "file.toml:12: [defaults] dt". Throws UserError for an unknown
/// name or a value that is not allowed.
void apply_setting(Settings& settings, std::string_view name, std::string_view value, std::string_view where);

}  // namespace ballpit
