// SPDX-License-Identifier: MIT
// Embree: rtcCollide of a scene with itself, the spheres being user geometry. It reports boxes of primitives that
// overlap, every pair twice and every primitive with itself; build and collision use as many threads as asked for.
// Build quality LOW is its fast builder (Morton codes), meant for scenes that change at every step.
#include <embree3/rtcore.h>
#include <tbb/enumerable_thread_specific.h>

#include "core/error.h"
#include "peer.h"

namespace ballpit {

namespace {

class EmbreePeer : public Peer {
 public:
  explicit EmbreePeer(const PeerOptions& options) {
    const std::string threads = std::to_string(options.threads);
    device_ = rtcNewDevice(("threads=" + threads + ",user_threads=" + threads).c_str());
    check();
  }
  EmbreePeer(const EmbreePeer&) = delete;
  EmbreePeer& operator=(const EmbreePeer&) = delete;
  ~EmbreePeer() override {
    forget();
    rtcReleaseDevice(device_);
  }

  void forget() override {
    if (geometry_) rtcReleaseGeometry(geometry_);
    if (scene_) rtcReleaseScene(scene_);
    geometry_ = nullptr;
    scene_ = nullptr;
  }

  void find(const Spheres& spheres) override {
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(spheres.count()));
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(geometry_, bounds, nullptr);
    rtcAttachGeometry(scene_, geometry_);
    update(spheres);
  }

  void update(const Spheres& spheres) override {
    test_ = SphereTest(spheres);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    for (std::vector<Pair>& list : lists_) list.clear();
    rtcCollide(scene_, scene_, collide, this);
    check();
  }

  std::vector<Pair> pairs() override {
    std::vector<Pair> all;
    for (const std::vector<Pair>& list : lists_) all.insert(all.end(), list.begin(), list.end());
    return all;
  }

 private:
  void check() const {
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw RunError("Embree", "reports an error");
  }

  static void bounds(const RTCBoundsFunctionArguments* arguments) {
    const SphereTest& test = static_cast<const EmbreePeer*>(arguments->geometryUserPtr)->test_;
    const Vec3 p = test.position(arguments->primID);
    const float r = test.radius(arguments->primID);
    RTCBounds& box = *arguments->bounds_o;
    box.lower_x = p.x - r;
    box.lower_y = p.y - r;
    box.lower_z = p.z - r;
    box.upper_x = p.x + r;
    box.upper_y = p.y + r;
    box.upper_z = p.z + r;
  }

  static void collide(void* user, RTCCollision* collisions, unsigned count) {
    auto* self = static_cast<EmbreePeer*>(user);
    std::vector<Pair>& list = self->lists_.local();
    for (const RTCCollision& c : std::span(collisions, count)) {
      if (c.primID0 < c.primID1 && self->test_.overlap(c.primID0, c.primID1)) {
        list.push_back(pair_of(c.primID0, c.primID1));
      }
    }
  }

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  SphereTest test_;
  tbb::enumerable_thread_specific<std::vector<Pair>> lists_;
};

std::unique_ptr<Peer> make_embree(const PeerOptions& options) { return std::make_unique<EmbreePeer>(options); }

}  // namespace

std::span<const PeerInfo> embree_peers() {
  static const PeerInfo table[] = {
      {"embree", "Embree " RTC_VERSION_STRING, "bounding volume hierarchy, built anew", true, make_embree}};
  return table;
}

}  // namespace ballpit
