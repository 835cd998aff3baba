// SPDX-License-Identifier: MIT
// The outcome of a run, as JSON and as text.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "show/session.h"

namespace ballpit {

/// Writes JSON to standard output. Bytes that are not UTF-8, which names of files may hold, are replaced.
void print_json(const nlohmann::ordered_json& json);

/// Name, seconds and launches of each stage.
nlohmann::ordered_json json_of(const std::vector<Stage>& stages);

struct RunSummary {
  std::string scene, backend;
  Settings settings;
  Report report;
};

RunSummary summary_of(Session& session);
nlohmann::ordered_json json_of(const RunSummary& summary);

/// Aligned lines.
std::string text_of(const RunSummary& summary);

}  // namespace ballpit
