// SPDX-License-Identifier: MIT
// FCL: DynamicAABBTreeCollisionManager, a tree of boxes that is refitted as they move. Each sphere is an object; its
// pairs of boxes are tested by us, not by FCL's narrow phase, which is general and slower.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/config.h>
#include <fcl/geometry/shape/sphere.h>

#include "peer.h"

namespace ballpit {

namespace {

using Object = fcl::CollisionObject<float>;

class FclPeer : public Peer {
 public:
  void find(const Spheres& spheres) override {
    const SphereTest test(spheres);
    std::shared_ptr<fcl::Sphere<float>> shape;
    std::vector<Object*> pointers;
    objects_.reserve(spheres.position.size());  // FCL keeps their addresses
    for (size_t i = 0; i < spheres.position.size(); ++i) {
      if (!shape || shape->radius != test.radius(i)) shape = std::make_shared<fcl::Sphere<float>>(test.radius(i));
      Object& object = objects_.emplace_back(shape, fcl::Transform3f::Identity());
      object.setUserData(reinterpret_cast<void*>(i));
      place(object, test.position(i));
      pointers.push_back(&object);
    }
    manager_.registerObjects(pointers);
    manager_.setup();
    collide(test);
  }

  void update(const Spheres& spheres) override {
    const SphereTest test(spheres);
    for (size_t i = 0; i < objects_.size(); ++i) place(objects_[i], test.position(i));
    manager_.update();
    collide(test);
  }

  void forget() override {
    manager_.clear();
    objects_.clear();
  }

  std::vector<Pair> pairs() override { return pairs_; }

 private:
  static void place(Object& object, const Vec3& position) {
    object.setTranslation({position.x, position.y, position.z});
    object.computeAABB();
  }

  static size_t index_of(const Object* object) { return reinterpret_cast<size_t>(object->getUserData()); }

  void collide(const SphereTest& test) {
    pairs_.clear();
    test_ = test;
    manager_.collide(this, [](Object* a, Object* b, void* data) {
      auto* self = static_cast<FclPeer*>(data);
      const size_t i = index_of(a);
      const size_t j = index_of(b);
      if (self->test_.overlap(i, j)) self->pairs_.push_back(pair_of(i, j));
      return false;  // go on
    });
  }

  std::vector<Object> objects_;
  fcl::DynamicAABBTreeCollisionManager<float> manager_;
  SphereTest test_;
  std::vector<Pair> pairs_;
};

std::unique_ptr<Peer> make_fcl(const PeerOptions&) { return std::make_unique<FclPeer>(); }

}  // namespace

std::span<const PeerInfo> fcl_peers() {
  static const PeerInfo table[] = {{"fcl", "FCL " FCL_VERSION, "dynamic tree, refitted", false, make_fcl}};
  return table;
}

}  // namespace ballpit
