// SPDX-License-Identifier: MIT
// The settings: how a scene is simulated. One table of them feeds the command line, its help, the [defaults] of scene
// files and the panel. A test compares the README with it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "methods/choices.h"

namespace ballpit {

/// What the parts of a search cost on one core [ns], by which --broadphase auto decides. The presets are those of an AMD
/// EPYC core in single precision; measure/search_costs.h measures them here.
struct SearchCosts {
  double vector_test = 0.35;  ///< a test in a long range
  double sweep_test = 0.35;   ///< a test of sort and sweep
  double short_test = 2.0;    ///< a test in a range of a few slots
  double list_test = 4.0;     ///< a test in a linked list
  double sort = 60.0;         ///< of sort and sweep, for each body: two endpoints sorted and numbered, and its range
  double bin = 35.0;          ///< a body sorted by cell, gathered, and its ranges looked up
  double link = 90.0;         ///< a body linked, and the cells around it looked up
  double each = 10.0;         ///< of brute force, for each body
};

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
  int substeps = 1;              ///< equal parts of dt, each with its own detection and response
  int threads = 0;               ///< 0: all cores
  std::optional<int64_t> count;  ///< spheres generated, in place of the scene's own number
  std::optional<uint64_t> seed;
  std::optional<double> mass_ratio;  ///< of heavy and light listed spheres, in place of the scene's own
  double max_overlap = 1;            ///< of the smaller radius; more stops the run
  double max_energy = 10;            ///< of the energy at the start; more stops the run

  // No options:
  bool keeps_tally = false;  ///< fill Report::tally; set if observables need it
  SearchCosts costs{};       ///< measured where --broadphase auto decides
  double patience = 1e300;   ///< [s] of computing that a step of event-driven motion may take; more stops the run
};

/// An option as given: "dt", "0.01".
struct GivenOption {
  std::string name;
  std::string value;
};

/// The skin of the candidate list. If none is set: a tenth if the program chooses the broad phase, else 0.
double skin_of(const Settings& settings);

/// Iterations of impulse or position-based in a substep.
int iterations_of(const Settings& settings);

/// Whether the broad phase may miss contacts, so that the motion depends on it.
inline bool can_miss_contacts(const Settings& settings) { return settings.cell_size && *settings.cell_size < 1; }

/// The integrator that is used: the response's own if none is set.
Integrator integrator_of(const Settings& settings);

/// The precision that is used: float64 if the response has no other.
Precision precision_of(const Settings& settings);

/// Where the panel shows a setting; `run` settings are on the command line only.
enum class SettingGroup { detection, response, time, run };

/// The part of a number's range that the panel's slider covers; other values can be typed.
struct SettingSlider {
  float low, high;
  bool is_log = false, is_integer = false;
  double (*fallback)(const Settings&) = nullptr;  ///< the value that the program takes if none is set
  std::vector<float> snaps{};                     ///< values at which it stops
};

/// One setting: "--name VALUE" on the command line, "name = value" in [defaults].
struct SettingInfo {
  std::string_view name;
  std::string_view value_name;  ///< for help: NAME, SECONDS, …
  std::string_view help;
  SettingGroup group;
  std::string allowed{};                        ///< "brute-force, linked-cell", "0 to 10"
  std::string preset{};                         ///< the program's default: "linked-cell", "1/240", "the scene's"
  std::span<const std::string_view> choices{};  ///< of a setting with names; empty for numbers
  std::optional<SettingSlider> slider{};
  std::function<bool(Settings&, std::string_view)> set{};  ///< stores a value; false if it is not allowed
  std::function<double(const Settings&)> in_use{};         ///< of a setting with a slider: the value in use
  std::function<std::string(const Settings&)> get{};       ///< as typed; empty if none is set
};

const std::vector<SettingInfo>& setting_table();

/// Sets the setting `name`. `where` is the place of the value: "--dt", or "file.toml:12: [defaults] dt". Throws
/// UserError if there is no such setting, or if the value is not allowed.
void apply_setting(Settings& settings, std::string_view name, std::string_view value, std::string_view where);

}  // namespace ballpit
