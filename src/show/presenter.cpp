// SPDX-License-Identifier: MIT
#include "show/presenter.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include <fmt/format.h>

#include "core/interrupt.h"
#include "core/phrase.h"

namespace ballpit {

namespace {

constexpr std::string_view kFallbackScene = "two-spheres";  // behind a page that fails

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
std::string slides_text(const Page& page) {
  if (page.slides.empty()) return "";
  const auto [low, high] = std::ranges::minmax(page.slides);
  if (low == high) return phrase("Slide {}", low);
  return phrase("Slides {}–{}", low, high);
}

}  // namespace

Presenter::Presenter(const Lecture& lecture) : lecture_(lecture) { open(); }

void Presenter::open() {
  kernel_.reset();
  race_.reset();
  failure_.clear();
  stops_ = {0};
  attempt([&] {
    demo_ = std::make_unique<Demo>(page().scene, page().options);
    demo_->view = page().view;
    demo_->view.text_scale = text_scale;
    start_ = demo_->session.world().inspect().bodies;
  });
  demo_->player.is_running = false;
  is_ready_ = false;
  prepare();
}

void Presenter::attempt(const std::function<void()>& action) {
  try {
    action();
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    failure_ = error.what();
    kernel_.reset();
    stops_ = {0};
    demo_ = std::make_unique<Demo>(kFallbackScene, std::vector<GivenOption>{});
    demo_->player.is_running = false;
  }
}

void Presenter::prepare() {
  if (is_ready_) return;
  const auto start = std::chrono::steady_clock::now();
  const auto is_over = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > patience;
  };
  attempt([&] {
    if (failure_.empty()) demo_->advance_to(page().time, is_over);
    if (failure_.empty() && is_over()) return;
    is_ready_ = true;
    if (failure_.empty() && page().kernel) record();
  });
  is_ready_ |= !failure_.empty();
}

void Presenter::record() {
  kernel_.emplace(lecture::record_kernel(*page().kernel, demo_->session.world().inspect().bodies,
                                         demo_->session.scene().domain, demo_->session.settings(),
                                         run_options(page().mistake, page().interleaving, start_)));
  if (page().stops.empty()) return;
  stops_.clear();
  for (const PageStop& stop : page().stops) {
    stops_.push_back(stop.phase == kStart ? 0 : place_of(kernel_->run(), stop, page()));
  }
  kernel_->go_to(stops_.front());
}

void Presenter::go_to(int number) {
  number_ = std::clamp(number, 1, count());
  open();
}

void Presenter::go_to_stop(size_t stop) {
  if (kernel_) kernel_->go_to(stops_[std::min(stop, stops_.size() - 1)]);
}

void Presenter::next() {
  const auto following = std::ranges::find_if(stops_, [&](size_t stop) { return stop > cursor(); });
  if (following != stops_.end()) {
    kernel_->go_to(*following);
  } else if (number_ < count()) {
    go_to(number_ + 1);
  }
}

void Presenter::previous() {
  if (number_ == 1) return go_to_stop(0);
  go_to(number_ - 1);
  go_to_stop(stops_.size() - 1);
}

void Presenter::step(int operations) {
  if (kernel_) kernel_->step(operations);
}

void Presenter::skip_phase(int phases) {
  if (kernel_) kernel_->skip_phase(phases);
}

std::vector<std::string> Presenter::titles() const {
  std::vector<std::string> titles;
  for (const Page& each : lecture_.pages) titles.push_back(each.title.in(language()));
  return titles;
}

std::string Presenter::caption() {
  if (!failure_.empty()) return failure_;
  if (!is_ready_) return "";
  const Inspection& seen = inspect();
  const Settings& settings = demo_->session.settings();
  const bool is_open = cursor() < stops_.back() && !page().question.en.empty();
  const std::string& text = (is_open ? page().question : page().caption).in(language());
  const bool shows_race = text.find("{lost_by_threads}") != std::string::npos;
  if (measures && shows_race && !race_) race_ = lecture::race_on_threads(kRacing);
  const Report& report = demo_->report();
  const double energy = 1 + double(demo_->history().back().energy_drift);
  return fill_caption(text,
                      {report, seen, all_contacts_, run(), cursor(), settings.dt / settings.substeps, energy, race_},
                      page().stored);
}

const Inspection& Presenter::inspect() {
  inspection_ = demo_->inspection(demo_->shows_occlusion());
  all_contacts_ = static_cast<int64_t>(inspection_.contacts.size() + inspection_.missed.size());
  if (kernel_) kernel_->show_in(inspection_);
  return inspection_;
}

PageView Presenter::describe_page() {
  PageView view;
  view.has_no_scene = is_blank || !failure_.empty();
  if (is_blank) return view;
  view.title = title();
  view.caption = caption();
  view.slides = slides_text(page());
  view.walks = demo_->view.selected >= 0;
  if (kernel_) kernel_->describe(view);
  return view;
}

FrameView Presenter::frame_view(float aspect) {
  inspect();
  page_view_ = describe_page();
  FrameView view = frame_with_page(*demo_, inspection_, page_view_, aspect, text_scale);
  if (const int64_t walker = kernel_ ? kernel_->walker() : -1; walker >= 0) view.selected = walker;
  return view;
}

}  // namespace ballpit
