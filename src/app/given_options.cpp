// SPDX-License-Identifier: MIT
#include "app/given_options.h"

#include <iostream>

namespace ballpit {

void apply_given(Settings& settings, const std::vector<GivenOption>& given) {
  for (const GivenOption& option : given) apply_setting(settings, option.name, option.value, "--" + option.name);
}

void warn_of_small_cells(const Settings& settings) {
  if (settings.cell_size && *settings.cell_size < 1) {
    std::cerr << "ballpit: warning: --cell-size " << *settings.cell_size
              << " is below 1: the block of cells around a sphere does not reach all that touch it, so "
                 "contacts are "
                 "missed\n";
  }
}

}  // namespace ballpit
