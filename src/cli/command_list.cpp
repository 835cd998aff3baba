// SPDX-License-Identifier: MIT
// ballpit list: what there is to choose from, from the tables that everything else uses.
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/summary.h"
#if BALLPIT_HAS_LABORATORY
#include "lab/report/experiment.h"
#endif
#include "methods/methods.h"
#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/theme.h"
#include "scene/catalog.h"
#include "world/observables.h"
#include "world/world.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

Json list_scenes() {
  Json scenes = Json::array();
  for (const SceneInfo& scene : built_in_scenes()) {
    scenes.push_back({{"name", scene.name},
                      {"title", scene.title},
                      {"description", scene.description},
                      {"title_de", scene.title_de},
                      {"description_de", scene.description_de}});
  }
  return scenes;
}

Json list_methods() {
  Json list = Json::array();
  for (const Method& method : methods()) {
    if (method.family == Family::backend) continue;
    list.push_back({{"family", name_of(method.family)},
                    {"name", method.name},
                    {"label", method.label},
                    {"backends", method.backends},
                    {"cost", method.cost},
                    {"source", method.source}});
  }
  return list;
}

Json list_backends() {
  Json list = Json::array();
  for (const Backend& backend : {cpu_backend(), cuda_backend()}) {
    list.push_back(
        {{"name", backend.name},
         {"available", backend.unavailable_reason.empty()},
         {"description", backend.unavailable_reason.empty() ? backend.description : backend.unavailable_reason}});
  }
  return list;
}

template <class Table>
Json list_labels(const Table& table) {
  Json list = Json::array();
  for (const auto& entry : table) list.push_back({{"name", entry.name}, {"label", entry.label}});
  return list;
}

Json list_observables() {
  Json list = Json::array();
  for (const Observable& observable : observables()) {
    list.push_back({{"name", observable.name},
                    {"label", observable.label},
                    {"unit", observable.unit},
                    {"planar_unit", observable.planar_unit},
                    {"estimator", observable.estimator}});
  }
  return list;
}

Json list_experiments() {
  Json list = Json::array();
#if BALLPIT_HAS_LABORATORY
  for (const Experiment& experiment : experiments()) {
    list.push_back({{"name", experiment.name},
                    {"title", experiment.title},
                    {"question", experiment.question},
                    {"quick_seconds", experiment.quick_seconds},
                    {"full_seconds", experiment.full_seconds}});
  }
#endif
  return list;
}

/// "Pressure [Pa; in the plane N/m]"
std::string label_with_unit(const Json& observable) {
  const std::string label = observable["label"], unit = observable["unit"], planar = observable["planar_unit"];
  if (unit == "1") return label;
  return label + " [" + unit + (planar == unit ? "" : "; in the plane " + planar) + "]";
}

void print_line(const std::string& name, const std::string& text) {
  std::printf("  %-22s %s\n", name.c_str(), text.c_str());
}

void print_text(const Json& list) {
  std::puts("Scenes");
  for (const Json& scene : list["scenes"]) print_line(scene["name"], scene["description"]);
  std::string family;
  for (const Json& method : list["methods"]) {
    if (family != method["family"]) {
      family = method["family"];
      std::printf("--%s\n", family.c_str());
    }
    print_line(method["name"], method["label"].get<std::string>() + ": " + method["cost"].get<std::string>());
  }
  std::puts("--backend");
  for (const Json& backend : list["backends"]) {
    const std::string description = backend["description"];
    print_line(backend["name"], backend["available"] ? description : "not here: " + description);
  }
  std::puts("--overlay");
  for (const Json& overlay : list["overlays"]) print_line(overlay["name"], overlay["label"]);
  std::puts("--color");
  for (const Json& coloring : list["colorings"]) print_line(coloring["name"], coloring["label"]);
  std::puts("--theme");
  for (const Json& theme : list["themes"]) print_line(theme["name"], theme["label"]);
  std::puts("--observe");
  for (const Json& observable : list["observables"]) {
    print_line(observable["name"], label_with_unit(observable) + ": " + observable["estimator"].get<std::string>());
  }
  if (!list["experiments"].empty()) std::puts("Experiments of lab");
  for (const Json& experiment : list["experiments"]) print_line(experiment["name"], experiment["question"]);
}

class ListCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override { command.add_flag("--json", json_, "print one JSON object"); }

  void run() override {
    const Json list{{"scenes", list_scenes()},
                    {"methods", list_methods()},
                    {"backends", list_backends()},
                    {"overlays", list_labels(overlay_table())},
                    {"colorings", list_labels(coloring_table())},
                    {"themes", list_labels(themes())},
                    {"observables", list_observables()},
                    {"experiments", list_experiments()}};
    if (json_) {
      print_json(list);
    } else {
      print_text(list);
    }
  }

 private:
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_list_command() { return std::make_unique<ListCommand>(); }

}  // namespace ballpit
