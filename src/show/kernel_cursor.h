// SPDX-License-Identifier: MIT
// A cursor in the record of a slide's kernel: what the kernel has built, tested and found up to there. Lectures step
// through the kernels of their pages with it, the window through that of the present moment.
#pragma once

#include "lecture/recorded_run.h"
#include "render/page_view.h"
#include "show/demo.h"

namespace ballpit {

class KernelCursor {
 public:
  /// Begins before the first operation.
  explicit KernelCursor(lecture::RecordedRun run) : run_(std::move(run)) {}

  const lecture::RecordedRun& run() const { return run_; }
  size_t at() const { return at_; }  ///< the number of operations done
  size_t last() const { return run_.record.operations.size(); }

  /// The phase of the operation before the cursor, or the first one.
  const lecture::Phase& phase() const { return run_.phase_at(at_ > 0 ? at_ - 1 : 0); }

  void go_to(size_t place) { at_ = std::min(place, last()); }
  void step(int operations);
  void skip_phase(int phases);  ///< to the end of the phase, or to the end of the one before

  /// Replaces lists, candidates and contacts by those of the record up to the cursor. At its end, the contacts that the
  /// kernel did not find are missed ones.
  void show_in(Inspection& seen) const;

  /// The kernel's lines, and what the operation before the cursor did.
  void describe(PageView& page) const;

  /// The sphere whose thread walks along the sorted list; −1 before the sweep and after it.
  int64_t walker() const;

 private:
  bool is_walking() const { return phase().name == "sweep"; }

  lecture::RecordedRun run_;
  size_t at_ = 0;
};

/// The picture of a demonstration with a page's texts around it. `seen` and `page` must live until it is drawn.
FrameView frame_with_page(Demo& demo, const Inspection& seen, PageView& page, float aspect, float text_scale);

}  // namespace ballpit
