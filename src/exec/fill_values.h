// SPDX-License-Identifier: MIT
#pragma once

#include "core/span.h"

namespace ballpit {

/// Kernel: element i = value.
template <class T>
struct FillValues {
  static constexpr bool kIsElementwise = true;
  Span<T> span;
  T value;
  void operator()(int i) const { span[i] = value; }
};

}  // namespace ballpit
