// SPDX-License-Identifier: MIT
// A choice as JSON. It depends on measured times, so a run writes it down, and runs that must have the same bits
// (--resume) read it again: the settings, and those to go on with where they do not hold.
#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "choose/choose.h"

namespace ballpit {

/// `name` is the scene as it was named, a name or a path.
nlohmann::ordered_json json_of(const Choice& choice, std::string_view name, const Scene& scene,
                               const std::vector<GivenOption>& given);

/// What a run that goes on needs of it: settings, and the largest overlap of its pilot.
Choice read_choice(const std::filesystem::path& path, const Scene& scene, const std::vector<GivenOption>& given);

}  // namespace ballpit
