// SPDX-License-Identifier: MIT
#include "show/stepping.h"

#include <algorithm>
#include <array>

#include "core/numbers.h"
#include "core/phrase.h"
#include "render/painter.h"

namespace ballpit {

namespace {

using lecture::KernelName;

struct SteppedMethod {
  BroadPhase method;
  KernelName kernel;
};

/// The slides' kernel of a broad phase; none if they have none.
std::optional<KernelName> kernel_of(BroadPhase method) {
  static constexpr std::array kMethods{
      SteppedMethod{BroadPhase::brute_force, KernelName::brute_force},
      SteppedMethod{BroadPhase::lecture_brute_force, KernelName::brute_force},
      SteppedMethod{BroadPhase::sort_and_sweep, KernelName::sort_and_sweep},
      SteppedMethod{BroadPhase::lecture_sort_and_sweep, KernelName::sort_and_sweep},
      SteppedMethod{BroadPhase::linked_cell, KernelName::linked_cell},
      SteppedMethod{BroadPhase::lecture_linked_cell, KernelName::linked_cell},
  };
  const auto found = std::ranges::find(kMethods, method, &SteppedMethod::method);
  return found == kMethods.end() ? std::nullopt : std::optional(found->kernel);
}

/// What shows a kernel's arrays and tests, whether or not it is switched on.
std::vector<std::string_view> overlays_of(KernelName kernel) {
  switch (kernel) {
    case KernelName::brute_force:
      return {"labels", "pairs"};
    case KernelName::sort_and_sweep:
      return {"intervals", "labels", "pairs"};
    case KernelName::linked_cell:
    case KernelName::race:
      return {"grid", "labels", "lists", "pairs"};
  }
  return {};
}

}  // namespace

const KernelCursor* Stepping::cursor() {
  const bool is_same = demo_.worlds() == world_ && demo_.session.world().steps() == step_ &&
                       demo_.session.settings().broadphase == method_;
  if (!is_same) end();
  return cursor_ ? &*cursor_ : nullptr;
}

bool Stepping::begin() {
  if (cursor()) return true;
  demo_.player.is_running = false;
  method_ = demo_.session.settings().broadphase;
  world_ = demo_.worlds();
  step_ = demo_.session.world().steps();
  const std::optional<KernelName> kernel = kernel_of(method_);
  if (!kernel) {
    demo_.say(
        fmt::format("the slides have no kernel of {} to step through; brute force, sort and sweep and linked cell have",
                    name_of(method_)));
    return false;
  }
  try {
    cursor_.emplace(lecture::record_kernel(*kernel, demo_.session.world().inspect().bodies,
                                           demo_.session.scene().domain, demo_.session.settings()));
  } catch (const std::exception& error) {
    demo_.say(error.what());
    return false;
  }
  return true;
}

void Stepping::move(int operations) {
  if (begin()) cursor_->step(operations);
  demo_.touch();
}

void Stepping::skip_phase(int phases) {
  if (begin()) cursor_->skip_phase(phases);
  demo_.touch();
}

FrameView Stepping::frame_view(float aspect) {
  View& view = demo_.view;
  const std::vector<std::string> own = view.overlays;
  for (const std::string_view overlay : overlays_of(cursor_->run().kernel)) {
    if (!view.shows(overlay)) view.overlays.emplace_back(overlay);
  }
  inspection_ = demo_.inspection(demo_.shows_occlusion());
  cursor_->show_in(inspection_);
  page_ = {};
  cursor_->describe(page_);
  page_.title = fmt::format("{}: {}", name_of(cursor_->run().kernel), cursor_->phase().name);
  page_.caption =
      phrase("{} operations so far: {} tests, {}", grouped(static_cast<int64_t>(cursor_->at())),
             grouped(std::ssize(inspection_.candidates)), counted(std::ssize(inspection_.contacts), "contact"));
  FrameView frame = frame_with_page(demo_, inspection_, page_, aspect, view.text_scale);
  if (const int64_t walker = cursor_->walker(); walker >= 0) frame.selected = walker;
  view.overlays = own;
  return frame;
}

}  // namespace ballpit
