// SPDX-License-Identifier: MIT
// ballpit list: all scenes, methods and other choices, from the tables that the rest of the program uses.
#include <array>
#include <iostream>
#include <span>

#include <fmt/format.h>
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
#include "scene/read_scene.h"
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

Json list_backends(std::span<const Backend> backends) {
  Json list = Json::array();
  for (const Backend& backend : backends) {
    const bool is_available = backend.unavailable_reason.empty();
    list.push_back({{"name", backend.name},
                    {"available", is_available},
                    {"description", is_available ? backend.description : backend.unavailable_reason}});
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

#if !BALLPIT_HAS_LABORATORY
struct Experiment {
  std::string_view name, title, question;
  double quick_seconds, full_seconds;
};
std::span<const Experiment> experiments() { return {}; }
#endif

Json list_experiments() {
  Json list = Json::array();
  for (const Experiment& experiment : experiments()) {
    list.push_back({{"name", experiment.name},
                    {"title", experiment.title},
                    {"question", experiment.question},
                    {"quick_seconds", experiment.quick_seconds},
                    {"full_seconds", experiment.full_seconds}});
  }
  return list;
}

/// "Pressure [Pa; in the plane N/m]"
std::string label_with_unit(const Observable& observable) {
  const auto& [name, label, unit, planar, estimator, needs_tally, compute] = observable;
  if (unit == "1") return std::string(label);
  return fmt::format("{} [{}{}]", label, unit, planar == unit ? "" : fmt::format("; in the plane {}", planar));
}

void print_line(std::string_view name, std::string_view text) { std::cout << fmt::format("  {:<22} {}\n", name, text); }

template <class Table>
void print_labels(const char* heading, const Table& table) {
  std::cout << fmt::format("{}\n", heading);
  for (const auto& entry : table) print_line(entry.name, entry.label);
}

void print_text(std::span<const Backend> backends) {
  std::cout << "Scenes\n";
  for (const SceneInfo& scene : built_in_scenes()) print_line(scene.name, scene.description);
  std::string_view family;
  for (const Method& method : methods()) {
    if (method.family == Family::backend) continue;
    if (family != name_of(method.family)) {
      family = name_of(method.family);
      std::cout << fmt::format("--{}\n", family);
    }
    print_line(method.name, fmt::format("{}: {}", method.label, method.cost));
  }
  std::cout << "--backend\n";
  for (const Backend& backend : backends) {
    const std::string& reason = backend.unavailable_reason;
    print_line(backend.name, reason.empty() ? backend.description : "not here: " + reason);
  }
  print_labels("--overlay", overlay_table());
  print_labels("--color", coloring_table());
  print_labels("--theme", themes());
  std::cout << "--observe\n";
  for (const Observable& observable : observables()) {
    print_line(observable.name, fmt::format("{}: {}", label_with_unit(observable), observable.estimator));
  }
  if (!experiments().empty()) std::cout << "Experiments of lab\n";
  for (const Experiment& experiment : experiments()) print_line(experiment.name, experiment.question);
}

class ListCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override { command.add_flag("--json", json_, "print one JSON object"); }

  void run() override {
    const std::array backends{cpu_backend(), cuda_backend()};
    if (!json_) {
      print_text(backends);
      return;
    }
    print_json({{"scenes", list_scenes()},
                {"methods", list_methods()},
                {"backends", list_backends(backends)},
                {"overlays", list_labels(overlay_table())},
                {"colorings", list_labels(coloring_table())},
                {"themes", list_labels(themes())},
                {"observables", list_observables()},
                {"experiments", list_experiments()}});
  }

 private:
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_list_command() { return std::make_unique<ListCommand>(); }

}  // namespace ballpit
