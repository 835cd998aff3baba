// SPDX-License-Identifier: MIT
// Acts: what a hand does to the spheres of a run, between two steps. A file of acts is TOML:
//
//     [[act]]
//     time = 0.5           # [s] takes effect at the end of the first step that ends then or later
//     act = "throw"        # throw: the sphere gets the velocity `vector`     [m/s]
//     sphere = 3           # push:  the sphere and all within `reach` of it   [m/s], added to what they have
//     vector = [1, 2, 0]   # drop:  a new sphere at rest appears at `vector`  [m]
//
// How acts are applied: world/acts.h.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace ballpit {

enum class ActKind { to_throw, push, drop };
inline constexpr std::array<std::string_view, 3> kActNames{"throw", "push", "drop"};

struct Act {
  double time = 0;  ///< [s]
  ActKind kind = ActKind::to_throw;
  int64_t sphere = -1;  ///< drop: the number that the new sphere gets
  Vec3d vector{0.0};    ///< [m/s]; drop: [m] the centre
  double reach = 0;     ///< push: [m] from centre to centre
  double radius = 0;    ///< drop: [m]
  double mass = 0;      ///< drop: [kg]

  bool operator==(const Act&) const = default;
};

/// How far a push reaches, in radii of its sphere, where nothing else is said.
inline constexpr double kHandful = 4;

/// A sphere such as most of these: radius and mass of the one in the middle by radius. Without any, a twentieth of the
/// domain's shortest edge, and the scene's density.
struct SphereSize {
  double radius, mass;  ///< [m], [kg]
};
SphereSize typical_sphere(const Scene& scene, const Bodies& bodies);

/// Whether a sphere at p is inside of all walls. In a periodic domain, whether its centre is inside.
bool fits_inside(const Domain& domain, const Vec3d& p, double radius);

/// The acts in a file, in order of time, for a scene that begins with these bodies. Throws UserError with file, line and
/// key for a mistake, also where an act does not fit the scene.
std::vector<Act> read_acts(const std::filesystem::path& path, const Scene& scene, const Bodies& bodies);

/// The text of such a file, from which the same acts are read to the bit. `comment` has whole lines.
std::string text_of(const std::vector<Act>& acts, int dimensions, std::string_view comment);

}  // namespace ballpit
