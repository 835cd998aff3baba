// SPDX-License-Identifier: MIT
// ballpit choose: the cheapest method with which a scene shows what it needs, and why.
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "choose/record.h"
#include "cli/options.h"
#include "cli/summary.h"
#include "core/interrupt.h"
#include "core/numbers.h"

namespace ballpit {

namespace {

std::string shown(double value) { return three_digits(value); }

class ChooseCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add_number({"--budget", "SECONDS", "computing time for all pilots"}, budget_, Range{0.1, 3600.0});
    command.add_flag("--remeasure", remeasure_, "measure the machine again, by which --broadphase auto decides");
    command.add_flag("--json", json_, "print the choice as one JSON object");
    arguments_.add_to(command);
  }

  void run() {
    catch_interrupts();
    Settings overrides;
    apply_given(overrides, arguments_.given);
    const Scene scene = load_scene(arguments_.scene, {overrides.count, overrides.seed, overrides.mass_ratio});
    if (overrides.response != Response::automatic) check_given(overrides, arguments_.given);
    try {
      const Choice choice = choose({scene, arguments_.given, budget_, remeasure_});
      print(json_, json_of(choice, arguments_.scene, scene, arguments_.given), text_of(choice, scene));
      if (!choice.chosen) throw RunError(scene.name, choice.reason);
    } catch (const Interrupted&) {
      throw RunError(scene.name, "interrupted");
    }
  }

 private:
  /// [s] of the settings that are chosen, or come nearest.
  static double step_of(const Choice& choice) {
    if (choice.chosen) return choice.chosen->settings.dt;
    return choice.nearest ? choice.nearest->settings.dt : Settings{}.dt;
  }

  std::string text_of(const Choice& choice, const Scene& scene) const {
    std::string text = fmt::format("{}, {} spheres\n", scene.name, choice.numbers.count);
    if (!choice.needs.note.empty()) text += choice.needs.note + "\n";
    text += fmt::format("\nneeds for {} s:", shown(choice.needs.needs.duration));
    for (const Tolerance& tolerance : choice.tolerances) {
      text += fmt::format(" {} {}", tolerance.name, shown(tolerance.allowed));
    }
    for (const Effect effect : choice.needs.needs.effects) {
      text += fmt::format(" {}", kEffectNames[static_cast<size_t>(effect)]);
    }
    text += "\n\nthe scene in numbers\n";
    for (const NamedNumber& number : named_numbers(choice.numbers, step_of(choice))) {
      text += fmt::format("  {:<9} {:>9}  {}\n", number.symbol, shown(number.value), number.meaning);
    }
    text += choice.ruled_out.empty() ? "" : "\nruled out\n";
    for (const RuledOut& out : choice.ruled_out) text += fmt::format("  {:<24} {}\n", out.method, out.reason);
    return text + attempts(choice) + outcome(choice, scene);
  }

  static std::string attempts(const Choice& choice) {
    std::string text = fmt::format("\npilots of {} spheres\n  {:<24} {:>10} {:>10}", choice.pilot_spheres, "method",
                                   "step [s]", "cost [s]");
    for (const Tolerance& tolerance : choice.tolerances) text += fmt::format(" {:>18}", tolerance.name);
    text += "\n";
    for (const Attempt& attempt : choice.tried) {
      text += fmt::format("  {:<24} {:>10} {:>10}", attempt.method, shown(attempt.settings.dt), shown(attempt.cost));
      for (size_t k = 0; k < choice.tolerances.size(); ++k) {
        const bool is_broken = attempt.knows(k) && attempt.errors[k] > choice.tolerances[k].allowed;
        text += fmt::format(" {:>18}", attempt.knows(k) ? shown(attempt.errors[k]) + (is_broken ? " !" : "  ") : "-  ");
      }
      text += fmt::format("  {}\n", !attempt.remark.empty() ? attempt.remark : attempt.holds ? "holds" : "breaks");
    }
    return text;
  }

  std::string outcome(const Choice& choice, const Scene& scene) const {
    if (!choice.chosen) return "\n";
    std::string text = "\nnot needed\n";
    for (const std::string& what : choice.unneeded) text += "  " + what + "\n";
    if (!scene.because.empty()) text += fmt::format("\nthe scene's own settings differ, because {}\n", scene.because);
    return text + fmt::format("\n{}.\n  {}\n", choice.reason,
                              command_of(arguments_.scene, scene, arguments_.given, choice.chosen->settings));
  }

  SceneArguments arguments_;
  double budget_ = 5;  // [s]
  bool remeasure_ = false, json_ = false;
};

}  // namespace

std::function<void()> make_choose_command(CommandOptions& options) { return make_command<ChooseCommand>(options); }

}  // namespace ballpit
