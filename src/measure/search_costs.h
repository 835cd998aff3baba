// SPDX-License-Identifier: MIT
// Measures what searches cost on this machine, for --broadphase auto: steps of gases at rest, on one thread. It takes
// about a tenth of a second, and is done once for each machine, build, backend and precision. The results are kept in
// $XDG_CACHE_HOME/ballpit/costs.json, or in ~/.cache/ballpit if that variable is not set.
#pragma once

#include "world/world.h"

namespace ballpit {

/// Measured now.
SearchCosts measure_search_costs(const Backend& backend, Precision precision);

/// From the cache, or measured now and kept. `remeasure` replaces what is kept. An unreadable cache counts as empty,
/// and a folder that cannot be written is no error.
SearchCosts search_costs(const Backend& backend, Precision precision, bool remeasure = false);

}  // namespace ballpit
