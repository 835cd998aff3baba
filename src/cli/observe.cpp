// SPDX-License-Identifier: MIT
#include "cli/observe.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "measure/exact_pairs.h"
#include "show/parse.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

/// The contacts of the present state by another method, so that no mistake is made twice. It has the same precision, so
/// that rounding makes no difference, and it chooses its own cells or axis, with which it misses no contact.
std::vector<Pair> contacts_by_other_method(Session& session) {
  Settings settings;
  const bool is_sorted_grid = session.world().report().broadphase == name_of(BroadPhase::sorted_grid);
  settings.broadphase = is_sorted_grid ? BroadPhase::sort_and_sweep : BroadPhase::sorted_grid;
  settings.precision = precision_of(session.settings());
  settings.threads = session.settings().threads;
  Scene scene;
  scene.domain = session.scene().domain;
  scene.bodies = session.world().bodies();
  return cpu_backend().make_world(scene, settings)->inspect().contacts;
}

}  // namespace

std::vector<Observable> parse_observables(const std::string& text) {
  if (text == "all") return {observables().begin(), observables().end()};
  std::vector<Observable> result;
  for (const std::string& name : split_list(text)) {
    const auto found =
        std::find_if(observables().begin(), observables().end(), [&](const Observable& o) { return o.name == name; });
    if (found == observables().end()) {
      throw UserError("--observe", name,
                      "all alone, or some of " + join(names_in(observables())) + ", with commas between");
    }
    result.push_back(*found);
  }
  return result;
}

bool need_tally(std::span<const Observable> wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [](const Observable& o) { return o.needs_tally; });
}

std::vector<Observed> observe(Session& session, std::span<const Observable> wanted) {
  if (wanted.empty()) return {};
  World& world = session.world();
  const Observation observation{
      session.scene().domain, world.bodies(), world.report(),
      [&] { return deviation_of(world.inspect().contacts, contacts_by_other_method(session)).missed; }};
  std::vector<Observed> observed;
  for (const Observable& observable : wanted) {
    observed.push_back({observable.name, unit_of(observable, observation.domain), measure(observable, observation)});
  }
  return observed;
}

Json json_of(std::span<const Observed> observed) {
  Json json = Json::object();
  for (const auto& [name, unit, value] : observed) {
    const Json number = value.empty() ? Json() : value.size() == 1 ? Json(value[0]) : Json(value);
    json[std::string(name)] = {{"value", number}, {"unit", unit}};
  }
  return json;
}

std::string text_of(std::span<const Observed> observed) {
  std::string text;
  for (const auto& [name, unit, value] : observed) {
    const std::string of_unit = unit == "1" ? "" : fmt::format(" {}", unit);
    text +=
        fmt::format("{:<24}{}\n", name, value.empty() ? "-" : fmt::format("{:g}{}", fmt::join(value, ", "), of_unit));
  }
  return text;
}

}  // namespace ballpit
