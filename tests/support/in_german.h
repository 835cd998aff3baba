// SPDX-License-Identifier: MIT
// The program speaks German while an object lives.
#pragma once

#include "core/language.h"

namespace ballpit {

struct InGerman {
  InGerman() { set_language(Language::german); }
  ~InGerman() { set_language(Language::english); }
  InGerman(const InGerman&) = delete;
  InGerman& operator=(const InGerman&) = delete;
};

}  // namespace ballpit
