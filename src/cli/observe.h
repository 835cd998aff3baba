// SPDX-License-Identifier: MIT
// --observe: the observables of a session.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "show/session.h"
#include "world/observables.h"

namespace ballpit {

/// Those of a list "a,b,c", or "all". Throws UserError with the names that exist.
std::vector<Observable> parse_observables(const std::string& text);

/// Whether any of them needs Settings::keeps_tally.
bool need_tally(std::span<const Observable> wanted);

struct Observed {
  std::string_view name, unit;
  ObservedValue value;
};

std::vector<Observed> observe(Session& session, std::span<const Observable> wanted);

/// Value and unit of each by name; null if there is no value.
nlohmann::ordered_json json_of(std::span<const Observed> observed);

/// Aligned lines, with "-" if there is no value.
std::string text_of(std::span<const Observed> observed);

}  // namespace ballpit
