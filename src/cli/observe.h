// SPDX-License-Identifier: MIT
// --observe: which observables were asked for, and what they are in a session.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "show/session.h"
#include "world/observables.h"

namespace ballpit {

std::vector<std::string> observable_names();

/// Those of a list "a,b,c", or "all". Throws UserError with those that there are.
std::vector<Observable> parse_observables(const std::string& text);

/// Whether any of them needs Settings::keeps_tally.
bool need_tally(std::span<const Observable> wanted);

/// Value and unit of each by its name; null where there is no value.
nlohmann::ordered_json observe(Session& session, std::span<const Observable> wanted);

/// The same for people: aligned lines, "-" where there is no value.
std::string describe_observed(const nlohmann::ordered_json& observed);

}  // namespace ballpit
