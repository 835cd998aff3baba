// SPDX-License-Identifier: MIT
#include "choose/record.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file.h"
#include "methods/number_range.h"

namespace ballpit {

namespace {

using Json = nlohmann::ordered_json;

/// Numbers as numbers.
Json object_of(const std::vector<GivenOption>& options) {
  Json json = Json::object();
  for (const GivenOption& option : options) {
    const std::optional<double> number = number_in(Range{-1e300, 1e300}, option.value);
    if (number && *number == std::floor(*number) && std::fabs(*number) < 1e15) {
      json[option.name] = static_cast<int64_t>(*number);
    } else if (number) {
      json[option.name] = *number;
    } else {
      json[option.name] = option.value;
    }
  }
  return json;
}

Json object_of(const Attempt& attempt, const std::vector<Tolerance>& tolerances, const Scene& scene) {
  Json errors = Json::object();
  for (size_t k = 0; k < tolerances.size(); ++k) {
    errors[tolerances[k].name] = attempt.knows(k) ? Json(attempt.errors[k]) : Json();
  }
  Json json{{"method", attempt.method},
            {"options", object_of(options_of(attempt.settings, scene.defaults))},
            {"cost", attempt.cost},
            {"errors", errors},
            {"holds", attempt.holds}};
  if (!attempt.remark.empty()) json["remark"] = attempt.remark;
  return json;
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& found) {
  throw UserError(path.string(), found,
                  "the choice of an earlier run with these options; without the file it is made anew");
}

/// The settings that an object of options stands for.
Settings settings_in(const Json& options, const std::filesystem::path& path, const Scene& scene,
                     const std::vector<GivenOption>& given) {
  if (!options.is_object()) fail(path, options.dump());
  Settings settings = base_settings(scene, given);
  for (const auto& [name, value] : options.items()) {
    const std::string text = value.is_string()           ? value.get<std::string>()
                             : value.is_number_integer() ? typed(value.get<int64_t>())
                             : value.is_number()         ? typed(value.get<double>())
                                                         : value.dump();
    apply_setting(settings, name, text, path.string() + ": " + name);
  }
  return settings;
}

}  // namespace

Json json_of(const Choice& choice, std::string_view name, const Scene& scene, const std::vector<GivenOption>& given) {
  Json numbers = Json::object(), ruled_out = Json::array(), tried = Json::array(), needs = Json::object();
  const Attempt* const shown = choice.chosen ? &*choice.chosen : choice.nearest ? &*choice.nearest : nullptr;
  for (const NamedNumber& number : named_numbers(choice.numbers, shown ? shown->settings.dt : Settings{}.dt)) {
    numbers[std::string(number.key)] = std::isfinite(number.value) ? Json(number.value) : Json();
  }
  for (const RuledOut& out : choice.ruled_out) {
    ruled_out.push_back({{"method", out.method}, {"reason", out.reason}, {"rule", out.rule}});
  }
  for (const Attempt& attempt : choice.tried) tried.push_back(object_of(attempt, choice.tolerances, scene));
  for (const Tolerance& tolerance : choice.tolerances) needs[tolerance.name] = tolerance.allowed;
  Json json{{"scene", name}, {"needs", needs}, {"numbers", numbers}, {"ruled_out", ruled_out}, {"tried", tried}};
  json["chosen"] = choice.chosen ? object_of(options_of(choice.chosen->settings, scene.defaults)) : Json();
  json["largest_overlap"] = choice.chosen ? Json(choice.chosen->largest_overlap) : Json();
  json["dearer"] = Json::array();
  for (const Settings& settings : choice.dearer)
    json["dearer"].push_back(object_of(options_of(settings, scene.defaults)));
  json["command"] = choice.chosen ? Json(command_of(name, scene, given, choice.chosen->settings)) : Json();
  json["reason"] = choice.reason;
  json["unneeded"] = choice.unneeded;
  json["pilot_spheres"] = choice.pilot_spheres;
  json["seconds"] = choice.seconds;
  return json;
}

Choice read_choice(const std::filesystem::path& path, const Scene& scene, const std::vector<GivenOption>& given) {
  Json json;
  try {
    json = Json::parse(read_file(path));
  } catch (const Json::exception&) {
    fail(path, "no JSON");
  }
  if (!json.is_object() || !json.contains("chosen") || !json["chosen"].is_object()) fail(path, "no \"chosen\"");
  Choice choice;
  choice.numbers = numbers_of(scene);
  choice.needs = effective_needs(scene);
  choice.tolerances = tolerances_of(choice.needs.needs);
  Attempt chosen;
  chosen.settings = settings_in(json["chosen"], path, scene, given);
  chosen.method = name_of(chosen.settings.response);
  if (json.contains("largest_overlap") && json["largest_overlap"].is_number()) {
    chosen.largest_overlap = json["largest_overlap"].get<double>();
  }
  choice.chosen = chosen;
  if (json.contains("dearer") && json["dearer"].is_array()) {
    for (const Json& options : json["dearer"]) choice.dearer.push_back(settings_in(options, path, scene, given));
  }
  choice.reason = json.value("reason", "");
  return choice;
}

}  // namespace ballpit
