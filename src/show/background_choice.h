// SPDX-License-Identifier: MIT
// A choice of settings (src/choose) on a thread of its own, so that the window does not wait for it.
//
//     begin() ──▶ thread: choose() on a copy of the scene ──▶ result(), asked now and then, or wait()
//        └─ abandon(): the thread is asked to stop, and its result is ignored
//
// Cost: the budget, on cores that the scene uses, too; so the measured times are those beside a running scene.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "choose/choose.h"

namespace ballpit {

class BackgroundChoice {
 public:
  BackgroundChoice();
  ~BackgroundChoice();  ///< stops and waits, for about a pilot's step

  /// Begins a choice, in place of one that runs. `scene` has its bodies; `given` are options that are kept.
  void begin(Scene scene, std::vector<GivenOption> given, double budget);

  void abandon();
  bool is_running() const { return job_ != nullptr; }

  struct Result {
    std::optional<Choice> choice;
    std::string failure;  ///< why there is no choice
  };

  /// The result, once; empty while there is none.
  std::optional<Result> result();

  /// Waits for the result.
  std::optional<Result> wait();

 private:
  struct Job;

  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> abandoned_;  // until their threads have ended
};

}  // namespace ballpit
