// SPDX-License-Identifier: MIT
// Bullet: btDbvtBroadphase, two dynamic trees of boxes that are 0.05 wider than asked for on every side, so that small
// moves cost nothing. Deferred, it searches all pairs on demand; otherwise, whenever a box is added or leaves its
// margin. It keeps all pairs of boxes in a hash table, from which we take those of spheres.
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <btBulletCollisionCommon.h>

#include "peer.h"

namespace ballpit {

namespace {

// Bullet passes over boxes without an object in places, so the first sphere is not null.
void* object_of(size_t i) { return reinterpret_cast<void*>(i + 1); }
size_t index_of(const btBroadphaseProxy* proxy) { return reinterpret_cast<size_t>(proxy->m_clientObject) - 1; }

class BulletPeer : public Peer {
 public:
  explicit BulletPeer(bool deferred) : is_deferred_(deferred) { forget(); }

  void find(const Spheres& spheres) override {
    const SphereTest test(spheres);
    proxies_.reserve(spheres.position.size());
    for (size_t i = 0; i < spheres.position.size(); ++i) {
      const Box box = box_of(test, i);
      proxies_.push_back(
          broadphase_->createProxy(box.low, box.high, SPHERE_SHAPE_PROXYTYPE, object_of(i), 1, 1, &dispatcher_));
    }
    collect(test);
  }

  void update(const Spheres& spheres) override {
    const SphereTest test(spheres);
    for (size_t i = 0; i < spheres.position.size(); ++i) {
      const Box box = box_of(test, i);
      broadphase_->setAabb(proxies_[i], box.low, box.high, &dispatcher_);
    }
    collect(test);
  }

  void forget() override {
    broadphase_ = std::make_unique<btDbvtBroadphase>();
    broadphase_->m_deferedcollide = is_deferred_;
    proxies_.clear();
  }

  std::vector<Pair> pairs() override { return pairs_; }

 private:
  struct Box {
    btVector3 low;
    btVector3 high;
  };

  static Box box_of(const SphereTest& test, size_t i) {
    const Vec3 p = test.position(i);
    const float r = test.radius(i);
    return {{p.x - r, p.y - r, p.z - r}, {p.x + r, p.y + r, p.z + r}};
  }

  void collect(const SphereTest& test) {
    broadphase_->calculateOverlappingPairs(&dispatcher_);
    btOverlappingPairCache& cache = *broadphase_->getOverlappingPairCache();
    const btBroadphasePair* boxes = cache.getOverlappingPairArrayPtr();
    pairs_.clear();
    for (int k = 0; k < cache.getNumOverlappingPairs(); ++k) {
      const size_t i = index_of(boxes[k].m_pProxy0);
      const size_t j = index_of(boxes[k].m_pProxy1);
      if (test.overlap(i, j)) pairs_.push_back(pair_of(i, j));
    }
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  bool is_deferred_;
  std::unique_ptr<btDbvtBroadphase> broadphase_;
  std::vector<btBroadphaseProxy*> proxies_;
  std::vector<Pair> pairs_;
};

std::unique_ptr<Peer> make_at_once(const PeerOptions&) { return std::make_unique<BulletPeer>(false); }
std::unique_ptr<Peer> make_deferred(const PeerOptions&) { return std::make_unique<BulletPeer>(true); }

std::string version() {
  return "Bullet " + std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100);
}

}  // namespace

std::span<const PeerInfo> bullet_peers() {
  static const PeerInfo table[] = {
      {"bullet", version(), "dynamic trees, collided box by box", false, make_at_once},
      {"bullet-deferred", version(), "dynamic trees, collided at the end", false, make_deferred}};
  return table;
}

}  // namespace ballpit
