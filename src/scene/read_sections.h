// SPDX-License-Identifier: MIT
// The sections of a scene file, one function each: from the reader of the whole file to a checked value. A missing
// section gives the default value. Cost: proportional to the size of the section.
#pragma once

#include "scene/fill.h"
#include "scene/spheres_csv.h"
#include "scene/table_reader.h"

namespace ballpit {

Domain read_domain(const TableReader& root);
Physics read_physics(const TableReader& root, int dimensions);
Needs read_needs(const TableReader& root);

/// What fills the picture at first, [view]; none without that section.
std::optional<Extent> read_view(const TableReader& root, const Domain& domain);

/// Options as text, as on the command line, without `because`. The caller checks whether they exist.
std::vector<DefaultOption> read_defaults(const TableReader& root, std::string_view section = "defaults");

/// Why the scene has these defaults, `because`; empty if it does not say.
std::string read_because(const TableReader& root);

/// Appends the [[spheres]] tables to `scene.bodies`; returns their lines.
SphereLines read_spheres(const TableReader& root, Scene& scene);

/// The [[fill]] tables. Their regions lie within the domain; an open top has no upper bound.
std::vector<Fill> read_fills(const TableReader& root, const Scene& scene);

}  // namespace ballpit
