// SPDX-License-Identifier: MIT
// What commands print: the figures and observables of a run, as JSON and as aligned lines of text.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "show/session.h"
#include "world/observer.h"

namespace ballpit {

/// Writes one of both to standard output. Bytes that are not UTF-8, as in names of files, are replaced in JSON.
void print(bool as_json, const nlohmann::ordered_json& json, const std::string& text);

/// Name, seconds and launches of each stage.
nlohmann::ordered_json json_of(const std::vector<Stage>& stages);

/// Settings, and the report of the present state.
nlohmann::ordered_json json_of(Session& session);
std::string text_of(Session& session);

/// What --response auto has chosen, and the changes since: `choice` of ballpit choose, and `steps_up`.
nlohmann::ordered_json json_of_choice(Session& session, std::string_view scene);

/// The observables of a list "a,b,c", or "all". Throws UserError with the names that exist.
std::vector<Observable> parse_observables(const std::string& text);

/// Whether any of them needs Settings::keeps_tally.
bool need_tally(std::span<const Observable> wanted);

struct Observed {
  std::string_view name, unit;
  ObservedValue value;
};

std::vector<Observed> observe(Session& session, const Observer& observer, std::span<const Observable> wanted);

/// Value and unit of each by name; null, or "-", if there is no value.
nlohmann::ordered_json json_of(std::span<const Observed> observed);
std::string text_of(std::span<const Observed> observed);

}  // namespace ballpit
