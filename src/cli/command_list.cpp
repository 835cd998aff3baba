// SPDX-License-Identifier: MIT
// ballpit list: all scenes, methods and other choices, from the tables that the rest of the program uses.
#include <array>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/summary.h"
#if BALLPIT_HAS_LABORATORY
#include "lab/report/experiment.h"
#endif
#include "methods/methods.h"
#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "scene/read_scene.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

#if !BALLPIT_HAS_LABORATORY
struct ExperimentText {
  std::string title, question;
};
struct Experiment {
  std::string_view name;
  double quick_seconds, full_seconds;
  ExperimentText text() const { return {}; }
};
std::span<const Experiment> experiments() { return {}; }
#endif

/// An object for each entry of a table.
template <class Table, class Describe>
Json list_of(const Table& table, const Describe& describe) {
  Json list = Json::array();
  for (const auto& entry : table) list.push_back(describe(entry));
  return list;
}

template <class Table>
Json list_labels(const Table& table) {
  return list_of(table, [](const auto& entry) { return Json{{"name", entry.name}, {"label", entry.label}}; });
}

/// All methods but the backends, which have a list of their own.
std::vector<Method> stage_methods() {
  std::vector<Method> result(methods().begin(), methods().end());
  std::erase_if(result, [](const Method& method) { return method.family == Family::backend; });
  return result;
}

std::string description_of(const Backend& backend, const char* prefix) {
  return backend.unavailable_reason.empty() ? backend.description : prefix + backend.unavailable_reason;
}

Json json_of(std::span<const Backend> backends) {
  Json list;
  list["scenes"] = list_of(built_in_scenes(), [](const SceneInfo& scene) {
    return Json{{"name", scene.name},
                {"title", scene.title},
                {"description", scene.description},
                {"title_de", scene.title_de},
                {"description_de", scene.description_de}};
  });
  list["methods"] = list_of(stage_methods(), [](const Method& method) {
    return Json{{"family", name_of(method.family)}, {"name", method.name}, {"label", method.label},
                {"backends", method.backends},      {"cost", method.cost}, {"source", method.source}};
  });
  list["backends"] = list_of(backends, [](const Backend& backend) {
    return Json{{"name", backend.name},
                {"available", backend.unavailable_reason.empty()},
                {"description", description_of(backend, "")}};
  });
  list["overlays"] = list_labels(overlay_table());
  list["colorings"] = list_labels(coloring_table());
  list["themes"] = list_labels(themes());
  list["observables"] = list_of(observables(), [](const Observable& observable) {
    return Json{{"name", observable.name},
                {"label", observable.label},
                {"unit", observable.unit},
                {"planar_unit", observable.planar_unit},
                {"estimator", observable.estimator}};
  });
  list["experiments"] = list_of(experiments(), [](const Experiment& experiment) {
    const ExperimentText text = experiment.text();
    return Json{{"name", experiment.name},
                {"title", text.title},
                {"question", text.question},
                {"quick_seconds", experiment.quick_seconds},
                {"full_seconds", experiment.full_seconds}};
  });
  return list;
}

/// "Pressure [Pa; in the plane N/m]"
std::string label_with_unit(const Observable& observable) {
  const std::string_view unit = observable.unit, planar = observable.planar_unit;
  if (unit == "1") return std::string(observable.label);
  return fmt::format("{} [{}{}]", observable.label, unit,
                     planar == unit ? "" : fmt::format("; in the plane {}", planar));
}

std::string text_of(std::span<const Backend> backends) {
  std::string text = "Scenes\n";
  const auto add = [&](std::string_view name, std::string_view what) {
    text += fmt::format("  {:<22} {}\n", name, what);
  };
  const auto add_labels = [&](const char* heading, const auto& table) {
    text += heading;
    for (const auto& entry : table) add(entry.name, entry.label);
  };
  for (const SceneInfo& scene : built_in_scenes()) add(scene.name, scene.description);
  std::string_view family;
  for (const Method& method : stage_methods()) {
    if (family != name_of(method.family)) {
      family = name_of(method.family);
      text += fmt::format("--{}\n", family);
    }
    add(method.name, fmt::format("{}: {}", method.label, method.cost));
  }
  text += "--backend\n";
  for (const Backend& backend : backends) add(backend.name, description_of(backend, "not here: "));
  add_labels("--overlay\n", overlay_table());
  add_labels("--color\n", coloring_table());
  add_labels("--theme\n", themes());
  text += "--observe\n";
  for (const Observable& observable : observables()) {
    add(observable.name, fmt::format("{}: {}", label_with_unit(observable), observable.estimator));
  }
  if (!experiments().empty()) text += "Experiments of lab\n";
  for (const Experiment& experiment : experiments()) add(experiment.name, experiment.text().question);
  return text;
}

}  // namespace

std::function<void()> make_list_command(CommandOptions& options) {
  const auto as_json = std::make_shared<bool>();
  options.add_flag("--json", *as_json, "print one JSON object");
  return [as_json] {
    const std::array backends{cpu_backend(), cuda_backend()};
    print(*as_json, json_of(backends), text_of(backends));
  };
}

}  // namespace ballpit
