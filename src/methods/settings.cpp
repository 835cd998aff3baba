// SPDX-License-Identifier: MIT
#include "methods/settings.h"

#include <algorithm>
#include <array>
#include <charconv>

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
          nullptr,
          [](Settings& settings, std::string_view text) {
            decltype(low) value{};
            if (!parse(text, value) || !(value >= low && value <= high)) return false;
            settings.*member = value;
            return true;
          },
          [](const Settings& settings) { return typed(settings.*member); }};
}

/// One of the names that `names` lists, stored in `member`.
template <std::string Settings::*member, auto names>
constexpr SettingInfo name_of(std::string_view name, std::string_view help, SettingGroup group) {
  return {name,
          "NAME",
          help,
          group,
          [] { return join(names()); },
          +names,
          [](Settings& settings, std::string_view text) {
            const std::vector<std::string_view> allowed = names();
            if (std::find(allowed.begin(), allowed.end(), text) == allowed.end()) return false;
            settings.*member = text;
            return true;
          },
          [](const Settings& settings) { return settings.*member; }};
}

template <Family family>
std::vector<std::string_view> names_in() {
  return method_names(family);
}
std::vector<std::string_view> table_names() { return {"auto", "dense", "hashed"}; }
std::vector<std::string_view> axis_names() { return {"auto", "x", "y", "z"}; }
std::vector<std::string_view> correction_names() { return {"split", "none", "surface"}; }
std::vector<std::string_view> contact_end_names() { return {"overlap", "force"}; }
std::vector<std::string_view> on_off() { return {"on", "off"}; }

constexpr SettingInfo kSwept{"swept",
                             "on|off",
                             "contacts are found along the step, so that fast spheres meet what they would pass",
                             SettingGroup::response,
                             [] { return join(on_off()); },
                             on_off,
                             [](Settings& settings, std::string_view text) {
                               if (text != "on" && text != "off") return false;
                               settings.is_swept = text == "on";
                               return true;
                             },
                             [](const Settings& settings) { return std::string(settings.is_swept ? "on" : "off"); }};

constexpr auto kDetection = SettingGroup::detection, kResponse = SettingGroup::response, kTime = SettingGroup::time,
               kRun = SettingGroup::run;

constexpr std::array kTable{
    name_of<&Settings::broadphase, names_in<Family::broadphase>>("broadphase", "how candidate pairs are found",
                                                                 kDetection),
    number<&Settings::cell_size, 0.05, 1000.0>(
        "cell-size", "FACTOR", "edge of a grid cell in units of 2·r_max; below 1 contacts are missed", kDetection),
    name_of<&Settings::table, table_names>(
        "table", "cells in an array with a place for each, or hashed into a bounded number of places", kDetection),
    name_of<&Settings::axis, axis_names>(
        "axis", "axis of sort-and-sweep; auto: the one along which positions vary most", kDetection),
    number<&Settings::skin, 0.0, 10.0>("skin", "FRACTION",
                                       "skin of the candidate list, of a radius; 0: search in every step", kDetection),
    name_of<&Settings::response, names_in<Family::response>>("response", "what spheres in contact do", kResponse),
    number<&Settings::iterations, 1, 10000>(
        "iterations", "N", "of impulse (4 unless told) and position-based (1) in a substep", kResponse),
    name_of<&Settings::solver, names_in<Family::solver>>("solver", "how impulse iterates", kResponse),
    name_of<&Settings::correction, correction_names>(
        "correction", "of overlap by impulse: split into velocity and position, none, or back to the surface",
        kResponse),
    name_of<&Settings::contact_end, contact_end_names>(
        "contact-end", "of penalty: where overlap ends, or where the force would begin to pull", kResponse),
    number<&Settings::compliance, 0.0, 1000.0>("compliance", "M/N", "of position-based contacts; 0: rigid", kResponse),
    number<&Settings::contact_duration, 0.0, 1.0>("contact-duration", "SECONDS",
                                                  "of event-driven collisions: those that follow sooner lose no energy",
                                                  kResponse),
    kSwept,
    name_of<&Settings::integrator, names_in<Family::integrator>>("integrator", "how velocities and positions advance",
                                                                 kTime),
    name_of<&Settings::precision, names_in<Family::precision>>("precision", "floating-point type of the simulation",
                                                               kTime),
    number<&Settings::dt, kSmallestStep, 10.0>("dt", "SECONDS", "time step", kTime),
    number<&Settings::substeps, 1, 1000>("substeps", "N", "parts of a time step, each detected and resolved by itself",
                                         kTime),
    number<&Settings::max_overlap, 0.0, 1e6>("max-overlap", "FRACTION",
                                             "of the smaller radius; more overlap stops the run", kRun),
    number<&Settings::max_energy, 1.0, 1e15>("max-energy", "FACTOR",
                                             "of the energy at the start; more energy stops the run", kRun),
    name_of<&Settings::backend, names_in<Family::backend>>("backend", "processor that simulates", kDetection),
    number<&Settings::threads, 0, 256>("threads", "N", "CPU threads; 0 for all cores", kDetection),
    number<&Settings::count, int64_t{1}, int64_t{100000000}>(
        "count", "N", "spheres to generate, in place of the scene's own number", kRun),
    number<&Settings::seed, uint64_t{0}, UINT64_MAX>("seed", "N", "start of the random numbers", kRun),
};

}  // namespace

double skin_of(const Settings& settings) { return settings.skin.value_or(settings.broadphase == "auto" ? 0.1 : 0.0); }

std::string integrator_of(const Settings& settings) {
  if (settings.integrator != "auto") return settings.integrator;
  const std::string_view names = find_method(Family::response, settings.response).integrators;
  return std::string(names.substr(0, names.find(',')));
}

std::string precision_of(const Settings& settings) {
  const std::string_view precisions = find_method(Family::response, settings.response).precisions;
  return precisions.find(settings.precision) == precisions.npos ? std::string(precisions) : settings.precision;
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
