// SPDX-License-Identifier: MIT
// Pair searches on CUDA find what they find on the CPU, by the same work.
#include <algorithm>
#include <ostream>

#include <catch2/catch.hpp>

#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

struct Input {
  std::string name;
  Cloud cloud;
};

const std::vector<Input>& families() {
  static const std::vector<Input> all{
      {"sparse", {.count = 260, .smallest = 0.04, .largest = 0.04}},
      {"dense", {.count = 260, .smallest = 0.12, .largest = 0.12}},
      {"polydisperse", {.count = 260, .smallest = 0.01, .largest = 0.2}},
      {"planar", {.count = 260, .dimensions = 2, .smallest = 0.05, .largest = 0.05}},
      {"planar, polydisperse", {.count = 260, .dimensions = 2, .smallest = 0.01, .largest = 0.2}},
      {"clustered", {.count = 260, .smallest = 0.03, .largest = 0.03, .clusters = 4}},
      {"far from the origin", {.count = 260, .low = -107.0, .high = -105.0, .smallest = 0.1, .largest = 0.1}},
      {"touching exactly", {.count = 260, .smallest = 0.125, .largest = 0.125, .snap = 0.25}},
      {"coincident", {.count = 60, .smallest = 0.1, .largest = 0.2, .snap = 4.0}},
      {"none", {.count = 0}},
      {"one", {.count = 1}},
      {"two", {.count = 2, .smallest = 1.0, .largest = 1.0}},
  };
  return all;
}

/// The spheres of a cloud in arrays, as their owner keeps them.
struct Spheres {
  std::vector<Vec3> position;
  std::vector<float> radius;

  explicit Spheres(const Cloud& cloud, uint64_t seed = 3) {
    const Scene scene = make_cloud(cloud, seed);
    position.assign(scene.bodies.position.begin(), scene.bodies.position.end());
    radius.assign(scene.bodies.radius.begin(), scene.bodies.radius.end());
    if (cloud.smallest == cloud.largest && cloud.count > 0) radius = {static_cast<float>(cloud.largest)};
  }
  SphereArrays arrays() const {
    return {{position.data(), static_cast<int64_t>(position.size())},
            {radius.data(), static_cast<int64_t>(radius.size())}};
  }
};

/// The same search on both processors.
struct Twins {
  std::unique_ptr<PairSearch> cpu, cuda;

  explicit Twins(const Settings& settings)
      : cpu(cpu_backend().make_pair_search(settings)), cuda(cuda_backend().make_pair_search(settings)) {}

  /// Searches on both and compares everything but the time; returns the number of pairs.
  size_t find(const Spheres& spheres) const {
    cpu->find(spheres.arrays());
    cuda->find(spheres.arrays());
    const SearchReport expected = cpu->report(), report = cuda->report();
    CHECK(report.method == expected.method);
    CHECK(report.reason == expected.reason);
    CHECK(report.searches == expected.searches);
    CHECK(report.candidates == expected.candidates);
    CHECK(report.contacts == expected.contacts);
    CHECK(cuda->work_per_thread() == cpu->work_per_thread());
    const std::vector<Pair> pairs = cpu->pairs();
    CHECK(cuda->pairs() == pairs);
    return pairs.size();
  }
};

}  // namespace

namespace ballpit {
std::ostream& operator<<(std::ostream& out, const Pair& pair) { return out << "(" << pair.i << ", " << pair.j << ")"; }
}  // namespace ballpit

TEST_CASE("pair searches on CUDA find the CPU's pairs by the CPU's candidates, by every method on every family") {
  struct Method {
    std::string name, table;
  };
  const auto method =
      GENERATE(Method{"brute-force", "auto"}, Method{"sort-and-sweep", "auto"}, Method{"linked-cell", "dense"},
               Method{"linked-cell", "hashed"}, Method{"sorted-grid", "dense"}, Method{"sorted-grid", "hashed"},
               Method{"lecture/brute-force", "auto"}, Method{"lecture/sort-and-sweep", "auto"},
               Method{"lecture/linked-cell", "auto"});
  Settings settings;
  settings.broadphase = named<BroadPhase>(method.name);
  settings.table = named<CellTable>(method.table);
  settings.threads = 2;
  const Twins searches(settings);  // one for all families: what one leaves in memory must not show in the next
  for (const Input& family : families()) {
    INFO(method.name << ", " << method.table << ", " << family.name);
    const size_t pairs = searches.find(Spheres(family.cloud));
    if (family.cloud.count > 1) CHECK(pairs > 0);
  }
}

