// SPDX-License-Identifier: MIT
// A world's report as JSON and as text.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "show/session.h"

namespace ballpit {

/// Writes JSON to standard output, as what `--json` promises. Bytes that are no UTF-8, as names of files may hold, are replaced.
void print_json(const nlohmann::ordered_json& json);

/// Name, seconds and launches of each stage.
nlohmann::ordered_json list_stages(const std::vector<Stage>& stages);

/// Scene, methods, time, candidates, contacts, energies, momentum, overlap, hash, and the time of each stage.
nlohmann::ordered_json summarize(Session& session);

/// The same for people: a few aligned lines.
std::string describe(const nlohmann::ordered_json& summary);

}  // namespace ballpit
