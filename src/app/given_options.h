// SPDX-License-Identifier: MIT
// Shared options as they were given on the command line, and what is said of them before anything runs.
#pragma once

#include <string>
#include <vector>

#include "simulate/settings.h"

namespace ballpit {

/// A shared option as given: "--dt" "0.01".
struct GivenOption {
  std::string name;
  std::string value;
};

/// Applies them in their order. Throws UserError naming the option.
void apply_given(Settings& settings, const std::vector<GivenOption>& given);

/// Cells smaller than a diameter are allowed, since a lecture shows what they do; but never in silence.
void warn_of_small_cells(const Settings& settings);

}  // namespace ballpit