TEST_CASE("the slides' kernels on CUDA find the pairs that the fast methods find on the CPU") {
  for (const std::string method : {"brute-force", "sort-and-sweep", "linked-cell"}) {
    Settings fast, slides;
    fast.broadphase = named<BroadPhase>(method);
    slides.broadphase = named<BroadPhase>("lecture/" + method);
    const auto on_cpu = cpu_backend().make_pair_search(fast);
    const auto on_cuda = cuda_backend().make_pair_search(slides);
    for (const Input& family : families()) {
      INFO(method << ", " << family.name);
      const Spheres spheres(family.cloud);
      on_cpu->find(spheres.arrays());
      on_cuda->find(spheres.arrays());
      CHECK(on_cuda->pairs() == on_cpu->pairs());
    }
  }
}

TEST_CASE("the sweep on CUDA goes along the axis that it is given") {
  Settings settings;
  settings.broadphase = BroadPhase::sort_and_sweep;
  settings.axis = named<SweepAxis>(GENERATE("x", "y", "z"));
  const Twins searches(settings);
  for (const Input& family : families()) {
    INFO("axis " << name_of(settings.axis) << ", " << family.name);
    searches.find(Spheres(family.cloud));
  }
}

TEST_CASE("cells of other sizes on CUDA give the CPU's candidates, also those too small to find every pair") {
  Settings settings;
  settings.broadphase = named<BroadPhase>(GENERATE("linked-cell", "sorted-grid"));
  settings.cell_size = GENERATE(0.5, 1.5, 4.0);
  const Twins searches(settings);
  CAPTURE(name_of(settings.broadphase), *settings.cell_size);
  searches.find(Spheres({.count = 260, .smallest = 0.08, .largest = 0.12}));
  searches.find(Spheres({.count = 260, .dimensions = 2, .smallest = 0.05, .largest = 0.05}));
}

TEST_CASE("a pair search on CUDA keeps its candidate list as long as the CPU does") {
  Settings settings;
  settings.broadphase = named<BroadPhase>(GENERATE("sorted-grid", "linked-cell"));
  settings.skin = 0.2;
  const Twins searches(settings);
  Spheres spheres({.count = 200, .smallest = 0.08, .largest = 0.12});
  Random random(12);
  for (int k = 0; k < 6; ++k) {
    CAPTURE(name_of(settings.broadphase), k);
    CHECK(searches.find(spheres) > 20);
    for (Vec3& p : spheres.position) p += Vec3(0.006 * random.uniform() * random.direction(3));
  }
  CHECK(searches.cuda->report().searches < 6);
  CHECK(searches.cuda->report().searches > 1);
}

TEST_CASE("many spheres in lists are sorted by place on CUDA as on the CPU, and named as they came") {
  Settings settings;
  settings.broadphase = BroadPhase::linked_cell;
  const Twins searches(settings);
  CHECK(searches.find(Spheres({.count = 16500, .smallest = 0.015, .largest = 0.03})) > 1000);
  const std::vector<Stage> stages = searches.cuda->report().stages;
  CHECK(std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.name == "name bodies"; }));
  searches.find(Spheres({.count = 100, .smallest = 0.1, .largest = 0.1}));
}

TEST_CASE("auto chooses on CUDA as on the CPU, and changes its choice with the spheres") {
  Settings settings;
  settings.broadphase = BroadPhase::automatic;
  const Twins searches(settings);
  searches.find(Spheres({.count = 30, .smallest = 0.1, .largest = 0.1}));
  const std::string few = searches.cuda->report().method;
  searches.find(Spheres({.count = 3000, .smallest = 0.02, .largest = 0.02}));
  CHECK(searches.cuda->report().method != few);
  searches.find(Spheres({.count = 30, .smallest = 0.1, .largest = 0.1}));
  CHECK(searches.cuda->report().method == few);
}

TEST_CASE("a row of very many contacts is sorted on CUDA as on the CPU", "[sanitized]") {
  // One large sphere among small ones: a row longer than is kept, and long enough to be sorted by a heap.
  Spheres spheres({.count = 150, .smallest = 0.01, .largest = 0.02});
  spheres.position.insert(spheres.position.begin() + 20, Vec3(0.0f));
  spheres.radius.insert(spheres.radius.begin() + 20, 1.0f);
  for (const std::string method : {"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid", "lecture/brute-force",
                                   "lecture/sort-and-sweep", "lecture/linked-cell"}) {
    CAPTURE(method);
    Settings settings;
    settings.broadphase = named<BroadPhase>(method);
    CHECK(Twins(settings).find(spheres) > 60);
  }
}
