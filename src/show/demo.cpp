// SPDX-License-Identifier: MIT
#include "show/demo.h"

#include <chrono>
#include <cmath>

#include "core/numbers.h"
#include "core/phrase.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"

namespace ballpit {

namespace {

constexpr std::chrono::milliseconds kMaxReplay{500};
constexpr int64_t kMaxListedCandidates = 2'000'000;  // listed for an overlay
constexpr int64_t kMaxForPicked = 100'000;           // candidates, and spheres, to search for the picked sphere
constexpr size_t kMaxMoments = 240;
constexpr int64_t kMaxForOracle = 20'000;  // spheres among which brute force searches for missed contacts

/// [m/s] After a fall through the domain, or at the start if that is faster.
float typical_speed(const Scene& scene) {
  const Vec3d size = scene.domain.max - scene.domain.min;
  double squared = 2 * length(scene.physics.gravity) * std::max({size.x, size.y, size.z});
  for (const Vec3d& velocity : scene.bodies.velocity) squared = std::max(squared, dot(velocity, velocity));
  return static_cast<float>(std::sqrt(squared));
}

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
  timeline = std::make_unique<Timeline>(session.world(), session.settings().dt);
  timeline->after_step = [this] { follow(); };
  if (ghost_) ghost_->forget_after(session.time());
  const Report& now = report();
  energy_at_start_ = energy_of(now);
  history_.clear();
  remember_moment(now);
  if (view.selected >= now.count) view.selected = -1;
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
  attempt([&] {
    const World* const before = &session.world();
    const bool could_miss = can_miss_contacts(session.settings());
    session.set(option, value);
    player.forget_times();
    const bool is_same_motion = !could_miss && !can_miss_contacts(session.settings());
    if (option == "count" || option == "seed") {
      trade_off.clear();
      ghost_.reset();
    }
    if (&session.world() != before || !is_same_motion) {
      begin_world();
    } else {
      trade_off.begin(session.given(), session.scene().physics);
    }
  });
}

void Demo::return_to(const Played& trial) {
  const std::vector<GivenOption> given = trial.given;  // the trial may be deleted
  const Physics physics = trial.physics;
  change([&] {
    const bool is_same = have_same_collisions(session.scene().physics, physics);
    session.take(given, physics);
    player.forget_times();
    if (!is_same) ghost_.reset();
  });
}

void Demo::set_physics(const Physics& physics) {
  change([&] {
    const bool is_same = have_same_collisions(session.scene().physics, physics);
    session.take(session.given(), physics);
    if (!is_same) ghost_.reset();
  });
}

void Demo::restart() {
  change([&] {
    session.load(session.scene_name());
    ghost_.reset();
  });
}

void Demo::load(const std::string& scene) {
  change([&] {
    session.load(scene);
    view.selected = -1;
    trade_off.clear();
    ghost_.reset();
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
    ghost_ = std::make_unique<Ghost>(session.scene(), session.settings(), session.world(), session.time());
  });
}

void Demo::follow() {
  if (!shows_ghost()) return;
  if (ghost_) {
    ghost_->follow(session.world(), session.time(), session.settings().dt);
  } else {
    ghost_ = std::make_unique<Ghost>(session.scene(), session.settings(), session.world(), session.time());
  }
}

/// The parts of an inspection that the view shows.
Wanted Demo::wanted() {
  Wanted result = coloring_named(view.coloring).wanted;
  result.state |= view.selected >= 0;
  for (const OverlayEntry& overlay : overlay_table()) {
    if (view.shows(overlay.name)) result = result | overlay.wanted;
  }
  if (view.selected >= 0 && report().count <= kMaxForPicked) {
    result.candidates |= candidates_to_list() <= kMaxForPicked;
    result.endpoints = true;
  }
  return result;
}

/// An estimate. 0 for event-driven motion, whose report counts all forecasts so far; it lists few pairs.
int64_t Demo::candidates_to_list() {
  return session.settings().response == Response::event_driven ? 0 : report().candidates;
}

/// The wanted parts that would take too long for a picture.
Wanted Demo::too_much(const Wanted& wanted) {
  Wanted result;
  result.candidates = wanted.candidates && candidates_to_list() > kMaxListedCandidates;
  result.missed = wanted.missed && report().count > kMaxForOracle;
  return result;
}

FrameView Demo::frame_view(float aspect, bool is_written) {
  Wanted wanted = this->wanted();
  wanted.state |= !is_written;
  const Inspection& seen = inspect(wanted);
  const Domain& domain = session.scene().domain;
  const DomainBox box{Vec3(domain.min), Vec3(domain.max), domain.dimensions, domain.boundary == Boundary::open_top,
                      domain.boundary == Boundary::periodic};
  const float below = room_below(view.overlays, seen, view.text_scale);
  Camera camera = leave_room_below(camera_of(view, box, aspect), below);
  if (view.has_caption) {
    caption_ = captioned();
    Room room = room_of(caption_, view.text_scale, aspect);
    room.below += below;
    camera = camera_of(view, box, room, aspect);
  }
  const auto step = static_cast<float>(session.settings().dt / session.settings().substeps);
  return {seen,
          box,
          camera,
          view.overlays,
          view.selected,
          view.coloring,
          step,
          left_out_,
          is_written,
          view.has_caption ? &caption_ : nullptr,
          view.shows("velocity") ? typical_speed(session.scene()) : 0};
}

PageView Demo::captioned() {
  const Scene& scene = session.scene();
  const std::string& title = language() == Language::german ? scene.title_de : scene.title;
  PageView page;
  page.title = title.empty() ? scene.name : title;
  page.is_still = false;
  const Report& last = report();
  const int64_t n = last.count;
  const std::string spheres = counted(n, "sphere"), contacts = counted(last.contacts, "contact");
  if (session.settings().response == Response::event_driven) {
    const int64_t collisions = last.tally.collisions + last.tally.wall_hits;
    page.caption =
        phrase("{}: {}, {} so far", spheres, counted(collisions, "collision"), counted(last.events, "event"));
  } else if (last.candidates == 0) {
    page.caption = phrase("{}, {}", spheres, contacts);
  } else {
    page.caption = phrase("{}: {} tests in place of {}, {}", spheres, grouped(last.candidates),
                          grouped(n * (n - 1) / 2), contacts);
  }
  return page;
}

const Inspection& Demo::inspect(Wanted wanted) {
  if (inspected_ == version()) {
    wanted = wanted | requested_;
    if (wanted == requested_) return inspection_;
  }
  requested_ = wanted;
  left_out_ = too_much(wanted);
  wanted.candidates &= !left_out_.candidates;
  wanted.missed &= !left_out_.missed;
  inspection_ = session.world().inspect(wanted);
  if (wanted.ghost) {
    follow();
    const bool is_exact = session.settings().response == Response::event_driven;
    inspection_.ghost = ghost_->inspect(session.world(), session.time(), session.settings().dt, is_exact);
  }
  inspected_ = version();
  return inspection_;
}

const Report& Demo::report() {
  const Report& report = session.report();
  if (reported_ != version()) {
    reported_ = version();
    trade_off.observe(report);
    remember_moment(report);
  }
  return report;
}

void Demo::remember_moment(const Report& report) {
  while (!history_.empty() && history_.back().step >= report.steps) history_.pop_back();
  const double drift = energy_at_start_ != 0 ? (energy_of(report) - energy_at_start_) / std::fabs(energy_at_start_) : 0;
  history_.push_back({report.steps, static_cast<float>(drift), static_cast<float>(report.max_overlap)});
  if (history_.size() > kMaxMoments) history_.erase(history_.begin());
}

}  // namespace ballpit
