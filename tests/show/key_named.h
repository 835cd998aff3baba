// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string_view>

#include "show/demo.h"

namespace ballpit {

/// The key of a demonstration with this name. Throws if there is none.
inline const Key& key_named(std::string_view name) {
  for (const Key& key : key_table()) {
    if (key.name == name) return key;
  }
  throw std::runtime_error("no such key");
}

}  // namespace ballpit
