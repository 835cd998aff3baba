// SPDX-License-Identifier: MIT
#include "cli/observe.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "measure/exact_pairs.h"
#include "show/parse.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

/// Another method's contacts of the present state, in the same precision, so that rounding cannot tell the two apart. With
/// cells or an axis of its own choice a method misses none; it is another one, so that no mistake is made twice.
std::vector<Pair> contacts_by_other_method(Session& session) {
  Settings settings;
  settings.broadphase = session.world().report().broadphase == name_of(BroadPhase::sorted_grid)
                            ? BroadPhase::sort_and_sweep
                            : BroadPhase::sorted_grid;
  settings.precision = precision_of(session.settings());
  settings.threads = session.settings().threads;
  Scene scene;
  scene.domain = session.scene().domain;
  scene.bodies = session.world().bodies();
  return cpu_backend().make_world(scene, settings)->inspect().contacts;
}

Observation observation_of(Session& session) {
  World& world = session.world();
  return {session.scene().domain, world.bodies(), world.report(),
          [&] { return deviation_of(world.inspect().contacts, contacts_by_other_method(session)).missed; }};
}

Json json_of(const ObservedValue& value) {
  if (value.empty()) return nullptr;
  return value.size() == 1 ? Json(value[0]) : Json(value);
}

std::string text_of(const Json& entry) {
  const Json& value = entry["value"];
  if (value.is_null()) return "-";
  std::ostringstream text;
  const char* separator = "";
  for (const Json& number : value.is_array() ? value : Json::array({value})) {
    text << separator << number.get<double>();
    separator = ", ";
  }
  const std::string unit = entry["unit"];
  if (unit != "1") text << " " << unit;
  return text.str();
}

}  // namespace

std::vector<std::string> observable_names() {
  std::vector<std::string> names;
  for (const Observable& observable : observables()) names.emplace_back(observable.name);
  return names;
}

std::vector<Observable> parse_observables(const std::string& text) {
  if (text == "all") return {observables().begin(), observables().end()};
  std::vector<Observable> result;
  for (const std::string& name : split_list(text)) {
    const auto found =
        std::find_if(observables().begin(), observables().end(), [&](const Observable& o) { return o.name == name; });
    if (found == observables().end()) {
      throw UserError("--observe", name, "all alone, or some of " + join(observable_names()) + ", with commas between");
    }
    result.push_back(*found);
  }
  return result;
}

bool need_tally(std::span<const Observable> wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [](const Observable& o) { return o.needs_tally; });
}

Json observe(Session& session, std::span<const Observable> wanted) {
  const Observation observation = observation_of(session);
  Json observed = Json::object();
  for (const Observable& observable : wanted) {
    observed[std::string(observable.name)] = {{"value", json_of(measure(observable, observation))},
                                              {"unit", unit_of(observable, observation.domain)}};
  }
  return observed;
}

std::string describe_observed(const Json& observed) {
  std::string text;
  for (const auto& [name, entry] : observed.items()) {
    char padded[40];
    std::snprintf(padded, sizeof(padded), "%-24s", name.c_str());
    text += padded + text_of(entry) + "\n";
  }
  return text;
}

}  // namespace ballpit
