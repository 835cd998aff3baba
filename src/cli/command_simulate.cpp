// SPDX-License-Identifier: MIT
// ballpit simulate: no pictures; the final state, observables, a trajectory, and a summary.
#include <iostream>
#include <optional>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/observe.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "cli/trajectory.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/numbers.h"
#include "scene/catalog.h"
#include "scene/spheres_csv.h"
#include "show/session.h"

namespace ballpit {

namespace {

class SimulateCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override {
    time_option_ =
        command.add_option("--time", time_, "simulated time; default: the scene's duration")->type_name("SECONDS");
    out_option_ = command.add_option("--out", out_, "write the final state there, as CSV")->type_name("FILE");
    observe_option_ = command
                          .add_option("--observe", observe_,
                                      "what to measure at the end: all, or some of " + join(observable_names()))
                          ->type_name("A,B,…");
    trajectory_option_ =
        command.add_option("--trajectory", trajectory_, "write frames there, as extended XYZ")->type_name("FILE");
    every_option_ = command.add_option("--every", every_, "steps from one frame of the trajectory to the next")
                        ->type_name("N")
                        ->shows_default();
    command.add_flag("--json", json_, "print the summary as one JSON object");
    arguments_.add_to(command);
  }

  void run() override {
    std::optional<double> time;
    if (time_option_->is_given()) time = parse_number("--time", time_, 0, 1e9);
    const int64_t every = parse_every();
    std::vector<Observable> observables;
    if (observe_option_->is_given()) observables = parse_observables(observe_);
    check_outputs();
    Session session(arguments_.scene(), arguments_.given(), need_tally(observables));
    simulate(session, time.value_or(session.scene().needs.duration), every);
    if (!out_.empty()) write_spheres_csv(out_, session.world().bodies());
    tell(session, observables);
  }

 private:
  void check_outputs() const {
    if (out_option_->is_given()) parse_output("--out", out_);
    if (trajectory_option_->is_given()) parse_output("--trajectory", trajectory_);
    reject_same_file("--trajectory", trajectory_, "--out", out_);
    if (!is_scene_file(arguments_.scene())) return;
    reject_same_file("--out", out_, "SCENE", arguments_.scene());
    reject_same_file("--trajectory", trajectory_, "SCENE", arguments_.scene());
  }

  /// Returns the steps between frames.
  int64_t parse_every() const {
    const int64_t every = parse_integer("--every", every_, 1, 1'000'000'000);
    if (every_option_->is_given() && !trajectory_option_->is_given()) {
      throw UserError("--every", every_ + " without --trajectory", "together with it");
    }
    return every;
  }

  void simulate(Session& session, double time, int64_t every) const {
    const int64_t steps = session.steps_until(time);
    catch_interrupts();  // a file is begun: it is also ended
    std::optional<Trajectory> trajectory;
    if (!trajectory_.empty()) trajectory.emplace(trajectory_, session.scene().domain, every);
    try {
      step_to(session, time, steps, trajectory);
    } catch (const Interrupted&) {
      // within a long step
    } catch (const RunError& error) {
      throw error.with(rescue(session, last_good_file(session))).with(trajectory ? trajectory->finish_early() : "");
    }
    if (was_interrupted()) {
      throw RunError(session.scene().name,
                     "interrupted after " + std::to_string(session.world().steps()) + " of " + std::to_string(steps) +
                         " steps, at t = " + three_digits(session.world().time()) + " s",
                     trajectory ? trajectory->finish_early() : "");
    }
  }

  std::string last_good_file(const Session& session) const {
    return out_.empty() ? session.scene().name + "-last-good.csv" : out_;
  }

  /// Steps to the end, or until it is interrupted.
  static void step_to(Session& session, double time, int64_t steps, std::optional<Trajectory>& trajectory) {
    Progress progress("steps", steps);
    session.advance_to(time, [&] {
      if (trajectory) trajectory->pass(session.world());
      progress.show(session.world().steps());
      return was_interrupted();
    });
    if (trajectory && !was_interrupted()) trajectory->finish(session.world());
  }

  void tell(Session& session, const std::vector<Observable>& observables) const {
    auto summary = summarize(session);
    if (!observables.empty()) summary["observables"] = observe(session, observables);
    if (json_) {
      print_json(summary);
      return;
    }
    std::cout << describe(summary);
    if (!observables.empty()) std::cout << describe_observed(summary["observables"]);
  }

  SceneArguments arguments_;
  std::string time_, out_, observe_, trajectory_, every_ = "1";
  CommandOption *time_option_ = nullptr, *out_option_ = nullptr, *observe_option_ = nullptr;
  CommandOption *trajectory_option_ = nullptr, *every_option_ = nullptr;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_simulate_command() { return std::make_unique<SimulateCommand>(); }

}  // namespace ballpit
