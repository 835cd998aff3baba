// SPDX-License-Identifier: MIT
#include "show/kernel_cursor.h"

#include <algorithm>
#include <iterator>

#include "render/overlays/overlay.h"
#include "show/record_text.h"

namespace ballpit {

using lecture::Action;
using lecture::Operation;
using lecture::Phase;

void KernelCursor::step(int operations) {
  at_ =
      static_cast<size_t>(std::clamp<int64_t>(static_cast<int64_t>(at_) + operations, 0, static_cast<int64_t>(last())));
}

void KernelCursor::skip_phase(int phases) {
  if (phases > 0) {
    at_ = run_.phase_at(at_).last;
    return;
  }
  size_t before = 0;
  for (const Phase& phase : run_.phases) {
    if (phase.last < at_) before = phase.last;
  }
  at_ = before;
}

void KernelCursor::show_in(Inspection& seen) const {
  const std::vector<Operation>& operations = run_.record.operations;
  const std::vector<Pair> all = seen.contacts;  // found by the scene's own method
  seen.contacts.clear();
  seen.candidates.clear();
  seen.missed.clear();
  for (size_t k = 0; k < at_; ++k) {
    if (operations[k].action != Action::test) continue;
    const int i = static_cast<int>(operations[k].index), j = operations[k].other;
    const Pair pair{std::min(i, j), std::max(i, j)};
    seen.candidates.push_back(pair);
    if (operations[k].value != 0) seen.contacts.push_back(pair);
  }
  std::ranges::sort(seen.candidates);
  std::ranges::sort(seen.contacts);
  if (at_ == last()) std::ranges::set_difference(all, seen.contacts, std::back_inserter(seen.missed));
  if (run_.grid) {
    seen.grids = {*run_.grid};
    seen.grids[0].head = run_.record.values_after(0, at_);
    seen.grids[0].next = run_.record.values_after(1, at_);
  }
  if (run_.axis < 0) return;
  seen.axis = run_.axis;
  seen.endpoints.clear();
  for (const int entry : run_.record.values_after(0, at_)) {
    if (entry == lecture::kUnset) continue;
    const int i = entry / 2;
    const bool is_end = entry % 2 == 1;
    const float reach = seen.bodies.radius_of(i);
    seen.endpoints.push_back({seen.bodies.position_of(i)[run_.axis] + (is_end ? reach : -reach), i, is_end});
  }
}

void KernelCursor::describe(PageView& page) const {
  const std::vector<Operation>& operations = run_.record.operations;
  const Operation& shown = operations[at_ > 0 ? at_ - 1 : 0];  // done last, or the first one, which comes next
  const CodeExcerpt code = function_at(lecture::kernel_source(run_.kernel), shown.line);
  page.code = code.lines;
  page.walks = is_walking();
  page.has_walked = run_.axis >= 0 && at_ == last();
  if (at_ == 0) return;
  page.line = shown.line - code.first;
  page.step = text_of(run_, at_ - 1);
  if (shown.array < 0) return;
  page.touched_array = run_.record.arrays[static_cast<size_t>(shown.array)].name;
  page.touched_index = shown.index;
  const bool is_changed = shown.action != Action::load && shown.old_value != lecture::kUnset;
  if (is_changed) page.old_text = value_text(run_, shown.old_value);
}

int64_t KernelCursor::walker() const {
  if (run_.axis < 0 || at_ == 0 || at_ == last() || !is_walking()) return -1;
  const Operation& shown = run_.record.operations[at_ - 1];
  return run_.record.values_after(0, at_)[static_cast<size_t>(shown.thread)] / 2;
}

FrameView frame_with_page(Demo& demo, const Inspection& seen, PageView& page, float aspect, float text_scale) {
  const FrameView whole = demo.frame_view(aspect);
  Room room = room_of(page, text_scale, aspect);
  room.below += room_below(whole.overlays, seen, text_scale);
  page.below = room.below;
  const Camera camera = camera_of(demo.view.turned(demo.session.time()), whole.domain, room, aspect);
  return {seen,       whole.domain,   camera, whole.overlays, whole.selected,     whole.coloring,
          whole.step, whole.left_out, false,  &page,          whole.typical_speed};
}

}  // namespace ballpit
