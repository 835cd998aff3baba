// SPDX-License-Identifier: MIT
// What the broad phase proposes and what comes of it, as lines between centres.
//
//     o───────o   candidate that does not touch: thin, sky
//     o━━━━━━━o   contact: bold, orange with a dark core
//     ◎═══════◎   contact that the method missed: double, vermillion, a ring around both
//
// Lines of candidates and contacts run before their own two spheres, and behind others; what is missed, over all.
// Cost: proportional to the number of pairs. Above kMostCandidates, candidates are only counted.
#pragma once

#include <vector>

#include "render/overlays/overlay.h"
#include "world/inspection.h"

namespace ballpit {

inline constexpr size_t kMostCandidates = 20000;

/// Candidates that are no contacts, each once.
std::vector<Pair> candidates_apart(const Inspection& inspection);

class PairsOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
