// SPDX-License-Identifier: MIT
// ballpit simulate: no pictures; the final state and a summary.
#include <iostream>
#include <optional>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/progress.h"
#include "app/session.h"
#include "app/summary.h"
#include "core/error.h"
#include "scene/spheres_csv.h"

namespace ballpit {

namespace {

class SimulateCommand final : public Command {
 public:
  void add_options(CLI::App& command) override {
    time_option_ =
        command.add_option("--time", time_, "simulated time; default: the scene's duration")->type_name("SECONDS");
    out_option_ = command.add_option("--out", out_, "write the final state there, as CSV")->type_name("FILE");
    command.add_flag("--json", json_, "print the summary as one JSON object")->disable_flag_override();
    arguments_.add_to(command);
  }

  void run() override {
    std::optional<double> time;
    if (time_option_->count() > 0) time = parse_number("--time", time_, 0, 1e9);
    if (out_option_->count() > 0) parse_path("--out", out_);
    Session session(arguments_.scene(), arguments_.given());
    step_to(session, time.value_or(session.scene().needs.duration));
    if (!out_.empty()) write_spheres_csv(out_, session.world().bodies());
    const auto summary = summarize(session);
    if (json_) {
      print_json(summary);
    } else {
      std::cout << describe(summary);
    }
  }

 private:
  static void step_to(Session& session, double time) {
    catch_interrupts();
    const int64_t steps = session.steps_until(time);
    Progress progress("steps", steps);
    session.advance_to(time, [&] {
      progress.show(session.world().steps());
      return was_interrupted();
    });
    if (was_interrupted()) {
      throw RunError("interrupted after " + std::to_string(session.world().steps()) + " of " + std::to_string(steps) +
                     " steps");
    }
  }

  SceneArguments arguments_;
  std::string time_;
  std::string out_;
  CLI::Option* time_option_ = nullptr;
  CLI::Option* out_option_ = nullptr;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_simulate_command() { return std::make_unique<SimulateCommand>(); }

}  // namespace ballpit
