// SPDX-License-Identifier: MIT
// The search for the cheapest settings that hold: pilots in the order of their predicted costs.
//
//     event-driven     ·                          one rung
//     impulse          ○ ─ ○ ─ ● ─ ·              ○ breaks a tolerance, ● holds: its ladder is done where ○ and ● meet
//     penalty                  ○ ─ ○ ─ ×          × costs more than the cheapest ● of all ladders
//
// A ladder begins at the rung that formulas propose. It goes to coarser steps while pilots hold, else to finer ones.
#pragma once

#include <chrono>

#include "choose/choose.h"

namespace ballpit {

/// A variant that rules allow, and what is known of its rungs.
struct Ladder {
  const Variant* variant;
  int fails;             ///< the finest rung that is known to fail, or the one before the first allowed one
  int next;              ///< the rung to be tried
  int believed;          ///< the rung that formulas believe in; the last one if they see none
  double predicted = 0;  ///< [s] cost of its pilot for all spheres, roughly
  int works = kRungs, dear = kRungs;  ///< the coarsest rungs that are known to hold, and to be too dear
  bool has_failed = false, is_done = false;
  int stuck = 0;               ///< pilots that were no better than the one before
  double worst = INFINITY;     ///< of the last pilot that failed
  std::vector<bool> broken{};  ///< needs that a pilot of the whole time has broken
  Precision precision{};
  std::optional<int> threads{};
};

class Search {
 public:
  Search(const ChoiceRequest& request, const Needs& needs, const SceneNumbers& numbers);

  /// Fills the lists of what is ruled out and what was tried. Throws Interrupted.
  void run();

  std::vector<RuledOut> ruled_out;
  std::vector<Attempt> tried;

  /// The scene of the pilots: the whole, or a part of it.
  const Scene& part() const { return part_; }

  /// Whether the budget ended before all was tried.
  bool is_out_of_time() const { return is_out_of_time_; }

  /// The state in the middle of an attempt that holds; empty if it is unknown.
  Bodies middle_of(size_t attempt) const;

 private:
  struct Tried {
    bool holds, is_dear;
    double worst, cost;
  };

  double left() const;
  double scale() const;
  RuleCase judged(const Settings& settings) const { return {request_.scene, needs_, numbers_, settings}; }
  std::optional<Settings> settings_of(const Variant& variant, int rung) const;

  /// Those that rules of these kinds allow; fills the list of what is ruled out.
  std::vector<Ladder> ladders_within(std::initializer_list<RuleKind> kinds);
  void calibrate(std::vector<Ladder>& ladders);
  double predicted(const Variant& variant, int rung) const;
  int64_t pilot_size(const std::vector<Ladder>& ladders) const;
  bool needs_truth() const { return needs_.path_tolerance || !needs_.observables.empty(); }
  void find_exact_truth();
  const Truth& truth_for(const Variant& variant, int rung);
  PilotResult pilot(const Settings& settings, const Truth& truth, double seconds) const;
  void note_broken(Ladder& ladder, PilotResult& result) const;
  Tried try_rung(Ladder& ladder);
  void find_nearest(std::vector<Ladder>& ladders);
  void climb(Ladder& ladder);
  void note_failure(Ladder& ladder, double worst) const;

  const ChoiceRequest& request_;
  const Needs& needs_;
  const SceneNumbers& numbers_;
  std::vector<Tolerance> tolerances_;
  std::chrono::steady_clock::time_point begin_;
  Settings base_;
  Scene part_;
  double step_of_sphere_ = 2e-7;  // [s] of computing, roughly
  bool is_out_of_time_ = false;
  double until_;  // [s] of simulated time at which pilots end
  Truth truth_;
  bool has_exact_truth_ = false;
  const Variant* own_truth_of_ = nullptr;
  int own_truth_rung_ = 0;
  double best_cost_ = INFINITY;  // [s] of pilots that hold
  std::vector<std::pair<size_t, Bodies>> middles_;
};

}  // namespace ballpit
