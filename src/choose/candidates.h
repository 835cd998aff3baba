// SPDX-License-Identifier: MIT
// What can be chosen: a table of variants of the responses, each with a ladder of steps. A rung is √2 finer than the
// one before it. All are fractions of the scene's duration, so that they change with its unit of time.
//
//     rung        0        1        2        3     …
//     steps      60       85      120      170     …   of the scene's duration
#pragma once

#include <span>

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

struct Variant {
  std::string_view name;  ///< "impulse, swept"
  Response response;
  void (*apply)(Settings&);  ///< sets what distinguishes it
  double work;               ///< of a step, relative to that of one iteration of impulses; only to try cheap ones first
};

std::span<const Variant> variants();

inline constexpr int kRungs = 44;

/// Whether an option of this name is among those given.
bool is_given(const std::vector<GivenOption>& given, std::string_view name);

/// The program's settings with those of the scene's [defaults] that bound a run, and the options that are given.
Settings base_settings(const Scene& scene, const std::vector<GivenOption>& given);

/// The settings of a variant at a rung, with the options that are given. Empty if these exclude the variant or, since a
/// step is given, the rung.
std::optional<Settings> settings_at(const Variant& variant, int rung, const Settings& base,
                                    const std::vector<GivenOption>& given, double duration);

/// The options that make these settings of a scene with these defaults, for the command line: those that the response
/// and its search use, without what is the program's default and not the scene's.
std::vector<GivenOption> options_of(const Settings& settings, const std::vector<DefaultOption>& defaults);

/// "--response impulse --dt 0.01".
std::string typed(const std::vector<GivenOption>& options);

}  // namespace ballpit
