// SPDX-License-Identifier: MIT
#include "show/presenter.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "render/overlays/overlay.h"
#include "show/record_text.h"

namespace ballpit {

namespace {

constexpr std::string_view kFallbackScene = "two-spheres";  // behind a page that fails

using lecture::Action;
using lecture::Operation;
using lecture::Phase;
using lecture::RecordedRun;

/// The cursor after a stop. Throws UserError if the phase or the thread is not in the record.
size_t place_of(const RecordedRun& run, const PageStop& stop, const Page& page) {
  const auto phase = std::ranges::find(run.phases, stop.phase, &Phase::name);
  if (stop.thread < 0) return phase->last;
  size_t place = 0;
  int left = stop.operations < 0 ? std::numeric_limits<int>::max() : stop.operations;
  for (size_t k = phase->first; k < phase->last && left > 0; ++k) {
    if (run.record.operations[k].thread != stop.thread) continue;
    place = k + 1;
    --left;
  }
  if (place > 0) return place;
  throw input_error(page.place, "[[page]] stops", fmt::format("\"{} {}\"", stop.phase, stop.thread),
                    "a thread of the phase that does something");
}

/// The slides that a page belongs to: "Slide 7", "Slides 2–4".
std::string slides_text(const Page& page, Language language) {
  if (page.slides.empty()) return "";
  const bool is_german = language == Language::german;
  const auto [low, high] = std::ranges::minmax(page.slides);
  if (low == high) return fmt::format("{} {}", is_german ? "Folie" : "Slide", low);
  return fmt::format("{} {}–{}", is_german ? "Folien" : "Slides", low, high);
}

}  // namespace

Presenter::Presenter(const Lecture& lecture, Language its_language) : language(its_language), lecture_(lecture) {
  open();
}

void Presenter::open() {
  run_.reset();
  race_.reset();
  failure_.clear();
  stops_ = {0};
  cursor_ = 0;
  try {
    demo_ = std::make_unique<Demo>(page().scene, page().options);
    start_ = demo_->session.world().inspect().bodies;
    demo_->session.advance_to(page().time, [] { return false; });
    demo_->view = page().view;
    if (page().kernel) record();
  } catch (const std::exception& error) {
    failure_ = error.what();
    run_.reset();
    stops_ = {0};
    demo_ = std::make_unique<Demo>(kFallbackScene, std::vector<GivenOption>{});
  }
  demo_->player.is_running = false;
  cursor_ = stops_.front();
}

void Presenter::record() {
  run_ = lecture::record_kernel(*page().kernel, demo_->session.world().inspect().bodies, demo_->session.scene().domain,
                                demo_->session.settings(), run_options(page().mistake, page().interleaving, start_));
  if (page().stops.empty()) return;
  stops_.clear();
  for (const PageStop& stop : page().stops) stops_.push_back(stop.phase == kStart ? 0 : place_of(*run_, stop, page()));
}

void Presenter::go_to(int number) {
  number_ = std::clamp(number, 1, count());
  open();
}

void Presenter::go_to_stop(size_t stop) { cursor_ = stops_[std::min(stop, stops_.size() - 1)]; }

void Presenter::next() {
  const auto following = std::ranges::find_if(stops_, [&](size_t stop) { return stop > cursor_; });
  if (following != stops_.end()) {
    cursor_ = *following;
  } else if (number_ < count()) {
    go_to(number_ + 1);
  }
}

void Presenter::previous() {
  if (number_ == 1) {
    cursor_ = stops_.front();
    return;
  }
  go_to(number_ - 1);
  cursor_ = stops_.back();
}

void Presenter::step(int operations) {
  if (!run_) return;
  const auto last = static_cast<int64_t>(run_->record.operations.size());
  cursor_ = static_cast<size_t>(std::clamp<int64_t>(static_cast<int64_t>(cursor_) + operations, 0, last));
}

void Presenter::skip_phase(int phases) {
  if (!run_) return;
  if (phases > 0) {
    cursor_ = run_->phase_at(cursor_).last;
    return;
  }
  size_t before = 0;
  for (const Phase& phase : run_->phases) {
    if (phase.last < cursor_) before = phase.last;
  }
  cursor_ = before;
}

std::string Presenter::caption() {
  if (!failure_.empty()) return failure_;
  const Inspection& seen = inspect();
  const Settings& settings = demo_->session.settings();
  const std::string& text = page().caption.in(language);
  const bool shows_race = text.find("{lost_by_threads}") != std::string::npos;
  if (measures && shows_race && !race_) race_ = lecture::race_on_threads(kRacing);
  const Report& report = demo_->report();
  const double energy = 1 + double(demo_->history().back().energy_drift);
  return fill_caption(
      text, {report, seen, all_contacts_, run(), cursor_, settings.dt / settings.substeps, energy, race_, language},
      page().stored);
}

const Inspection& Presenter::inspect() {
  inspection_ = demo_->inspection();
  all_contacts_ = static_cast<int64_t>(inspection_.contacts.size() + inspection_.missed.size());
  if (run_) show_record(inspection_);
  return inspection_;
}

/// What the kernel has built, tested and found up to the cursor.
void Presenter::show_record(Inspection& seen) const {
  const std::vector<Operation>& operations = run_->record.operations;
  const std::vector<Pair> all = seen.contacts;  // found by the scene's own method
  seen.contacts.clear();
  seen.candidates.clear();
  seen.missed.clear();
  for (size_t k = 0; k < cursor_; ++k) {
    if (operations[k].action != Action::test) continue;
    const int i = static_cast<int>(operations[k].index), j = operations[k].other;
    const Pair pair{std::min(i, j), std::max(i, j)};
    seen.candidates.push_back(pair);
    if (operations[k].value != 0) seen.contacts.push_back(pair);
  }
  std::ranges::sort(seen.candidates);
  std::ranges::sort(seen.contacts);
  if (cursor_ == operations.size()) {
    std::ranges::set_difference(all, seen.contacts, std::back_inserter(seen.missed));
  }
  if (run_->grid) {
    seen.grids = {*run_->grid};
    seen.grids[0].head = run_->record.values_after(0, cursor_);
    seen.grids[0].next = run_->record.values_after(1, cursor_);
  }
  if (run_->axis >= 0) {
    seen.axis = run_->axis;
    seen.endpoints.clear();
    for (const int entry : run_->record.values_after(0, cursor_)) {
      if (entry == lecture::kUnset) continue;
      const int i = entry / 2;
      const bool is_end = entry % 2 == 1;
      const float reach = seen.bodies.radius_of(i);
      seen.endpoints.push_back({seen.bodies.position_of(i)[run_->axis] + (is_end ? reach : -reach), i, is_end});
    }
  }
}

PageView Presenter::describe_page() {
  PageView view;
  view.has_no_scene = is_blank || !failure_.empty();
  if (is_blank) return view;
  view.title = title();
  view.caption = caption();
  view.slides = slides_text(page(), language);
  if (!run_) return view;
  const std::vector<Operation>& operations = run_->record.operations;
  const Operation& shown = operations[cursor_ > 0 ? cursor_ - 1 : 0];  // done last, or the first one, which comes next
  const CodeExcerpt code = function_at(lecture::kernel_source(run_->kernel), shown.line);
  view.code = code.lines;
  view.walks = run_->phase_at(cursor_ > 0 ? cursor_ - 1 : 0).name == "sweep";
  if (cursor_ == 0) return view;
  view.line = shown.line - code.first;
  view.step = text_of(*run_, cursor_ - 1, language);
  if (shown.array < 0) return view;
  view.touched_array = run_->record.arrays[static_cast<size_t>(shown.array)].name;
  view.touched_index = shown.index;
  const bool is_changed = shown.action != Action::load && shown.old_value != lecture::kUnset;
  if (is_changed) view.old_text = value_text(*run_, shown.old_value);
  return view;
}

FrameView Presenter::frame_view(float aspect) {
  const FrameView whole = demo_->frame_view(aspect);
  page_view_ = describe_page();
  Room room = room_of(page_view_, text_scale, aspect);
  room.below += room_below(whole.overlays, inspection_, text_scale);
  const float part = aspect * room.width() / room.height();
  const Camera camera = leave_room(camera_of(demo_->view, whole.domain, part), room, aspect);
  int64_t selected = demo_->view.selected;
  if (run_ && run_->axis >= 0 && cursor_ > 0 && page_view_.walks) {  // the sphere whose thread walks
    const Operation& shown = run_->record.operations[cursor_ - 1];
    selected = run_->record.values_after(0, cursor_)[static_cast<size_t>(shown.thread)] / 2;
  }
  return {inspection_, whole.domain,   camera, whole.overlays, selected,           whole.coloring,
          whole.step,  whole.left_out, false,  &page_view_,    whole.typical_speed};
}

}  // namespace ballpit
