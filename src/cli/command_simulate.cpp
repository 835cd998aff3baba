// SPDX-License-Identifier: MIT
// ballpit simulate: no pictures; the final state, observables, a trajectory, and a summary.
#include <iostream>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/observe.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/error.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "core/numbers.h"
#include "scene/extended_xyz.h"
#include "scene/read_scene.h"
#include "scene/spheres_csv.h"
#include "show/session.h"

namespace ballpit {

namespace {

/// Writes frames of a run to a file: the start, every so many steps, and the end.
class Trajectory {
 public:
  /// Throws RunError if the file cannot be written, as all functions but finish_early() do.
  Trajectory(const std::string& path, const Domain& domain, int64_t every)
      : path_(path), file_(path, domain), every_(every) {}

  /// Call in each state but the last.
  void pass(World& world) {
    if (world.steps() % every_ == 0) file_.append(world.time(), world.bodies());
  }

  /// Adds the last frame and moves the file to its destination.
  void finish(World& world) {
    file_.append(world.time(), world.bodies());
    file_.finish();
  }

  /// For a run that ended early: moves the file to its destination and returns where the frames are. Empty without
  /// frames.
  std::string finish_early() {
    if (file_.frames() == 0) return "";
    const std::string frames =
        file_.frames() == 1 ? "the first frame is" : fmt::format("the {} frames so far are", file_.frames());
    try {
      file_.finish();
    } catch (const RunError& error) {
      return fmt::format("{} lost: {}", frames, error.what());
    }
    return fmt::format("{} in {}", frames, path_);
  }

 private:
  std::string path_;
  ExtendedXyz file_;
  int64_t every_;
};

class SimulateCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override {
    command.add_number({"--time", "SECONDS", "simulated time, by default the scene's duration"}, time_,
                       Range{0.0, 1e9});
    command.add_path({"--out", "FILE", "write the final state there, as CSV"}, out_);
    command.add({"--observe", "A,B,…", "what to measure at the end: all, or some of " + join(names_in(observables()))},
                [this](const std::string& text) { observables_ = parse_observables(text); });
    command.add_path({"--trajectory", "FILE", "write frames there, as extended XYZ"}, trajectory_);
    command.add_number({"--every", "N", "steps from one frame of the trajectory to the next", "1"}, every_,
                       Range{1, 1'000'000'000});
    command.add_flag("--json", json_, "print the summary as one JSON object");
    arguments_.add_to(command);
  }

  void run() override {
    check_outputs();
    Session session(arguments_.scene(), arguments_.given(), need_tally(observables_));
    simulate(session, time_.value_or(session.scene().needs.duration));
    if (!out_.empty()) write_spheres_csv(out_, session.world().bodies());
    print(session);
  }

 private:
  void check_outputs() const {
    if (every_ && trajectory_.empty()) {
      throw UserError("--every", fmt::format("{} without --trajectory", *every_), "together with it");
    }
    for (const std::string& path : {out_, trajectory_}) {
      if (!path.empty()) check_output(path);
    }
    reject_same_file("--trajectory", trajectory_, "--out", out_);
    if (!is_scene_file(arguments_.scene())) return;
    reject_same_file("--out", out_, "SCENE", arguments_.scene());
    reject_same_file("--trajectory", trajectory_, "SCENE", arguments_.scene());
  }

  void simulate(Session& session, double time) const {
    const int64_t steps = session.steps_until(time);
    catch_interrupts();  // so that the files are closed properly
    std::optional<Trajectory> trajectory;
    if (!trajectory_.empty()) trajectory.emplace(trajectory_, session.scene().domain, every_.value_or(1));
    try {
      step_to(session, time, steps, trajectory);
    } catch (const Interrupted&) {
      // within a long step
    } catch (const RunError& error) {
      const std::string state = out_.empty() ? session.scene().name + "-last-good.csv" : out_;
      throw error.with(rescue(session, state)).with(trajectory ? trajectory->finish_early() : "");
    }
    if (was_interrupted()) {
      throw RunError(session.scene().name,
                     fmt::format("interrupted after {} of {} steps, at t = {} s", session.world().steps(), steps,
                                 three_digits(session.world().time())),
                     trajectory ? trajectory->finish_early() : "");
    }
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

  void print(Session& session) const {
    const RunSummary summary = summary_of(session);
    const std::vector<Observed> observed = observe(session, observables_);
    if (!json_) {
      std::cout << text_of(summary) << text_of(observed);
      return;
    }
    nlohmann::ordered_json json = json_of(summary);
    if (!observed.empty()) json["observables"] = json_of(observed);
    print_json(json);
  }

  SceneArguments arguments_;
  std::optional<double> time_;  // [s]
  std::string out_, trajectory_;
  std::vector<Observable> observables_;
  std::optional<int> every_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_simulate_command() { return std::make_unique<SimulateCommand>(); }

}  // namespace ballpit
