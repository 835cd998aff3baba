// SPDX-License-Identifier: MIT
// A world's report as JSON and as text.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/session.h"

namespace ballpit {

/// Name, seconds and launches of each stage.
nlohmann::ordered_json list_stages(const std::vector<Stage>& stages);

/// Scene, methods, time, candidates, contacts, energies, momentum, overlap, hash, and the time of each stage.
nlohmann::ordered_json summarize(Session& session);

/// The same for people: a few aligned lines.
std::string describe(const nlohmann::ordered_json& summary);

}  // namespace ballpit
