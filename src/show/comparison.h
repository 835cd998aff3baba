// SPDX-License-Identifier: MIT
// Broad phases side by side: a picture with a view for each method, of the same scene at the same time.
//
//     ┌─────────────────────────────────────────┐
//     │ scene's title, spheres, time            │
//     ├────────────────────┬────────────────────┤
//     │ ○ Brute force      │ □ Linked cell      │   each view is a demonstration of its own (Demo::compare()), so that
//     │                    │                    │   a method that misses contacts is shown as it is
//     │ scene              │ scene              │
//     │ tests, contacts    │ tests, contacts    │
//     └────────────────────┴────────────────────┘
#pragma once

#include <string>
#include <vector>

#include "methods/choices.h"
#include "render/frame_view.h"
#include "render/page_view.h"
#include "show/options.h"

namespace ballpit {

inline constexpr size_t kMaxCompared = 4;

/// "brute-force,linked-cell": two to four different broad phases. Throws UserError naming --compare.
std::vector<BroadPhase> parse_comparison(const std::string& text);

/// Throws UserError if these options do not go with a comparison: another broad phase, or a response that needs none.
/// `with`: "with --compare".
void check_compared(const std::vector<GivenOption>& given, std::string_view with = "with --compare");

/// The options with another broad phase.
std::vector<GivenOption> with_broad_phase(std::vector<GivenOption> given, BroadPhase method);

/// Throws UserError naming --size if so many views are too small in a picture of this size.
void check_views_fit(PictureSize size, size_t views);

/// The parts of a picture that lie beside each of `count` views of a domain. They have as many columns and rows as show
/// the domain largest. `aspect` is the picture's, `above` the part of its height that is left free.
std::vector<Room> view_rooms(size_t count, const DomainBox& domain, float aspect, float above);

MethodSign sign_of(BroadPhase method);

}  // namespace ballpit
