// SPDX-License-Identifier: MIT
// Gives a lecture in the language set: one page at a time, each in the state that its file describes, whatever was
// changed on the page before.
//
//     next() ──▶ the page's next stop, then the next page          step() ──▶ one operation of the page's kernel
//
// The inspection that is drawn is the demonstration's; on a page with a kernel its lists, candidates and contacts are
// those of the record up to the cursor.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "render/page_view.h"
#include "show/caption.h"
#include "show/kernel_cursor.h"
#include "show/lecture.h"

namespace ballpit {

class Presenter {
 public:
  /// `lecture` must outlive the presenter. Starts with its first page.
  explicit Presenter(const Lecture& lecture);

  static constexpr float kTextScale = 1.6f;

  int number() const { return number_; }  ///< of the page, from 1
  int count() const { return static_cast<int>(lecture_.pages.size()); }
  const Page& page() const { return lecture_.pages[static_cast<size_t>(number_ - 1)]; }

  void go_to(int number);  ///< the first or the last page if there is none with this number
  void next();             ///< stop, then page
  void previous();         ///< page, at its last stop
  void step(int operations);
  void skip_phase(int phases);  ///< to the end of the phase, or to the end of the one before

  /// The places of the cursor at which next() stops; at least one.
  const std::vector<size_t>& stops() const { return stops_; }
  void go_to_stop(size_t stop);

  bool is_blank = false;
  bool measures = false;  ///< figures that differ from run to run; if not, pages show those stored in their file
  float text_scale = kTextScale;  ///< of the scene's text

  Demo& demo() { return *demo_; }
  const lecture::RecordedRun* run() const { return kernel_ ? &kernel_->run() : nullptr; }
  size_t cursor() const { return kernel_ ? kernel_->at() : 0; }

  /// [s] for which go_to() computes at most. Until a page is ready it shows its scene at an earlier moment, without a
  /// caption; each prepare() computes on.
  double patience = std::numeric_limits<double>::infinity();
  bool is_ready() const { return is_ready_; }
  void prepare();

  /// Why the page cannot be shown; empty if it can.
  const std::string& failure() const { return failure_; }

  std::string title() const { return page().title.in(language()); }
  std::vector<std::string> titles() const;  ///< of all pages
  std::string caption();

  /// The picture of the present state, valid until it changes.
  FrameView frame_view(float aspect);

 private:
  void open();
  void attempt(const std::function<void()>& action);  ///< an error becomes the page's failure
  void record();
  const Inspection& inspect();
  PageView describe_page();

  const Lecture& lecture_;
  int number_ = 1;
  std::unique_ptr<Demo> demo_;
  std::optional<KernelCursor> kernel_;
  std::vector<size_t> stops_;
  std::optional<lecture::RealRace> race_;
  BodySnapshot start_;        // the spheres before the page's time has passed
  int64_t all_contacts_ = 0;  // of the spheres that are shown
  bool is_ready_ = false;
  std::string failure_;
  Inspection inspection_;
  PageView page_view_;
};

}  // namespace ballpit
