// SPDX-License-Identifier: MIT
#include "cli/summary.h"

#include <iostream>

#include <nlohmann/json.hpp>

#include "measure/exact_pairs.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

/// The contacts of the present state by another method, so that no mistake is made twice. It has the same precision, so
/// that rounding makes no difference, and it chooses its own cells or axis, with which it misses no contact.
std::vector<Pair> contacts_by_other_method(Session& session) {
  Settings settings;
  const bool is_sorted_grid = session.report().broadphase == name_of(BroadPhase::sorted_grid);
  settings.broadphase = is_sorted_grid ? BroadPhase::sort_and_sweep : BroadPhase::sorted_grid;
  settings.precision = precision_of(session.settings());
  settings.threads = session.settings().threads;
  Scene scene;
  scene.domain = session.scene().domain;
  scene.bodies = session.world().bodies();
  return cpu_backend().make_world(scene, settings)->inspect().contacts;
}

}  // namespace

void print(bool as_json, const Json& json, const std::string& text) {
  std::cout << (as_json ? json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : text);
}

Json json_of(const std::vector<Stage>& stages) {
  Json list = Json::array();
  for (const Stage& stage : stages) {
    list.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"launches", stage.launches}});
  }
  return list;
}

Json json_of(Session& session) {
  const Report& report = session.report();
  const Settings& settings = session.settings();
  Json json{{"scene", session.scene().name},
            {"count", report.count},
            {"steps", report.steps},
            {"time", report.time},
            {"dt", settings.dt},
            {"substeps", settings.substeps},
            {"methods",
             {{"broadphase", report.broadphase},
              {"response", name_of(settings.response)},
              {"integrator", name_of(integrator_of(settings))},
              {"precision", name_of(precision_of(settings))},
              {"backend", session.backend()}}}};
  if (!report.broadphase_reason.empty()) json["reason"] = report.broadphase_reason;
  json.update({{"seconds", report.seconds},
               {"candidates", report.candidates},
               {"contacts", report.contacts},
               {"searches", report.searches},
               {"bytes", report.detection_bytes},
               {"kinetic_energy", report.kinetic_energy},
               {"potential_energy", report.potential_energy},
               {"elastic_energy", report.elastic_energy},
               {"momentum", {report.momentum.x, report.momentum.y, report.momentum.z}},
               {"max_overlap", report.max_overlap},
               {"state_hash", fmt::format("{:016x}", report.state_hash)},
               {"stages", json_of(report.stages)}});
  return json;
}

std::string text_of(Session& session) {
  const Report& r = session.report();
  const Settings& settings = session.settings();
  std::string text;
  const auto line = [&](const char* label, const std::string& value) {
    text += fmt::format("{:<18}{}\n", label, value);
  };
  line("scene", fmt::format("{}, {} spheres", session.scene().name, r.count));
  line("methods", fmt::format("{}, {}, {}, {}, {}", r.broadphase, name_of(settings.response),
                              name_of(integrator_of(settings)), name_of(precision_of(settings)), session.backend()));
  if (!r.broadphase_reason.empty()) line("", "chosen by auto: " + r.broadphase_reason);
  line("simulated", fmt::format("{:g} s in {} steps of {:g} s", r.time, r.steps, settings.dt));
  const std::string each =
      r.steps > 0 ? fmt::format(", {:g} ms a step", 1e3 * r.seconds / static_cast<double>(r.steps)) : "";
  line("took", fmt::format("{:g} s{}", r.seconds, each));
  line("contacts", fmt::format("{} among {} candidates", r.contacts, r.candidates));
  line("detection", fmt::format("{} searches, {:g} MB", r.searches, static_cast<double>(r.detection_bytes) / 1e6));
  const std::string elastic = r.elastic_energy > 0 ? fmt::format(", {:g} J elastic", r.elastic_energy) : "";
  line("energy", fmt::format("{:g} J kinetic, {:g} J potential{}", r.kinetic_energy, r.potential_energy, elastic));
  line("momentum", fmt::format("{:g}, {:g}, {:g} kg·m/s", r.momentum.x, r.momentum.y, r.momentum.z));
  line("largest overlap", fmt::format("{:g} of the smaller radius", r.max_overlap));
  line("state hash", fmt::format("{:016x}", r.state_hash));
  return text;
}

Json json_of_choice(Session& session, std::string_view scene) {
  Json json = json_of(*session.choice(), scene, session.scene(), session.given());
  json["steps_up"] = Json::array();
  for (const Session::StepUp& up : session.steps_up()) {
    json["steps_up"].push_back({{"time", up.time},
                                {"reason", up.reason},
                                {"options", typed(options_of(up.settings, session.scene().defaults))}});
  }
  return json;
}

std::vector<Observable> parse_observables(const std::string& text) {
  if (text == "all") return {observables().begin(), observables().end()};
  std::vector<Observable> result;
  for (const std::string& name : parse_names("--observe", text, names_in(observables()), "all")) {
    result.push_back(entry_named(observables(), name, "--observe"));
  }
  return result;
}

bool need_tally(std::span<const Observable> wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [](const Observable& o) { return o.needs_tally; });
}

std::vector<Observed> observe(Session& session, const Observer& observer, std::span<const Observable> wanted) {
  if (wanted.empty()) return {};
  World& world = session.world();
  Observation observation = observer.observation(world, session.report());
  observation.missed_contacts = [&] {
    return deviation_of(world.inspect().contacts, contacts_by_other_method(session)).missed;
  };
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
