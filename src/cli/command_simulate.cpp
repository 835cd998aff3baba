// SPDX-License-Identifier: MIT
// ballpit simulate: no pictures; the final state, observables, a trajectory, and a summary.
#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "core/numbers.h"
#include "scene/extended_xyz.h"
#include "scene/read_scene.h"
#include "scene/spheres_csv.h"
#include "world/observer.h"

namespace ballpit {

namespace {

/// For a run that ended early: moves its trajectory to `path` and returns where the frames are. Empty without frames.
std::string finish_early(std::optional<ExtendedXyz>& trajectory, const std::string& path) {
  if (!trajectory || trajectory->frames() == 0) return "";
  const std::string frames =
      trajectory->frames() == 1 ? "the first frame is" : fmt::format("the {} frames so far are", trajectory->frames());
  try {
    trajectory->finish();
  } catch (const RunError& error) {
    return fmt::format("{} lost: {}", frames, error.what());
  }
  return fmt::format("{} in {}", frames, path);
}

class SimulateCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add_number({"--time", "SECONDS", "simulated time, by default the scene's duration"}, time_,
                       Range{0.0, 1e9});
    command.add_path({"--out", "FILE", "write the final state there, as CSV"}, out_);
    command.add({"--observe", "A,B,…", "what to measure at the end: all, or some of " + join(names_in(observables()))},
                [this](const std::string& text) { observables_ = parse_observables(text); });
    command.add_number(
        {"--observe-from", "SECONDS", "when observation begins: rates and ways are counted from then on", "0"},
        observe_from_, Range{0.0, 1e9});
    command.add_path({"--trajectory", "FILE", "write frames there, as extended XYZ"}, trajectory_);
    command.add_number({"--every", "N", "steps from one frame of the trajectory to the next", "1"}, every_,
                       Range{1, 1'000'000'000});
    acts_.add_to(command);
    command.add_flag("--json", json_, "print the summary as one JSON object");
    arguments_.add_to(command);
  }

  void run() {
    check_outputs();
    Session session(arguments_.scene, arguments_.given, need_tally(observables_));
    session.time_stages(json_);
    const double time = time_.value_or(session.scene().needs.duration);
    check_observation(time);
    session.play(acts_.read(session));
    session.steps_until(time);  // throws if these are too many
    warn_of_run(session);
    const bool follows_ways = std::ranges::any_of(observables_, &Observable::needs_ways);
    Observer observer(session.scene().domain, observe_from_.value_or(0), follows_ways);
    simulate(session, time, observer);
    if (!out_.empty()) write_spheres_csv(out_, session.world().bodies());
    print_outcome(session, observer);
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
    reject_same_file("--out", out_, "--acts", acts_.path);
    reject_same_file("--trajectory", trajectory_, "--acts", acts_.path);
    if (!is_scene_file(arguments_.scene)) return;
    reject_same_file("--out", out_, "SCENE", arguments_.scene);
    reject_same_file("--trajectory", trajectory_, "SCENE", arguments_.scene);
  }

  void check_observation(double time) const {
    if (!observe_from_) return;
    if (observables_.empty()) {
      throw UserError("--observe-from", fmt::format("{} without --observe", number_text(*observe_from_)),
                      "together with it");
    }
    if (*observe_from_ < time) return;
    throw UserError("--observe-from", number_text(*observe_from_),
                    fmt::format("less than {} s, the end", number_text(time)));
  }

  void simulate(Session& session, double time, Observer& observer) const {
    const int64_t steps = session.steps_until(time);
    catch_interrupts();  // so that the files are closed properly
    std::optional<ExtendedXyz> trajectory;
    if (!trajectory_.empty()) trajectory.emplace(trajectory_, session.scene().domain);
    try {
      step_to(session, time, steps, trajectory, observer);
    } catch (const Interrupted&) {
      // within a long step
    } catch (const RunError& error) {
      const std::string state = out_.empty() ? session.scene().name + "-last-good.csv" : out_;
      throw error.with(rescue(session, state)).with(finish_early(trajectory, trajectory_));
    }
    if (was_interrupted()) {
      throw RunError(session.scene().name,
                     fmt::format("interrupted after {} of {} steps, at t = {} s", session.world().steps(), steps,
                                 three_digits(session.world().time())),
                     finish_early(trajectory, trajectory_));
    }
  }

  /// Steps to the end, or until it is interrupted. The trajectory has the start, every so many steps, and the end. What it
  /// and the observer have seen stands: with --response auto the run never goes back beyond the last frame.
  void step_to(Session& session, double time, int64_t steps, std::optional<ExtendedXyz>& trajectory,
               Observer& observer) const {
    Progress progress("steps", steps);
    const int64_t every = every_.value_or(1);
    const double dt = session.settings().dt;  // of frames, also after a change of the step
    const std::string choice =
        session.choice() ? typed(options_of(session.settings(), session.scene().defaults)) : std::string();
    Observer good = observer;
    const auto look = [&] {
      observer.look(session.world());
      progress.show(steps - session.steps_until(time));
      return was_interrupted();
    };
    for (int64_t step = 0; trajectory && step < steps; step += every) {
      session.advance_to(static_cast<double>(step) * dt, look, [&] { observer = good; });
      if (was_interrupted()) return;
      observer.look(session.world());
      good = observer;
      trajectory->append(session.world().time(), session.world().bodies(), step == 0 ? choice : "");
    }
    session.advance_to(time, look, [&] { observer = good; });
    observer.look(session.world());
    if (!trajectory || was_interrupted()) return;
    trajectory->append(session.world().time(), session.world().bodies(), trajectory->frames() == 0 ? choice : "");
    trajectory->finish();
  }

  void print_outcome(Session& session, const Observer& observer) const {
    const std::vector<Observed> observed = observe(session, observer, observables_);
    nlohmann::ordered_json json = json_of(session);
    if (!observed.empty()) json["observables"] = json_of(observed);
    if (session.choice()) json["choice"] = json_of_choice(session, arguments_.scene);
    const std::string why = session.choice() ? fmt::format("{:<18}{}\n", "chosen", session.choice()->reason) : "";
    print(json_, json, text_of(session) + why + text_of(observed));
  }

  SceneArguments arguments_;
  ActsArgument acts_;
  std::optional<double> time_, observe_from_;  // [s]
  std::string out_, trajectory_;
  std::vector<Observable> observables_;
  std::optional<int> every_;
  bool json_ = false;
};

}  // namespace

std::function<void()> make_simulate_command(CommandOptions& options) { return make_command<SimulateCommand>(options); }

}  // namespace ballpit
