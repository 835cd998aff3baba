// SPDX-License-Identifier: MIT
// The contract of all broad phases (parameters.h), looked at where it is made: over all bodies each pair is a candidate
// at most once, in contact or not, and every pair in contact is one.
#include <numeric>

#include <catch2/catch.hpp>

#include "narrow_phase/collider.h"
#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// How often each pair is a candidate.
class PairCounts {
 public:
  explicit PairCounts(int bodies) : bodies_(bodies), times_(size_t(bodies) * bodies, 0) {}

  void add(int a, int b) { ++times_[size_t(std::min(a, b)) * bodies_ + std::max(a, b)]; }
  int of(const Pair& pair) const { return times_[size_t(pair.i) * bodies_ + pair.j]; }
  int most() const { return times_.empty() ? 0 : *std::max_element(times_.begin(), times_.end()); }
  friend bool operator==(const PairCounts&, const PairCounts&) = default;

 private:
  int bodies_;
  std::vector<int> times_;
};

/// Adds the candidates in a range for a slot.
template <class V>
void add_range(const SlotsView<V>& slots, int slot, const SlotRange& range, PairCounts& counts) {
  for (int s = range.first; s < range.last; ++s) {
    if (slots.matches_tag(s, range)) counts.add(slots.body[slot], slots.body[s]);
  }
}

template <class Candidates>
PairCounts count_by_thread(const Candidates& candidates, int bodies) {
  PairCounts counts(bodies);
  if constexpr (GivesRanges<Candidates>) {
    for (int t = 0; t < candidates.threads(); ++t) {
      const int slot = candidates.slot_of(t);
      if (slot < 0) continue;
      candidates.for_each_range(slot,
                                [&](const SlotRange& range) { add_range(candidates.slots(), slot, range, counts); });
    }
  } else {
    for (int i = 0; i < bodies; ++i) {
      candidates.for_each(i, [&](int j) {
        counts.add(i, j);
        return true;
      });
    }
  }
  return counts;
}

/// The same as the CPU takes them, block by block.
template <class Candidates>
PairCounts count_by_block(const Candidates& candidates, int bodies, int block) {
  PairCounts counts(bodies);
  for (int from = 0; from < bodies; from += block) {
    const int to = std::min(bodies, from + block);
    candidates.for_each_range_of(from, to, [&](int slot, const SlotRange& range) {
      REQUIRE((from <= slot && slot < to));
      add_range(candidates.slots(), slot, range, counts);
    });
  }
  return counts;
}

template <class Method, class V>
void check(const BodyArrays<V>& bodies, const BroadPhaseParameters<V>& parameters, const std::vector<Pair>& contacts) {
  CpuExecutor exec(1);
  Method method(parameters);
  method.prepare(exec, bodies.view());
  const auto candidates = method.candidates();
  const PairCounts counts = count_by_thread(candidates, bodies.count());
  REQUIRE(counts.most() <= 1);
  REQUIRE(std::all_of(contacts.begin(), contacts.end(), [&](const Pair& pair) { return counts.of(pair) == 1; }));
  if constexpr (GivesRanges<decltype(candidates)>) {
    for (const int block : {1, 5, 64, 100, 2000}) {
      INFO("blocks of " << block);
      REQUIRE((count_by_block(candidates, bodies.count(), block) == counts));
    }
  }
}

template <class V>
void check_all(const Scene& scene) {
  const BodyArrays<V> bodies(scene);
  const std::vector<Pair> contacts = pairs_by_definition(scene);
  const std::vector<Vec3> points = spheres_of(scene).position;
  const double occupied = occupied_volume(bodies.box, {points.data(), bodies.count()});
  for (const char* const table : {"auto", "dense", "hashed"}) {
    INFO("table " << table);
    auto parameters = bodies.parameters(settings_of({.table = table}));
    for (const double volume : {0.0, occupied}) {
      INFO("occupied volume " << volume);
      parameters.occupied_volume = volume;
      check<SortedGrid<V, CpuExecutor>>(bodies, parameters, contacts);
    }
    check<LinkedCell<V, CpuExecutor>>(bodies, parameters, contacts);
  }
  const auto parameters = bodies.parameters(settings_of({}));
  check<BruteForce<V, CpuExecutor>>(bodies, parameters, contacts);
  for (int axis = -1; axis < kDimensions<V>; ++axis) {
    INFO("axis " << axis);
    auto along = parameters;
    along.axis = axis;
    check<SortAndSweep<V, CpuExecutor>>(bodies, along, contacts);
  }
}

void check_scene(const Scene& scene) { scene.domain.dimensions == 2 ? check_all<Vec2>(scene) : check_all<Vec3>(scene); }

}  // namespace

TEST_CASE("each pair is a candidate at most once, and each contact is one, by threads and by blocks", "[slow]") {
  for (const Input& input : inputs()) {
    for (uint64_t seed = 31; seed <= 32; ++seed) {
      INFO(input.name << ", seed " << seed);
      check_scene(input.make(seed));
    }
  }
}

TEST_CASE("tables of few buckets, shared by many cells, give no pair twice") {
  // With two to ten spheres a hashed table has 8 to 32 buckets: the 9 or 27 cells of a block meet again and again.
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    Random random(seed);
    Cloud cloud{.count = 2 + static_cast<int>(random.bits() % 9),
                .dimensions = 2 + static_cast<int>(random.bits() % 2)};
    cloud.boundary = seed % 3 == 0 ? Boundary::periodic : (seed % 3 == 1 ? Boundary::walls : Boundary::open_top);
    cloud.smallest = random.uniform(0.02, 0.3);
    cloud.largest = cloud.smallest * (seed % 2 == 0 ? 1.0 : random.uniform(1, 20));
    cloud.above = seed % 3 == 2 ? 3 : 0;
    INFO("seed " << seed << ", " << cloud.count << " spheres, dimensions " << cloud.dimensions);
    check_scene(make_cloud(cloud, seed));
  }
}

TEST_CASE("size classes with hashed cells are searched together with classes whose cells are not") {
  // Few small spheres in a domain of many small cells, and enough large ones for theirs.
  for (const int dimensions : {2, 3}) {
    Scene scene =
        make_cloud({.count = 150, .dimensions = dimensions, .low = 0, .high = 2, .smallest = 0.1, .largest = 0.12}, 3);
    const Scene small = make_cloud(
        {.count = 150, .dimensions = dimensions, .low = 0, .high = 2, .smallest = 0.004, .largest = 0.005}, 4);
    for (size_t i = 0; i < 150; ++i) add_sphere(scene, small.bodies.position[i], Vec3d(0.0), small.bodies.radius[i]);
    const auto is_mixed = [&]<class V>(const BodyArrays<V>& bodies) {
      const auto grids = SortedGrid<V, CpuExecutor>(bodies.parameters({})).candidates().grids;
      return grids.count == 2 && !grids.grid[0].is_hashed && grids.grid[1].is_hashed;
    };
    CHECK((dimensions == 2 ? is_mixed(BodyArrays<Vec2>(scene)) : is_mixed(BodyArrays<Vec3>(scene))));
    check_scene(scene);
  }
}

TEST_CASE("no bodies give no candidates, and one body none") {
  for (const int count : {0, 1}) {
    for (const int dimensions : {2, 3}) check_scene(make_cloud({.count = count, .dimensions = dimensions}, 1));
  }
}
