// SPDX-License-Identifier: MIT
// Texts with figures in the language set. Apart from language.h, since nvcc cannot compile fmt.
#pragma once

#include <fmt/format.h>

#include "core/language.h"

namespace ballpit {

/// An English text with arguments in the language set: phrase("{} of {} spheres", 3, 5).
template <class... Args>
std::string phrase(std::string_view english, const Args&... args) {
  return fmt::format(fmt::runtime(translated(english)), args...);
}

}  // namespace ballpit
