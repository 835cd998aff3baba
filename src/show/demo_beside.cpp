// SPDX-License-Identifier: MIT
// Demonstrations beside each other, one for each broad phase that is compared. The first one leads: what is done to it,
// it does to the others, and after each of its steps they make the same step.
#include <algorithm>

#include "core/numbers.h"
#include "core/phrase.h"
#include "methods/methods.h"
#include "render/painter.h"
#include "scene/read_scene.h"
#include "show/comparison.h"
#include "show/demo.h"

namespace ballpit {

namespace {

/// Throws UserError unless the session finds contacts by the broad phase that is named.
void check_response(const Session& session) {
  const Response response = session.choice() ? Response::automatic : session.settings().response;
  check_compared({{"response", std::string(name_of(response))}});
}

std::string label_of(BroadPhase method) {
  if (!is_of_lecture(method)) return translated(find_method(method).label);
  const std::string_view name = name_of(method);  // "lecture/linked-cell"
  const auto own = named<BroadPhase>(name.substr(name.find('/') + 1));
  return translated(find_method(own).label) + ", " + translated("as on the slides");
}

}  // namespace

void Demo::compare(const std::vector<BroadPhase>& methods) {
  check_response(session);
  const std::vector<GivenOption> given = session.given();
  for (const BroadPhase method : methods) {
    if (method == methods.front()) {
      session.take(with_broad_phase(given, method), session.scene().physics);
    } else {
      beside_.push_back(std::make_unique<Demo>(session.scene_name(), with_broad_phase(given, method)));
    }
    Demo& shown = view_at(beside_.size());
    shown.compared_ = method;
    shown.begin_world();
  }
  player.after_step = [this] { keep_together(); };
}

std::vector<std::string> Demo::compared_methods() const {
  std::vector<std::string> names;
  if (compared_) names.emplace_back(name_of(*compared_));
  for (const auto& other : beside_) names.emplace_back(name_of(*other->compared_));
  return names;
}

void Demo::each_beside(const std::function<void(Demo&)>& action) {
  for (const auto& other : beside_) action(*other);
}

/// Loads a scene with the method of this view. Throws UserError if it has no use for broad phases.
void Demo::load_compared(const std::string& scene) {
  if (scene != session.scene_name()) {
    const Settings settings = combine(load_scene(scene).defaults, {});
    check_compared({{"response", std::string(name_of(settings.response))}}, "in " + scene + " with --compare");
  }
  session.load(scene);
  session.set("broadphase", std::string(name_of(*compared_)));
}

void Demo::keep_together() {
  for (const auto& other : beside_) {
    if (changes_shown_ != changes_) {
      other->view = view;
      other->measures = measures;
      other->touch();
    }
    other->catch_up(timeline->step_now());
    if (!other->player.failure().empty()) message_ = other->player.failure();
  }
  changes_shown_ = changes_;
}

/// Goes to a step as the timeline does, or on beyond it. Stays where it is once a step has failed.
void Demo::catch_up(int64_t step) {
  if (step < timeline->step_now()) player.forgive();
  if (step == timeline->step_now() || !player.failure().empty()) return;
  touch();
  timeline->go_to(std::min(step, timeline->furthest()));
  while (timeline->step_now() < step && player.failure().empty()) player.step(*timeline);
}

/// Call after each step.
void Demo::count_tests() {
  if (!compared_) return;
  const auto done = static_cast<size_t>(timeline->step_now() - timeline->first());
  if (done == tests_.size()) tests_.push_back(tests_.back() + report().candidates);
}

/// Later steps will be made by another detection.
void Demo::forget_tests() {
  tests_.resize(std::min(tests_.size(), static_cast<size_t>(timeline->step_now() - timeline->first()) + 1));
}

int64_t Demo::tests_so_far() { return tests_[static_cast<size_t>(timeline->step_now() - timeline->first())]; }

PageView Demo::compared() {
  PageView page;
  page.title = label_of(*compared_);
  page.sign = sign_of(*compared_);
  page.is_still = false;
  if (!player.failure().empty()) page.title += translated(": stopped");
  const Report& now = report();
  const std::string contacts = counted(now.contacts, "contact");
  page.figures = {phrase("{}, {}", counted(now.candidates, "test"), contacts),
                  phrase("{} so far", counted(tests_so_far(), "test"))};
  if (measures && player.mean_step_time() > 0) {
    page.figures.push_back(phrase("{} ms a step", local_number(three_digits(player.mean_step_time()))));
  }
  return page;
}

std::vector<Room> Demo::rooms(float aspect) {
  if (!is_comparing()) return {Room{}};
  return view_rooms(view_count(), box(), aspect,
                    view.has_caption ? room_of(heading_, view.text_scale, aspect).above : 0);
}

FrameView Demo::heading() {
  heading_ = {};
  heading_.has_no_scene = heading_.has_views = true;
  if (view.has_caption) {
    heading_.title = phrase("{}: {}, t = {} s", title(), counted(report().count, "sphere"),
                            local_number(fmt::format("{:.2f}", session.time())));
  }
  return {.inspection = nothing_, .domain = box(), .camera = {}, .overlays = {}, .is_written = true, .page = &heading_};
}

}  // namespace ballpit
