// SPDX-License-Identifier: MIT
// CGAL: box_self_intersection_d, streamed segment trees with scanning below a cutoff (Zomorodian, Edelsbrunner 2002).
// It keeps no structure, so an update is a new search; memory stays.
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include "peer.h"

#define QUOTE(text) #text
#define QUOTE_VALUE(macro) QUOTE(macro)

namespace ballpit {

namespace {

/// A model of CGAL's concept BoxIntersectionBox_d.
class Box {
 public:
  using NT = float;
  using ID = int32_t;

  Box(const Vec3& position, float radius, ID body) : low_(position - radius), high_(position + radius), body_(body) {}

  static int dimension() { return 3; }
  ID id() const { return body_; }
  NT min_coord(int axis) const { return low_[axis]; }
  NT max_coord(int axis) const { return high_[axis]; }

 private:
  Vec3 low_;
  Vec3 high_;
  ID body_;
};

class CgalPeer : public Peer {
 public:
  void find(const Spheres& spheres) override {
    const SphereTest test(spheres);
    boxes_.clear();
    boxes_.reserve(spheres.position.size());
    for (size_t i = 0; i < spheres.position.size(); ++i) {
      boxes_.emplace_back(test.position(i), test.radius(i), static_cast<int32_t>(i));
    }
    pairs_.clear();
    const auto test_spheres = [&](const Box& a, const Box& b) {
      if (test.overlap(a.id(), b.id())) pairs_.push_back({a.id(), b.id()});
    };
    CGAL::box_self_intersection_d(boxes_.begin(), boxes_.end(), test_spheres, kCutoff);
  }

  void update(const Spheres& spheres) override { find(spheres); }

  std::vector<Pair> pairs() override { return pairs_; }

 private:
  static constexpr std::ptrdiff_t kCutoff = 100;  // the default of 10 was measured to take up to twice the time

  std::vector<Box> boxes_;
  std::vector<Pair> pairs_;
};

std::unique_ptr<Peer> make_cgal(const PeerOptions&) { return std::make_unique<CgalPeer>(); }

}  // namespace

std::span<const PeerInfo> cgal_peers() {
  static const PeerInfo table[] = {
      {"cgal", "CGAL " QUOTE_VALUE(CGAL_VERSION), "box_self_intersection_d", false, make_cgal}};
  return table;
}

}  // namespace ballpit
