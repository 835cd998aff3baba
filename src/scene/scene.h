// SPDX-License-Identifier: MIT
// A scene is a value: the box, the spheres in it, the physics, and the checks at the end. SI units, y up, double precision;
// the simulation rounds it to its own precision. read_scene() reads it from TOML.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/math.h"

namespace ballpit {

enum class Boundary { walls, open_top, periodic };

/// The box that holds all spheres. In planar scenes z is 0 throughout, also in `min` and `max`.
struct Domain {
  Vec3d min{0.0};  ///< [m]
  Vec3d max{1.0};  ///< [m]
  Boundary boundary = Boundary::walls;
  int dimensions = 3;  ///< 2: a planar scene in x and y
};

/// A part of space, for the camera.
struct Extent {
  Vec3d min, max;  ///< [m]
};

struct Physics {
  Vec3d gravity{0.0};             ///< [m/s²]
  double restitution = 0.8;       ///< sphere–sphere, 0 to 1
  double wall_restitution = 0.8;  ///< sphere–wall, 0 to 1; defaults to `restitution`
  double stiffness = 1e5;         ///< [N/m] penalty response only
  std::string law = "linear";     ///< linear | hertz, penalty response only
  double shear = 0.0;             ///< [kg/s] tangential dashpot, penalty response only
  double initial_overlap = 1e-6;  ///< largest allowed at the start, as a fraction of the smaller radius
  double density = 1000.0;        ///< [kg/m³] mass of spheres that declare none is density · volume

  bool operator==(const Physics&) const = default;
};

/// Spheres as arrays of equal length.
struct Bodies {
  std::vector<Vec3d> position;  ///< [m] z is 0 in planar scenes
  std::vector<Vec3d> velocity;  ///< [m/s]
  std::vector<double> radius;   ///< [m]
  std::vector<double> mass;     ///< [kg]

  /// Makes room for `count` bodies; new ones are all zero.
  void resize(int64_t count) {
    const auto size = static_cast<size_t>(count);
    position.resize(size, Vec3d(0.0));
    velocity.resize(size, Vec3d(0.0));
    radius.resize(size);
    mass.resize(size);
  }

  void reserve(int64_t count) {
    const auto size = static_cast<size_t>(count);
    position.reserve(size);
    velocity.reserve(size);
    radius.reserve(size);
    mass.reserve(size);
  }

  int64_t size() const { return static_cast<int64_t>(position.size()); }
};

/// One entry of [defaults]: an option of the command line, with its place in the file for errors.
struct DefaultOption {
  std::string key;    ///< "broadphase", "dt", …
  std::string value;  ///< as typed after --key
  std::string where;  ///< "file.toml:12: [defaults] broadphase"
};

/// What a scene must show, apart from figures. It rules out methods that cannot show it (docs/choice.md).
enum class Effect {
  resting,         ///< contacts that last
  contact_time,    ///< contacts of finite duration: springs, waves, how a cradle splits
  paths,           ///< where each sphere is, not only statistics
  momentum_order,  ///< one hit after another
  kinematic        ///< motion that only looks plausible is enough
};
inline constexpr std::array<std::string_view, 5> kEffectNames{"resting", "contact-time", "paths", "momentum-order",
                                                              "kinematic"};

/// An entry of [needs.observables].
struct NeededObservable {
  std::string name;   ///< as in the table of observables
  double tolerance;   ///< largest allowed relative error
  std::string where;  ///< "file.toml:12: [needs.observables] pressure", for errors
};

/// What a scene asks for: conditions at the end of a run, which tests check for every built-in scene, and some during
/// it. Tolerances are upper bounds.
struct Needs {
  bool are_declared = false;                 ///< the file has a section [needs]
  double duration = 10.0;                    ///< [s]
  std::optional<double> max_overlap;         ///< largest at the end, as a fraction of the smaller radius
  std::optional<double> max_overlap_ever;    ///< largest during the run, as a fraction of the smaller radius
  std::optional<double> energy_tolerance;    ///< largest allowed |E − E₀| / E₀, above the bottom of the domain
  std::optional<double> momentum_tolerance;  ///< largest allowed |P − P₀| / Σ m·|v₀|
  std::optional<double> max_speed;           ///< [m/s] largest RMS speed allowed at the end
  std::optional<double> path_tolerance;      ///< [radii] largest median distance from the true paths at the end
  std::vector<Effect> effects{};
  std::vector<NeededObservable> observables{};

  bool has(Effect effect) const {
    for (const Effect e : effects) {
      if (e == effect) return true;
    }
    return false;
  }
};

/// The texts of a scene in a list.
struct SceneInfo {
  std::string name;  ///< "bouncing-balls", or the file's stem
  std::string title;
  std::string description;
  std::string title_de;
  std::string description_de;
};

struct Scene : SceneInfo {
  Domain domain;
  Physics physics;
  Bodies bodies;
  std::vector<DefaultOption> defaults;
  std::string because{};  ///< [defaults] because: why these options, where cheaper ones would do
  Needs needs;
  std::optional<Extent> view{};      ///< what fills the picture at first; none: the domain
  uint64_t seed = 1;                 ///< of the random spheres
  std::vector<std::string> notes{};  ///< for the user: "state.csv: 3 of 10 spheres …"
};

}  // namespace ballpit
