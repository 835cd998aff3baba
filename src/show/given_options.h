// SPDX-License-Identifier: MIT
// Settings as options that were given on the command line or in the panel.
#pragma once

#include <string>
#include <vector>

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

/// An option as given: "dt", "0.01".
struct GivenOption {
  std::string name;
  std::string value;
};

/// Applies them in their order. Throws UserError naming the option.
void apply_given(Settings& settings, const std::vector<GivenOption>& given);

/// Throws UserError if an option does not fit the response.
void check_given(const Settings& settings, const std::vector<GivenOption>& given);

/// The scene's defaults, overridden by the options given. If these choose another response, defaults that do not fit it
/// are left out. Throws UserError naming the option, or file and line.
Settings combine(const std::vector<DefaultOption>& defaults, const std::vector<GivenOption>& given);

/// Warns of cells smaller than a diameter. They are allowed because a lecture shows what they do.
void warn_of_small_cells(const Settings& settings);

}  // namespace ballpit
