// SPDX-License-Identifier: MIT
#include "peer.h"

namespace ballpit {

// peers.inc is written by CMake: a line PEER(name) for each library found.
#define PEER(name) std::span<const PeerInfo> name##_peers();
#include "peers.inc"
#undef PEER

std::span<const PeerInfo> peer_table() {
  static const std::vector<PeerInfo> table = [] {
    std::vector<PeerInfo> all;
#define PEER(name) \
  for (const PeerInfo& info : name##_peers()) all.push_back(info);
#include "peers.inc"
#undef PEER
    return all;
  }();
  return table;
}

}  // namespace ballpit
