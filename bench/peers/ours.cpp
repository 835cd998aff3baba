// SPDX-License-Identifier: MIT
// Our own search on the CPU. Unlike the others it sorts its pairs.
#include "compare.h"
#include "peer.h"
#include "world/world.h"

namespace ballpit {

namespace {

class OurPeer : public Peer {
 public:
  explicit OurPeer(const PeerOptions& options) {
    Settings settings;
    settings.broadphase = named<BroadPhase>(options.broadphase);
    settings.threads = options.threads;
    settings.skin = options.skin;
    search_ = cpu_backend().make_pair_search(settings);
  }

  /// Without a skin it starts anew each time.
  void find(const Spheres& spheres) override { search_->find(arrays_of(spheres)); }
  void update(const Spheres& spheres) override { search_->find(arrays_of(spheres)); }

  std::vector<Pair> pairs() override { return search_->pairs(); }

 private:
  std::unique_ptr<PairSearch> search_;
};

std::unique_ptr<Peer> make_ours(const PeerOptions& options) { return std::make_unique<OurPeer>(options); }

}  // namespace

PeerInfo ours() { return {"ballpit", "Ballpit", "pair search on the CPU", true, make_ours}; }

}  // namespace ballpit
