// SPDX-License-Identifier: MIT
#include <numeric>

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/scenes.h"
#include "world/inspect_more.h"

using namespace ballpit;

namespace {

template <class V>
Collider<V, CpuExecutor> planned_collider(const Way& way, const BodyArrays<V>& bodies) {
  const Settings settings = settings_of(way);
  Collider<V, CpuExecutor> collider;
  collider.plan({named<BroadPhase>(way.broadphase), ""}, bodies.parameters(settings), way.skin);
  return collider;
}

}  // namespace

TEST_CASE("thread_work adds up to the candidates, except where threads walk lists") {
  for (const Input& input : inputs()) {
    const Scene scene = input.make(51);
    const auto check = [&]<class V>(const BodyArrays<V>& bodies) {
      for (const Way& way : ways(kDimensions<V>)) {
        if (way.broadphase.starts_with("lecture/") || way.broadphase == "auto") continue;
        CpuExecutor exec(way.threads);
        auto found = planned_collider(way, bodies);
        found.pairs(exec, bodies.view());
        const std::vector<int> work = thread_work(exec, found).first;
        INFO(input.name << ", " << way);
        REQUIRE(work.size() == bodies.position.size());
        REQUIRE(std::accumulate(work.begin(), work.end(), int64_t{0}) == found.tests(exec));
      }
    };
    scene.domain.dimensions == 2 ? check(BodyArrays<Vec2>(scene)) : check(BodyArrays<Vec3>(scene));
  }
}

TEST_CASE("in brute force each thread has one candidate less than the one before") {
  const BodyArrays<Vec3> bodies(make_cloud({.count = 5}, 1));
  CpuExecutor exec(1);
  auto found = planned_collider({.broadphase = "brute-force"}, bodies);
  found.pairs(exec, bodies.view());
  CHECK(thread_work(exec, found).first == std::vector<int>{4, 3, 2, 1, 0});
}
