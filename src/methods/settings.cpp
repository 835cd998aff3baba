// SPDX-License-Identifier: MIT
#include "methods/settings.h"

#include <algorithm>
#include <type_traits>

#include "methods/methods.h"
#include "methods/number_range.h"

namespace ballpit {

namespace {

/// What the table says of a setting in words. Without a preset, the default is the value in Settings{}.
struct Words {
  std::string_view name, value_name, help, preset = "";
};

/// `read` turns a text into a value, or none if it is not allowed; `write` turns a value into its text.
template <class Member, class Read, class Write>
SettingInfo setting(SettingGroup group, const Words& words, const std::string& allowed, Member Settings::*member,
                    Read read, Write write) {
  const auto get = [=](const Settings& settings) { return std::string(write(settings.*member)); };
  return {.name = words.name,
          .value_name = words.value_name,
          .help = words.help,
          .group = group,
          .allowed = allowed,
          .preset = words.preset.empty() ? get(Settings{}) : std::string(words.preset),
          .set =
              [=](Settings& settings, std::string_view text) {
                const auto value = read(text);
                if (value) settings.*member = *value;
                return value.has_value();
              },
          .get = get};
}

/// A number in a range.
template <class Member, class T>
SettingInfo number(SettingGroup group, const Words& words, Member Settings::*member, const Range<T>& range,
                   const std::optional<SettingSlider>& slider = {}) {
  SettingInfo info = setting(
      group, words, text_of(range), member, [=](std::string_view text) { return number_in(range, text); },
      [](const Member& value) { return typed(value); });
  info.slider = slider;
  info.in_use = [=](const Settings& settings) {
    if constexpr (std::is_arithmetic_v<Member>)
      return static_cast<double>(settings.*member);
    else
      return settings.*member ? static_cast<double>(*(settings.*member)) : slider->fallback(settings);
  };
  return info;
}

/// One of the names of an enum.
template <class Enum>
SettingInfo choice(SettingGroup group, const Words& words, Enum Settings::*member) {
  SettingInfo info = setting(group, words, join(kNames<Enum>), member, find_named<Enum>, name_of<Enum>);
  info.choices = kNames<Enum>;
  return info;
}

SettingInfo toggle(SettingGroup group, const Words& words, bool Settings::*member) {
  static constexpr std::array<std::string_view, 2> kOnOff{"on", "off"};
  const auto read = [](std::string_view text) {
    return text == "on" || text == "off" ? std::optional(text == "on") : std::nullopt;
  };
  SettingInfo info = setting(group, words, join(kOnOff), member, read, [](bool is_on) { return is_on ? "on" : "off"; });
  info.choices = kOnOff;
  return info;
}

}  // namespace

double skin_of(const Settings& settings) {
  return settings.skin.value_or(settings.broadphase == BroadPhase::automatic ? 0.1 : 0.0);
}

int iterations_of(const Settings& settings) {
  return settings.iterations.value_or(settings.response == Response::impulse ? 4 : 1);
}

Integrator integrator_of(const Settings& settings) {
  if (settings.integrator != Integrator::automatic) return settings.integrator;
  const std::string_view names = find_method(settings.response).integrators;
  return named<Integrator>(names.substr(0, names.find(',')));
}

Precision precision_of(const Settings& settings) {
  const bool is_double_only = find_method(settings.response).precisions == name_of(Precision::float64);
  return is_double_only ? Precision::float64 : settings.precision;
}

const std::vector<SettingInfo>& setting_table() {
  constexpr auto kDetection = SettingGroup::detection, kResponse = SettingGroup::response, kTime = SettingGroup::time,
                 kRun = SettingGroup::run;
  static const std::vector<SettingInfo> table{
      choice(kDetection, {"broadphase", "NAME", "how candidate pairs are found"}, &Settings::broadphase),
      number(kDetection,
             {"cell-size", "FACTOR", "edge of a grid cell in units of 2·r_max; below 1 contacts are missed",
              "at least 1, by the method"},
             &Settings::cell_size, Range{0.05, 1000.0},
             SettingSlider{0.25f, 8, true, false, [](const Settings&) { return 1.0; }, {0.5f, 1, 2, 4, 8}}),
      choice(kDetection,
             {"table", "NAME", "one bucket for each cell, or a bounded number of buckets shared by hashing"},
             &Settings::table),
      choice(kDetection, {"axis", "NAME", "axis of sort-and-sweep; auto takes the one along which positions vary most"},
             &Settings::axis),
      number(kDetection,
             {"skin", "FRACTION", "skin of the candidate list, as a fraction of a radius; 0 searches in every step",
              "0.1 with auto, else 0"},
             &Settings::skin, Range{0.0, 10.0}, SettingSlider{0, 1, false, false, skin_of, {0, 0.1f}}),
      choice(kResponse, {"response", "NAME", "what happens to spheres in contact"}, &Settings::response),
      number(
          kResponse, {"iterations", "N", "iterations in a substep", "impulse 4, position-based 1"},
          &Settings::iterations, Range{1, 10000},
          SettingSlider{1, 64, true, true, [](const Settings& settings) { return double(iterations_of(settings)); }}),
      choice(kResponse, {"solver", "NAME", "impulse: how it iterates"}, &Settings::solver),
      choice(
          kResponse,
          {"correction", "NAME",
           "impulse: how overlap is corrected: split into velocity and position, not at all, or back to the surface"},
          &Settings::correction),
      choice(kResponse,
             {"contact-end", "NAME",
              "penalty: a contact ends where the overlap ends, or where the force would begin to pull"},
             &Settings::contact_end),
      number(kResponse, {"compliance", "M/N", "position-based: compliance of contacts; 0 is rigid"},
             &Settings::compliance, Range{0.0, 1000.0}, SettingSlider{0, 1e-3f}),
      number(kResponse,
             {"contact-duration", "SECONDS", "event-driven: collisions that follow sooner lose no energy", "1e-6"},
             &Settings::contact_duration, Range{0.0, 1.0}),
      toggle(kResponse,
             {"swept", "on|off", "find contacts along the step, so that fast spheres do not pass through others"},
             &Settings::is_swept),
      choice(kTime,
             {"integrator", "NAME", "how velocities and positions advance; only penalty offers a choice",
              "the response's: penalty velocity-verlet, event-driven exact, others symplectic-euler"},
             &Settings::integrator),
      choice(kTime, {"precision", "NAME", "floating-point type of the simulation", "float; event-driven double"},
             &Settings::precision),
      number(kTime, {"dt", "SECONDS", "time step", "1/240"}, &Settings::dt, Range{1e-12, 10.0},
             SettingSlider{
                 1e-4f, 1.0f / 30, true, false, nullptr, {1e-3f, 1 / 480.0f, 1 / 240.0f, 1 / 120.0f, 1 / 60.0f}}),
      number(kTime, {"substeps", "N", "equal parts of a time step, each with its own detection and response"},
             &Settings::substeps, Range{1, 1000}, SettingSlider{1, 32, true, true}),
      number(kRun, {"max-overlap", "FRACTION", "fraction of the smaller radius; more overlap stops the run"},
             &Settings::max_overlap, Range{0.0, 1e6}),
      number(kRun, {"max-energy", "FACTOR", "factor of the energy at the start; more energy stops the run"},
             &Settings::max_energy, Range{1.0, 1e15}),
      choice(kDetection, {"backend", "NAME", "processor that simulates; auto takes CUDA if there is a device"},
             &Settings::backend),
      number(kDetection, {"threads", "N", "CPU threads; 0 for all cores"}, &Settings::threads, Range{0, 256},
             SettingSlider{0, 16, false, true}),
      number(kRun, {"count", "N", "number of spheres to generate", "the scene's"}, &Settings::count,
             Range{int64_t{1}, int64_t{100'000'000}}),
      number(kRun, {"seed", "N", "start of the random numbers", "1"}, &Settings::seed, Range{uint64_t{0}, UINT64_MAX}),
      number(kRun,
             {"mass-ratio", "RATIO", "mass of the heavy spheres in units of the light ones', in a scene of two masses",
              "the scene's"},
             &Settings::mass_ratio, Range{1.0, 1e12}),
  };
  return table;
}

void apply_setting(Settings& settings, std::string_view name, std::string_view value, std::string_view where) {
  const std::vector<SettingInfo>& table = setting_table();
  const auto info = std::ranges::find(table, name, &SettingInfo::name);
  if (info == table.end()) throw UserError(where, "no option of this name", join(names_in(table)));
  if (!info->set(settings, value)) throw UserError(where, value, info->allowed);
}

}  // namespace ballpit
