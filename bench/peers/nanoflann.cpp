// SPDX-License-Identifier: MIT
// nanoflann: a k-d tree of the centres, and a search within a radius around each. Only the larger sphere of a pair
// searches for the other, which is then within twice its radius; so small spheres need no large radius. Spheres search
// in the order of the tree's leaves, so that the nodes are in the cache already.
#include <nanoflann.hpp>

#include "peer.h"

namespace ballpit {

namespace {

/// The centres as nanoflann asks for them.
struct Centres {
  std::span<const Vec3> position;

  size_t kdtree_get_point_count() const { return position.size(); }
  float kdtree_get_pt(size_t i, size_t axis) const { return position[i][static_cast<int>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Receives the pairs of one sphere from the search, without a list of neighbours.
struct Neighbours {
  const SphereTest& test;
  std::vector<Pair>& pairs;
  uint32_t body;
  float squared_reach;

  bool full() const { return true; }
  float worstDist() const { return squared_reach; }
  bool addPoint(float squared_distance, uint32_t other) {
    const float r = test.radius(body);
    const float s = test.radius(other);
    const bool is_ours = s < r || (s == r && body < other);
    if (is_ours && squared_distance <= (r + s) * (r + s)) pairs.push_back(pair_of(body, other));
    return true;
  }
};

class NanoflannPeer : public Peer {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Centres>, Centres, 3, uint32_t>;

 public:
  void find(const Spheres& spheres) override {
    centres_.position = spheres.position;
    tree_ = std::make_unique<Tree>(3, centres_, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize));
    tree_->buildIndex();
    search(spheres);
  }

  void update(const Spheres& spheres) override {
    centres_.position = spheres.position;
    tree_->buildIndex();
    search(spheres);
  }

  std::vector<Pair> pairs() override { return pairs_; }

 private:
  static constexpr size_t kLeafSize = 10;

  void search(const Spheres& spheres) {
    const SphereTest test(spheres);
    pairs_.clear();
    for (const uint32_t i : tree_->vAcc) {
      const float r = test.radius(i);
      Neighbours neighbours{test, pairs_, i, 4 * r * r};
      tree_->findNeighbors(neighbours, &test.position(i).x, nanoflann::SearchParams());
    }
  }

  Centres centres_;
  std::unique_ptr<Tree> tree_;
  std::vector<Pair> pairs_;
};

std::unique_ptr<Peer> make_nanoflann(const PeerOptions&) { return std::make_unique<NanoflannPeer>(); }

std::string version() {
  const int v = NANOFLANN_VERSION;  // hexadecimal digits
  return "nanoflann " + std::to_string(v >> 8) + "." + std::to_string(v >> 4 & 15) + "." + std::to_string(v & 15);
}

}  // namespace

std::span<const PeerInfo> nanoflann_peers() {
  static const PeerInfo table[] = {{"nanoflann", version(), "k-d tree, built anew", false, make_nanoflann}};
  return table;
}

}  // namespace ballpit
