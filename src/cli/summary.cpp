// SPDX-License-Identifier: MIT
#include "cli/summary.h"

#include <cstdio>
#include <iostream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

std::string hexadecimal(uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(value));
  return text;
}

}  // namespace

void print_json(const Json& json) { std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n"; }

Json list_stages(const std::vector<Stage>& stages) {
  Json list = Json::array();
  for (const Stage& stage : stages) {
    list.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"launches", stage.launches}});
  }
  return list;
}

Json summarize(Session& session) {
  const Report report = session.world().report();
  const Settings& settings = session.settings();
  Json summary{{"scene", session.scene().name},
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
  if (!report.broadphase_reason.empty()) summary["reason"] = report.broadphase_reason;
  summary.update({{"seconds", report.seconds},
                  {"candidates", report.candidates},
                  {"contacts", report.contacts},
                  {"searches", report.searches},
                  {"bytes", report.detection_bytes},
                  {"kinetic_energy", report.kinetic_energy},
                  {"potential_energy", report.potential_energy},
                  {"elastic_energy", report.elastic_energy},
                  {"momentum", {report.momentum.x, report.momentum.y, report.momentum.z}},
                  {"max_overlap", report.max_overlap},
                  {"state_hash", hexadecimal(report.state_hash)},
                  {"stages", list_stages(report.stages)}});
  return summary;
}

std::string describe(const Json& summary) {
  std::ostringstream text;
  const auto number = [&](const char* key) { return summary[key].get<double>(); };
  const auto line = [&](const char* label) -> std::ostream& {
    char padded[24];
    std::snprintf(padded, sizeof(padded), "%-18s", label);
    return text << padded;
  };
  line("scene") << summary["scene"].get<std::string>() << ", " << summary["count"] << " spheres\n";
  line("methods");
  const char* separator = "";
  for (const Json& name : summary["methods"]) {
    text << separator << name.get<std::string>();
    separator = ", ";
  }
  text << "\n";
  if (summary.contains("reason")) line("") << "chosen by auto: " << summary["reason"].get<std::string>() << "\n";
  line("simulated") << number("time") << " s in " << summary["steps"] << " steps of " << number("dt") << " s\n";
  line("took") << number("seconds") << " s";
  if (number("steps") > 0) text << ", " << 1e3 * number("seconds") / number("steps") << " ms a step";
  text << "\n";
  line("contacts") << summary["contacts"] << " among " << summary["candidates"] << " candidates\n";
  line("detection") << summary["searches"] << " searches, " << number("bytes") / 1e6 << " MB\n";
  line("energy") << number("kinetic_energy") << " J kinetic, " << number("potential_energy") << " J potential";
  if (number("elastic_energy") > 0) text << ", " << number("elastic_energy") << " J elastic";
  text << "\n";
  const Json& momentum = summary["momentum"];
  line("momentum") << momentum[0].get<double>() << ", " << momentum[1].get<double>() << ", "
                   << momentum[2].get<double>() << " kg·m/s\n";
  line("largest overlap") << number("max_overlap") << " of the smaller radius\n";
  line("state hash") << summary["state_hash"].get<std::string>() << "\n";
  return text.str();
}

}  // namespace ballpit
