// SPDX-License-Identifier: MIT
// Steps through the detection of the present moment of a demonstration: the slide's kernel of the chosen method, operation
// by operation. Ends when the demonstration moves on.
#pragma once

#include <optional>

#include "show/kernel_cursor.h"

namespace ballpit {

class Stepping {
 public:
  /// The demonstration must outlive it.
  explicit Stepping(Demo& demo) : demo_(demo) {}

  /// Moves by operations, or by phases; begins if that is new. Where it cannot, the demonstration says why.
  void move(int operations);
  void skip_phase(int phases);
  void end() { cursor_.reset(); }

  /// None while nobody steps.
  const KernelCursor* cursor();

  /// The picture with the kernel beside it; only while somebody steps. Valid until the state changes.
  FrameView frame_view(float aspect);

 private:
  bool begin();

  Demo& demo_;
  std::optional<KernelCursor> cursor_;
  BroadPhase method_{};
  int64_t world_ = -1, step_ = -1;  // at which it began
  Inspection inspection_;
  PageView page_;
};

}  // namespace ballpit
