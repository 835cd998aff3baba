// SPDX-License-Identifier: MIT
// Shared options as they were given on the command line, and what is said of them before anything runs.
#pragma once

#include <string>
#include <vector>

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

/// A shared option as given: "--dt" "0.01".
struct GivenOption {
  std::string name;
  std::string value;
};

/// Applies them in their order. Throws UserError naming the option.
void apply_given(Settings& settings, const std::vector<GivenOption>& given);

/// Throws UserError where an option given does not go with the response that the settings name.
void check_given(const Settings& settings, const std::vector<GivenOption>& given);

/// A scene's defaults under what was given. A default that does not go with a response given in place of the scene's own is
/// left out. Throws UserError naming option, or file and line.
Settings combine(const std::vector<DefaultOption>& defaults, const std::vector<GivenOption>& given);

/// Cells smaller than a diameter are allowed, since a lecture shows what they do; but never in silence.
void warn_of_small_cells(const Settings& settings);

}  // namespace ballpit
