// SPDX-License-Identifier: MIT
// Shows the candidates of the broad phase and which of them are contacts, as lines between centres.
//
//     o───────o   candidate that does not touch: thin, sky
//     o━━━━━━━o   contact: bold, orange with a dark core
//     ◎═══════◎   contact that the method missed: double, vermillion, a ring around both
//
// Lines of candidates and contacts are in front of their own two spheres and behind others; those of missed contacts are in
// front of everything. Cost: proportional to the number of pairs. More than kMaxCandidates candidates are only counted.
#pragma once

#include <vector>

#include "render/frame_view.h"
#include "render/painter.h"
#include "world/inspection.h"

namespace ballpit {

inline constexpr size_t kMaxCandidates = 20000;

/// The candidates that are not contacts, each once.
std::vector<Pair> candidates_apart(const Inspection& inspection);

void draw_pairs(const FrameView& view, Painter& painter);

}  // namespace ballpit
