// SPDX-License-Identifier: MIT
#include "show/demo.h"

#include <chrono>
#include <cmath>

#include "show/comparison.h"

namespace ballpit {

namespace {

constexpr std::chrono::milliseconds kMaxReplay{500};
constexpr size_t kMaxMoments = 240;

/// Whether exact motion is the same with both.
bool have_same_collisions(const Physics& a, const Physics& b) {
  return a.gravity == b.gravity && a.restitution == b.restitution && a.wall_restitution == b.wall_restitution;
}

}  // namespace

Demo::Demo(std::string_view scene, const std::vector<GivenOption>& given, const std::filesystem::path& kept)
    : session(scene, given, false, kept) {
  begin_world();
}

void Demo::begin_world() {
  touch();
  ++worlds_;
  player.forgive();
  trade_off.begin(session.given(), session.scene().physics);
  timeline = std::make_unique<Timeline>(session.world(), session.settings().dt, Timeline::kBudget, &session.acts());
  timeline->after_step = [this] { follow(); };
  if (ghost_) ghost_->forget_after(session.time());
  if (session.choice()) predict(*session.choice());
  const Report& now = report();
  energy_at_start_ = energy_of(now);
  acts_at_start_ = acts_so_far();
  history_.clear();
  remember_moment(now);
  if (view.selected >= now.count) view.selected = -1;
  tests_ = {now.candidates};
}

void Demo::attempt(const std::function<void()>& action) {
  message_.clear();
  touch();
  try {
    action();
  } catch (const UserError& error) {
    message_ = error.what();
  } catch (const RunError& error) {
    message_ = error.what();
  } catch (const std::bad_alloc&) {
    message_ = "out of memory; fewer spheres need less";
  }
}

void Demo::change(const std::function<void()>& action) {
  attempt([&] {
    action();
    begin_world();
  });
}

void Demo::set(const std::string& option, const std::string& value) {
  background_.abandon();
  attempt([&] {
    if (is_comparing()) check_compared({{option, value}}, "while broad phases are compared");
    const World* const before = &session.world();
    const bool could_miss = can_miss_contacts(session.settings());
    session.set(option, value);
    player.forget_times();
    const bool is_same_motion = !could_miss && !can_miss_contacts(session.settings());
    if (option == "count" || option == "seed") {
      trade_off.clear();
      forget_choice();
      ghost_.reset();
    }
    if (&session.world() != before || !is_same_motion) {
      begin_world();
    } else {
      trade_off.begin(session.given(), session.scene().physics);
      forget_tests();
    }
    each_beside([&](Demo& other) { other.set(option, value); });
  });
}

void Demo::return_to(const Played& trial) {
  const std::vector<GivenOption> given = trial.given;  // the trial may be deleted
  const Physics physics = trial.physics;
  const double stiffness = session.scene().physics.stiffness;
  background_.abandon();
  change([&] {
    const bool is_same = have_same_collisions(session.scene().physics, physics);
    session.take(given, physics);
    player.forget_times();
    if (!is_same) ghost_.reset();
    if (!is_same || physics.stiffness != stiffness) forget_choice();
    each_beside([&](Demo& other) {
      Played own;
      own.given = with_broad_phase(given, *other.compared_);
      own.physics = physics;
      other.return_to(own);
    });
  });
}

void Demo::set_physics(const Physics& physics) {
  change([&] {
    const bool is_same = have_same_collisions(session.scene().physics, physics);
    session.take(session.given(), physics);
    forget_choice();
    if (!is_same) ghost_.reset();
    each_beside([&](Demo& other) { other.set_physics(physics); });
  });
}

void Demo::restart() {
  change([&] {
    session.load(session.scene_name());
    ghost_.reset();
    each_beside([](Demo& other) { other.restart(); });
  });
}

void Demo::load(const std::string& scene) {
  change([&] {
    compared_ ? load_compared(scene) : session.load(scene);
    view.selected = -1;
    trade_off.clear();
    forget_choice();
    ghost_.reset();
    each_beside([&](Demo& other) { other.load(scene); });
  });
}

void Demo::play(const std::vector<Act>& acts) {
  session.play(acts);
  begin_world();
  each_beside([&](Demo& other) { other.play(acts); });
}

void Demo::act(const Act& act) {
  attempt([&] {
    timeline->act(act);
    session.acted();
    player.forgive();
    forget_choice();
    ghost_.reset();
    each_beside([&](Demo& other) { other.act(act); });
  });
}

void Demo::step() {
  attempt([&] { player.step(*timeline); });
}

void Demo::advance_to(double time, const std::function<bool()>& stop) {
  const World* const before = &session.world();
  const auto follow_and_ask = [&] {
    follow();
    return stop();
  };
  const auto forget = [&] {
    if (ghost_) ghost_->forget_after(session.time());
  };
  session.advance_to(time, follow_and_ask, forget);
  follow();
  if (&session.world() != before) begin_world();
  each_beside([&](Demo& other) { other.advance_to(time, stop); });
}

void Demo::go_to(int64_t step) {
  attempt([&] {
    player.is_running = false;
    player.forgive();
    trade_off.interrupt();
    const auto start = std::chrono::steady_clock::now();
    const auto takes_too_long = [&] { return std::chrono::steady_clock::now() - start > kMaxReplay; };
    if (!go_on_to(step, takes_too_long))
      message_ = fmt::format("step {} so far; go there again to go on", timeline->step_now());
  });
  keep_together();
}

/// Timeline::go_to(), but each step that the ghost has not seen is made or restored before it.
bool Demo::go_on_to(int64_t step, const std::function<bool()>& stop) {
  if (!ghost_ || !shows_ghost()) return timeline->go_to(step, stop);
  const double since = ghost_->seen() - (session.time() - timeline->time_of(timeline->step_now()));
  const auto seen = std::max(timeline->first(), int64_t{std::llround(since / session.settings().dt)});
  const int64_t goal = std::clamp(step, timeline->first(), timeline->furthest());
  if (!timeline->go_to(std::min(goal, seen), stop)) return false;
  while (timeline->step_now() < goal) {
    if (stop()) return false;
    timeline->go_to(timeline->step_now() + 1);
    follow();
  }
  return true;
}

void Demo::drop_ghost() {
  attempt([&] {
    if (!shows_ghost()) view.toggle("ghost");
    begin_ghost();
  });
  each_beside([](Demo& other) { other.drop_ghost(); });
}

void Demo::begin_ghost() {
  ghost_ = std::make_unique<Ghost>(session.scene(), session.settings(), session.world(), session.time());
  ghost_acts_ = acts_so_far();
}

void Demo::follow() {
  count_tests();
  if (!shows_ghost()) return;
  if (ghost_ && ghost_acts_ == acts_so_far()) {
    ghost_->follow(session.world(), session.time(), session.settings().dt);
  } else {
    begin_ghost();  // exact motion knows of no act, so it begins anew after each
  }
}

const Report& Demo::report() {
  const Report& report = session.report();
  if (reported_ != version()) {
    reported_ = version();
    if (reported_acts_ != acts_so_far()) trade_off.interrupt();
    reported_acts_ = acts_so_far();
    trade_off.observe(report);
    remember_moment(report);
  }
  return report;
}

void Demo::remember_moment(const Report& report) {
  while (!history_.empty() && history_.back().step >= report.steps) history_.pop_back();
  const bool has_acted = acts_so_far() > acts_at_start_;
  const double energy = has_acted ? session.acts().energy_after(session.time()).value_or(0) : energy_at_start_;
  const double drift = energy != 0 ? (energy_of(report) - energy) / std::fabs(energy) : 0;
  history_.push_back({report.steps, static_cast<float>(drift), static_cast<float>(report.max_overlap)});
  if (history_.size() > kMaxMoments) history_.erase(history_.begin());
}

}  // namespace ballpit
