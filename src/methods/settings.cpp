// SPDX-License-Identifier: MIT
#include "methods/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "core/error.h"
#include "methods/methods.h"

namespace ballpit {

namespace {

constexpr double kSmallestStep = 1e-12;

template <class T>
bool parse(std::string_view text, T& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

/// As short as it can be typed: 0.004166666666666667, 1e6.
template <class T>
std::string typed(T value) {
  std::array<char, 32> text;
  std::string result(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
  if (const size_t plus = result.find("e+"); plus != result.npos) {
    result.erase(plus + 1, result.compare(plus + 2, 1, "0") == 0 ? 2 : 1);
  }
  return result;
}
template <class T>
std::string typed(const std::optional<T>& value) {
  return value ? typed(*value) : "";
}

/// A number in [low, high], stored in `member`.
template <auto member, auto low, auto high>
constexpr SettingInfo number(std::string_view name, std::string_view value_name, std::string_view help,
                             SettingGroup group) {
  return {name,
          value_name,
          help,
          group,
          [] { return typed(low) + " to " + typed(high); },
          {},
          [](Settings& settings, std::string_view text) {
            decltype(low) value{};
            if (!parse(text, value) || !(value >= low && value <= high)) return false;
            settings.*member = value;
            return true;
          },
          [](const Settings& settings) { return typed(settings.*member); }};
}

template <class Enum>
Enum type_of_member(Enum Settings::*);

/// One of an enum's names, its value stored in `member`.
template <auto member>
constexpr SettingInfo choice(std::string_view name, std::string_view help, SettingGroup group) {
  using Enum = decltype(type_of_member(member));
  return {name,
          "NAME",
          help,
          group,
          [] { return join(kNames<Enum>); },
          kNames<Enum>,
          [](Settings& settings, std::string_view text) {
            const std::optional<Enum> value = find_named<Enum>(text);
            if (value) settings.*member = *value;
            return value.has_value();
          },
          [](const Settings& settings) { return std::string(name_of(settings.*member)); }};
}

constexpr std::array<std::string_view, 2> kOnOff{"on", "off"};

constexpr SettingInfo kSwept{"swept",
                             "on|off",
                             "contacts are found along the step, so that fast spheres meet what they would pass",
                             SettingGroup::response,
                             [] { return join(kOnOff); },
                             kOnOff,
                             [](Settings& settings, std::string_view text) {
                               if (text != "on" && text != "off") return false;
                               settings.is_swept = text == "on";
                               return true;
                             },
                             [](const Settings& settings) { return std::string(settings.is_swept ? "on" : "off"); }};

constexpr auto kDetection = SettingGroup::detection, kResponse = SettingGroup::response, kTime = SettingGroup::time,
               kRun = SettingGroup::run;

constexpr std::array kTable{
    choice<&Settings::broadphase>("broadphase", "how candidate pairs are found", kDetection),
    number<&Settings::cell_size, 0.05, 1000.0>(
        "cell-size", "FACTOR", "edge of a grid cell in units of 2·r_max; below 1 contacts are missed", kDetection),
    choice<&Settings::table>(
        "table", "cells in an array with a place for each, or hashed into a bounded number of places", kDetection),
    choice<&Settings::axis>("axis", "axis of sort-and-sweep; auto: the one along which positions vary most",
                            kDetection),
    number<&Settings::skin, 0.0, 10.0>("skin", "FRACTION",
                                       "skin of the candidate list, of a radius; 0: search in every step", kDetection),
    choice<&Settings::response>("response", "what spheres in contact do", kResponse),
    number<&Settings::iterations, 1, 10000>(
        "iterations", "N", "of impulse (4 unless told) and position-based (1) in a substep", kResponse),
    choice<&Settings::solver>("solver", "how impulse iterates", kResponse),
    choice<&Settings::correction>(
        "correction", "of overlap by impulse: split into velocity and position, none, or back to the surface",
        kResponse),
    choice<&Settings::contact_end>("contact-end",
                                   "of penalty: where overlap ends, or where the force would begin to pull", kResponse),
    number<&Settings::compliance, 0.0, 1000.0>("compliance", "M/N", "of position-based contacts; 0: rigid", kResponse),
    number<&Settings::contact_duration, 0.0, 1.0>("contact-duration", "SECONDS",
                                                  "of event-driven collisions: those that follow sooner lose no energy",
                                                  kResponse),
    kSwept,
    choice<&Settings::integrator>("integrator", "how velocities and positions advance", kTime),
    choice<&Settings::precision>("precision", "floating-point type of the simulation", kTime),
    number<&Settings::dt, kSmallestStep, 10.0>("dt", "SECONDS", "time step", kTime),
    number<&Settings::substeps, 1, 1000>("substeps", "N", "parts of a time step, each detected and resolved by itself",
                                         kTime),
    number<&Settings::max_overlap, 0.0, 1e6>("max-overlap", "FRACTION",
                                             "of the smaller radius; more overlap stops the run", kRun),
    number<&Settings::max_energy, 1.0, 1e15>("max-energy", "FACTOR",
                                             "of the energy at the start; more energy stops the run", kRun),
    choice<&Settings::backend>("backend", "processor that simulates", kDetection),
    number<&Settings::threads, 0, 256>("threads", "N", "CPU threads; 0 for all cores", kDetection),
    number<&Settings::count, int64_t{1}, int64_t{100000000}>(
        "count", "N", "spheres to generate, in place of the scene's own number", kRun),
    number<&Settings::seed, uint64_t{0}, UINT64_MAX>("seed", "N", "start of the random numbers", kRun),
};

}  // namespace

double skin_of(const Settings& settings) {
  return settings.skin.value_or(settings.broadphase == BroadPhase::automatic ? 0.1 : 0.0);
}

Integrator integrator_of(const Settings& settings) {
  if (settings.integrator != Integrator::automatic) return settings.integrator;
  const std::string_view names = find_method(settings.response).integrators;
  return named<Integrator>(names.substr(0, names.find(',')));
}

Precision precision_of(const Settings& settings) {
  const std::string_view precisions = find_method(settings.response).precisions;
  return precisions.find(name_of(settings.precision)) == precisions.npos ? named<Precision>(precisions)
                                                                         : settings.precision;
}

std::span<const SettingInfo> setting_table() { return kTable; }

void apply_setting(Settings& settings, std::string_view name, std::string_view value, std::string_view where) {
  const auto info =
      std::find_if(kTable.begin(), kTable.end(), [&](const SettingInfo& entry) { return entry.name == name; });
  if (info == kTable.end()) {
    std::vector<std::string_view> names;
    for (const SettingInfo& entry : kTable) names.push_back(entry.name);
    throw UserError(where, "no option of this name", join(names));
  }
  if (!info->set(settings, value)) {
    throw UserError(where, value, info->allowed());
  }
}

}  // namespace ballpit
