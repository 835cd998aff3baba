// SPDX-License-Identifier: MIT
#include "choose/search.h"

#include <algorithm>

#include "choose/detection.h"
#include "core/phrase.h"
#include "measure/search_costs.h"

namespace ballpit {

namespace {

constexpr double kMarginOfWhole = 0.9;  // of a tolerance, for pilots of the scene itself
constexpr double kMarginOfPart = 0.65;  // for pilots of a part of it, or of a part of its time
constexpr double kCollision = 1e-6;     // [s] of computing, roughly, only to size pilots and to order them

}  // namespace

Search::Search(const ChoiceRequest& request, const Needs& needs, const SceneNumbers& numbers)
    : request_(request),
      needs_(needs),
      numbers_(numbers),
      tolerances_(tolerances_of(needs)),
      begin_(std::chrono::steady_clock::now()),
      base_(base_settings(request.scene, request.given)),
      until_(needs.duration) {
  base_.costs = search_costs(cpu_backend(), base_.precision, request.remeasure);
}

/// [s]
double Search::left() const {
  return request_.budget - std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

double Search::scale() const {
  return part_.bodies.size() > 0 ? double(request_.scene.bodies.size()) / double(part_.bodies.size()) : 1;
}

Bodies Search::middle_of(size_t attempt) const {
  const auto found = std::ranges::find(middles_, attempt, &std::pair<size_t, Bodies>::first);
  return found == middles_.end() ? Bodies{} : found->second;
}

/// In double precision where single precision is ruled out.
std::optional<Settings> Search::settings_of(const Variant& variant, int rung) const {
  std::optional<Settings> settings = settings_at(variant, rung, base_, request_.given, needs_.duration);
  if (!settings || is_given(request_.given, "precision")) return settings;
  for (const Rule& rule : rules()) {
    const bool is_of_float = rule.name == "frozen" || rule.name == "rounding" || rule.name == "chaos";
    if (is_of_float && !rule.objection(judged(*settings)).empty()) settings->precision = Precision::float64;
  }
  return settings;
}

std::vector<Ladder> Search::ladders_within(std::initializer_list<RuleKind> kinds) {
  std::vector<Ladder> result;
  ruled_out.clear();
  for (const Variant& variant : variants()) {
    if (!settings_of(variant, 0)) continue;  // other options are given
    int first = -1, start = -1;
    Objection last;
    for (int rung = 0; rung < kRungs && start < 0; ++rung) {
      const std::optional<Settings> settings = settings_of(variant, rung);
      if (!settings) break;
      const Objection hard = first_objection(judged(*settings), kinds);
      if (hard) last = hard;
      if (hard && hard.rule->kind == RuleKind::method && hard.rule->name != "chaos") break;
      if (hard) continue;
      if (first < 0) first = rung;
      if (!first_objection(judged(*settings), {RuleKind::estimate})) start = rung;
    }
    if (first < 0) {
      ruled_out.push_back({std::string(variant.name), last.reason, last.rule ? last.rule->name : ""});
      continue;
    }
    // Where formulas see no step that is fine enough, pilots come last, and begin with the coarsest step.
    const int believed = start < 0 && !is_given(request_.given, "dt") ? kRungs - 1 : std::max(start, first);
    result.push_back({&variant, first - 1, std::max(start, first), believed});
    result.back().precision = settings_of(variant, result.back().next)->precision;
  }
  return result;
}

/// [s] of computing.
double Search::predicted(const Variant& variant, int rung) const {
  const auto count = double(request_.scene.bodies.size());
  if (variant.response == Response::event_driven) {
    return kCollision * count * (1 + numbers_.collision_rate * needs_.duration);
  }
  const Settings settings = settings_of(variant, rung).value_or(base_);
  return step_of_sphere_ * (count + 20) * variant.work * double(steps_to(needs_.duration, settings)) *
         settings.substeps;
}

/// Measures what a step costs for a few hundred spheres, for the predictions.
void Search::calibrate(std::vector<Ladder>& ladders) {
  constexpr int64_t kSpheres = 600;
  constexpr double kBlock = 0.003, kLater = 1.3;  // [s]; later in a run there are more contacts
  for (const Ladder& ladder : ladders) {
    if (ladder.variant->response == Response::event_driven || request_.scene.bodies.size() == 0) continue;
    const Scene few = part_of(request_.scene, kSpheres);
    Settings settings = *settings_of(*ladder.variant, ladder.next);
    settings.threads = 1;
    const double step = time_of_step(few, needs_, settings, kBlock) / settings.substeps;
    if (!std::isfinite(step)) continue;
    step_of_sphere_ = kLater * step / (double(few.bodies.size()) + 20) / ladder.variant->work;
    break;
  }
  for (Ladder& ladder : ladders) ladder.predicted = predicted(*ladder.variant, ladder.believed);
}

int64_t Search::pilot_size(const std::vector<Ladder>& ladders) const {
  constexpr double kShare = 0.03;  // of the budget
  constexpr int64_t kFewest = 300;
  const int64_t count = request_.scene.bodies.size();
  double cheapest = INFINITY;
  for (const Ladder& ladder : ladders) cheapest = std::min(cheapest, ladder.predicted);
  const double affordable = double(count) * request_.budget * kShare / std::max(cheapest, 1e-9);
  return std::clamp(static_cast<int64_t>(std::min(affordable, 1e9)), kFewest, kMaxPilotSpheres);
}

/// By exact motion where it can serve, whatever options are given.
void Search::find_exact_truth() {
  const Variant& exact = *std::ranges::find(variants(), Response::event_driven, &Variant::response);
  const Settings settings = *settings_at(exact, 0, base_settings(request_.scene, {}), {}, needs_.duration);
  if (first_objection(judged(settings), {RuleKind::method})) return;
  const PilotResult result = pilot(settings, {}, left() / 2);
  if (!result.stopped.empty()) return;
  until_ = result.reached;
  truth_ = result.truth;
  has_exact_truth_ = true;
}

PilotResult Search::pilot(const Settings& settings, const Truth& truth, double seconds) const {
  const double dearest = best_cost_ < INFINITY ? std::max(1.15 * best_cost_, kEqualCosts) : INFINITY;
  return run_pilot({part_, needs_, truth, until_, seconds, dearest, request_.stop}, settings);
}

/// The truth for a variant: exact, or its own motion with a quarter of the step.
const Truth& Search::truth_for(const Variant& variant, int rung) {
  constexpr int kQuarter = 4;
  if (!needs_truth() || has_exact_truth_) return truth_;
  if (own_truth_of_ == &variant && own_truth_rung_ >= rung + kQuarter) return truth_;
  own_truth_of_ = &variant;
  own_truth_rung_ = rung + kQuarter;
  const std::optional<Settings> settings = settings_of(variant, own_truth_rung_);
  const PilotPlan plan{part_, needs_, {}, until_, left() / 3, INFINITY, request_.stop};
  truth_ = settings ? run_pilot(plan, *settings).truth : Truth{};
  return truth_;
}

/// Finer steps that have less time are not excused for a need that a pilot of the whole time has broken.
void Search::note_broken(Ladder& ladder, PilotResult& result) const {
  ladder.broken.resize(tolerances_.size());
  for (size_t k = 0; k < result.errors.size(); ++k) {
    if (result.is_complete && !(result.errors[k] <= tolerances_[k].allowed)) ladder.broken[k] = true;
    if (ladder.broken[k]) result.is_unseen[k] = false;
  }
}

Search::Tried Search::try_rung(Ladder& ladder) {
  Settings settings = *settings_of(*ladder.variant, ladder.next);
  settings.precision = ladder.precision;
  settings.threads = *ladder.threads;
  const Truth truth = truth_for(*ladder.variant, ladder.next);
  PilotResult result = pilot(settings, truth, std::max(0.05, left() / 2));
  note_broken(ladder, result);
  const bool is_seen = std::ranges::find(result.is_unseen, true) == result.is_unseen.end();
  const bool is_whole = part_.bodies.size() == request_.scene.bodies.size();
  const double margin = is_whole && result.is_complete ? kMarginOfWhole : kMarginOfPart;
  Attempt attempt{std::string(ladder.variant->name),
                  settings,
                  result.cost * scale(),
                  result.errors,
                  result.is_unseen,
                  is_seen && ballpit::holds(result, tolerances_, margin),
                  !is_seen && ballpit::holds(result, tolerances_, margin),
                  worst_ratio(result, tolerances_) <= 1,
                  worst_ratio(result, tolerances_),
                  std::max(result.largest_overlap, result.seen.overlap),
                  result.stopped,
                  result.seen};
  if (attempt.is_close && !attempt.holds) {
    attempt.remark = attempt.may_hold ? phrase("too short to see all") : phrase("too close");
  }
  if (result.is_given_up) attempt.remark = phrase("dearer");
  if (attempt.holds) best_cost_ = std::min(best_cost_, result.cost);
  if (attempt.is_close) middles_.emplace_back(tried.size(), result.middle);
  const Tried outcome{attempt.holds || attempt.may_hold, result.is_given_up, attempt.worst, attempt.cost};
  tried.push_back(std::move(attempt));
  return outcome;
}

/// Makes pilots in the order of their predicted costs. So the first that holds is nearly the cheapest one, and later
/// ones are given up as soon as they cost more.
void Search::run() {
  std::vector<Ladder> ladders = ladders_within({RuleKind::method, RuleKind::step});
  const std::vector<RuledOut> by_rules = ruled_out;
  const bool are_all_out = ladders.empty();
  if (are_all_out) ladders = ladders_within({RuleKind::step});
  ruled_out = by_rules;
  calibrate(ladders);
  part_ = part_of(request_.scene, pilot_size(ladders));
  if (needs_truth()) find_exact_truth();
  if (are_all_out) return find_nearest(ladders);
  while (left() > 0) {
    Ladder* cheapest = nullptr;
    for (Ladder& ladder : ladders) {
      if (!ladder.is_done && (cheapest == nullptr || ladder.predicted < cheapest->predicted)) cheapest = &ladder;
    }
    if (cheapest == nullptr) return;
    const double limit = std::max(best_cost_ * scale(), kEqualCosts);
    if (best_cost_ < INFINITY && cheapest->predicted > 1.5 * limit && cheapest->has_failed) {
      cheapest->is_done = true;
      continue;
    }
    climb(*cheapest);
  }
  is_out_of_time_ = std::ranges::any_of(ladders, [](const Ladder& ladder) { return !ladder.is_done; });
}

/// Where all methods are ruled out: one pilot of each, none of which holds.
void Search::find_nearest(std::vector<Ladder>& ladders) {
  for (Ladder& ladder : ladders) {
    if (left() <= 0 || ladder.variant->response == Response::kinematic) continue;
    climb(ladder);
    tried.back().holds = tried.back().may_hold = tried.back().is_close = false;
    if (tried.back().remark.empty()) tried.back().remark = phrase("ruled out");
  }
}

/// Tries the next rung of a ladder, and finds the one after it.
void Search::climb(Ladder& ladder) {
  if (!ladder.threads) {
    const Settings settings = *settings_of(*ladder.variant, ladder.next);
    ladder.threads = cheapest_threads(part_, needs_, settings, request_.given);
  }
  const int tried_rung = ladder.next;
  const Tried outcome = try_rung(ladder);
  if (outcome.holds) {
    ladder.works = tried_rung;
  } else if (outcome.is_dear) {
    ladder.dear = tried_rung;
  } else {
    note_failure(ladder, outcome.worst);
  }
  const int top = std::min(ladder.works, ladder.dear);
  if (top - ladder.fails <= 1) ladder.is_done = true;
  if (ladder.works < kRungs) {
    ladder.next = ladder.has_failed ? (ladder.fails + ladder.works) / 2 : std::max(ladder.fails + 1, ladder.works - 2);
  } else if (ladder.has_failed) {
    ladder.next = std::min(ladder.fails + 2, top - 1);
  } else {
    ladder.next = std::max(ladder.fails + 1, ladder.dear - 2);
  }
  if (!settings_of(*ladder.variant, ladder.next)) ladder.is_done = true;
  ladder.predicted = outcome.cost * std::pow(2.0, 0.5 * (ladder.next - tried_rung));
}

/// Steps that are finer without being better may be limited by rounding, else by something that no step helps.
void Search::note_failure(Ladder& ladder, double worst) const {
  constexpr int kPatience = 3;
  constexpr double kBetter = 0.8;
  ladder.stuck = ladder.has_failed && worst > kBetter * ladder.worst ? ladder.stuck + 1 : 0;
  if (ladder.stuck >= kPatience && ladder.precision == Precision::float32 && !is_given(request_.given, "precision")) {
    ladder.precision = Precision::float64;
    ladder.stuck = 0;
  } else if (ladder.stuck >= kPatience) {
    ladder.is_done = true;
  }
  ladder.has_failed = true;
  ladder.worst = worst;
  ladder.fails = ladder.next;
}

}  // namespace ballpit
