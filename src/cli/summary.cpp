// SPDX-License-Identifier: MIT
#include "cli/summary.h"

#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ballpit {

using Json = nlohmann::ordered_json;

void print_json(const Json& json) { std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n"; }

Json json_of(const std::vector<Stage>& stages) {
  Json list = Json::array();
  for (const Stage& stage : stages) {
    list.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"launches", stage.launches}});
  }
  return list;
}

RunSummary summary_of(Session& session) {
  return {session.scene().name, session.backend(), session.settings(), session.world().report()};
}

Json json_of(const RunSummary& summary) {
  const Report& report = summary.report;
  const Settings& settings = summary.settings;
  Json json{{"scene", summary.scene},
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
              {"backend", summary.backend}}}};
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

std::string text_of(const RunSummary& summary) {
  const Report& r = summary.report;
  const Settings& settings = summary.settings;
  std::string text;
  const auto line = [&](const char* label, const std::string& value) {
    text += fmt::format("{:<18}{}\n", label, value);
  };
  line("scene", fmt::format("{}, {} spheres", summary.scene, r.count));
  line("methods", fmt::format("{}, {}, {}, {}, {}", r.broadphase, name_of(settings.response),
                              name_of(integrator_of(settings)), name_of(precision_of(settings)), summary.backend));
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

}  // namespace ballpit
