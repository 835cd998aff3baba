// SPDX-License-Identifier: MIT
// The sections of a scene file, one function each: from a TOML table to a plain value, checked. O(size of the
// section).
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "scene/check_spheres.h"
#include "scene/fill.h"
#include "scene/scene.h"
#include "scene/table_reader.h"

namespace ballpit {

Domain read_domain(const toml::table& table, const std::string& file);
Physics read_physics(const toml::table& table, const std::string& file, int dimensions);
Needs read_needs(const toml::table& table, const std::string& file);

/// Options as they would be typed; whether they exist is for the option table to say.
std::vector<DefaultOption> read_defaults(const toml::table& table, const std::string& file);

/// One [[spheres]] table, appended to `bodies` and `lines`.
void read_sphere(const toml::table& table, const Domain& domain, const Physics& physics, SphereLines& lines,
                 Bodies& bodies);

/// One [[fill]] table. Its region lies within `domain`; an open top has no upper bound.
Fill read_fill(const toml::table& table, const std::string& file, const Domain& domain, const Physics& physics);

}  // namespace ballpit
