// SPDX-License-Identifier: MIT
#include "simulate/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/error.h"
#include "simulate/methods.h"

namespace ballpit {

namespace {

template <class T>
bool parse(std::string_view text, T& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

/// Parses a number and stores it where it lies in [low, high].
template <class T, class Member>
bool set_number(std::string_view text, T low, T high, Member& member) {
  T value{};
  if (!parse(text, value) || !(value >= low && value <= high)) return false;
  member = value;
  return true;
}

bool set_one_of(std::string_view text, std::initializer_list<std::string_view> names, std::string& member) {
  if (std::find(names.begin(), names.end(), text) == names.end()) return false;
  member = text;
  return true;
}

template <Family family>
std::string allowed_methods() {
  return join(method_names(family));
}

template <Family family, std::string Settings::*member>
bool set_method(Settings& settings, std::string_view text) {
  const auto names = method_names(family);
  if (std::find(names.begin(), names.end(), text) == names.end()) return false;
  settings.*member = text;
  return true;
}

constexpr double kSmallest = 1e-12;

constexpr std::array kTable{
    SettingInfo{"broadphase", "NAME", "how candidate pairs are found", allowed_methods<Family::broadphase>,
                set_method<Family::broadphase, &Settings::broadphase>},
    SettingInfo{"cell-size", "FACTOR", "edge of a grid cell in units of 2·r_max; below 1 contacts are missed",
                [] { return std::string("0.05 to 1000"); },
                [](Settings& s, std::string_view v) { return set_number(v, 0.05, 1000.0, s.cell_size); }},
    SettingInfo{"table", "NAME", "cells in an array with a place for each, or hashed into a bounded number of places",
                [] { return std::string("auto, dense, hashed"); },
                [](Settings& s, std::string_view v) {
                  return set_one_of(v, {"auto", "dense", "hashed"}, s.table);
                }},
    SettingInfo{"axis", "NAME", "axis of sort-and-sweep; auto: the one along which positions vary most",
                [] { return std::string("auto, x, y, z"); },
                [](Settings& s, std::string_view v) {
                  return set_one_of(v, {"auto", "x", "y", "z"}, s.axis);
                }},
    SettingInfo{"skin", "FRACTION", "skin of the candidate list, of a radius; 0: search in every step",
                [] { return std::string("0 to 10"); },
                [](Settings& s, std::string_view v) { return set_number(v, 0.0, 10.0, s.skin); }},
    SettingInfo{"response", "NAME", "what spheres in contact do", allowed_methods<Family::response>,
                set_method<Family::response, &Settings::response>},
    SettingInfo{"iterations", "N", "of impulse (4 unless told) and position-based (1) in a substep",
                [] { return std::string("1 to 10000"); },
                [](Settings& s, std::string_view v) { return set_number(v, 1, 10000, s.iterations); }},
    SettingInfo{"solver", "NAME", "how impulse iterates", allowed_methods<Family::solver>,
                set_method<Family::solver, &Settings::solver>},
    SettingInfo{"correction", "NAME",
                "of overlap by impulse: split into velocity and position, none, or back to the surface",
                [] { return std::string("split, none, surface"); },
                [](Settings& s, std::string_view v) {
                  return set_one_of(v, {"split", "none", "surface"}, s.correction);
                }},
    SettingInfo{"contact-end", "NAME", "of penalty: where overlap ends, or where the force would begin to pull",
                [] { return std::string("overlap, force"); },
                [](Settings& s, std::string_view v) {
                  return set_one_of(v, {"overlap", "force"}, s.contact_end);
                }},
    SettingInfo{"compliance", "M/N", "of position-based contacts; 0: rigid", [] { return std::string("0 to 1000"); },
                [](Settings& s, std::string_view v) { return set_number(v, 0.0, 1000.0, s.compliance); }},
    SettingInfo{"contact-duration", "SECONDS", "of event-driven collisions: those that follow sooner lose no energy",
                [] { return std::string("0 to 1"); },
                [](Settings& s, std::string_view v) { return set_number(v, 0.0, 1.0, s.contact_duration); }},
    SettingInfo{"swept", "on|off", "contacts are found along the step, so that fast spheres meet what they would pass",
                [] { return std::string("on, off"); },
                [](Settings& s, std::string_view v) {
                  if (v != "on" && v != "off") return false;
                  s.is_swept = v == "on";
                  return true;
                }},
    SettingInfo{"integrator", "NAME", "how velocities and positions advance", allowed_methods<Family::integrator>,
                set_method<Family::integrator, &Settings::integrator>},
    SettingInfo{"precision", "NAME", "floating-point type of the simulation", allowed_methods<Family::precision>,
                set_method<Family::precision, &Settings::precision>},
    SettingInfo{"dt", "SECONDS", "time step", [] { return std::string("1e-12 to 10"); },
                [](Settings& s, std::string_view v) { return set_number(v, kSmallest, 10.0, s.dt); }},
    SettingInfo{"substeps", "N", "parts of a time step, each detected and resolved by itself",
                [] { return std::string("1 to 1000"); },
                [](Settings& s, std::string_view v) { return set_number(v, 1, 1000, s.substeps); }},
    SettingInfo{"max-overlap", "FRACTION", "of the smaller radius; more overlap stops the run",
                [] { return std::string("0 to 1e6"); },
                [](Settings& s, std::string_view v) { return set_number(v, 0.0, 1e6, s.max_overlap); }},
    SettingInfo{"max-energy", "FACTOR", "of the energy at the start; more energy stops the run",
                [] { return std::string("1 to 1e15"); },
                [](Settings& s, std::string_view v) { return set_number(v, 1.0, 1e15, s.max_energy); }},
    SettingInfo{"backend", "NAME", "processor that simulates", allowed_methods<Family::backend>,
                set_method<Family::backend, &Settings::backend>},
    SettingInfo{"threads", "N", "CPU threads; 0 for all cores", [] { return std::string("0 to 256"); },
                [](Settings& s, std::string_view v) { return set_number(v, 0, 256, s.threads); }},
    SettingInfo{"count", "N", "spheres to generate, in place of the scene's own number",
                [] { return std::string("1 to 100000000"); },
                [](Settings& s, std::string_view v) { return set_number(v, int64_t{1}, int64_t{100000000}, s.count); }},
    SettingInfo{"seed", "N", "start of the random numbers", [] { return std::string("0 to 18446744073709551615"); },
                [](Settings& s, std::string_view v) { return set_number(v, uint64_t{0}, UINT64_MAX, s.seed); }},
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
    throw UserError(std::string(where) + ": found no option of this name, allowed " + join(names));
  }
  if (!info->set(settings, value)) {
    throw UserError(std::string(where) + ": found " + std::string(value) + ", allowed " + info->allowed());
  }
}

}  // namespace ballpit
