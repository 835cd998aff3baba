// SPDX-License-Identifier: MIT
#include <numeric>

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "narrow_phase/vector_search.h"
#include "tests/support/body_arrays.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// All pairs that a list with a wide skin would hold, with their rows.
struct List {
  std::vector<Pair> pairs;
  std::vector<int> first;

  List(Scene scene, double factor) : first(static_cast<size_t>(scene.bodies.size()) + 1, 0) {
    for (double& radius : scene.bodies.radius) radius *= factor;
    pairs = pairs_by_definition(scene);
    for (const Pair& pair : pairs) ++first[static_cast<size_t>(pair.i) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
  }
  ListedCandidates candidates() const {
    return {{first.data(), static_cast<int64_t>(first.size())}, {pairs.data(), static_cast<int64_t>(pairs.size())}};
  }
};

template <class V>
void check(const Scene& scene, double factor, int threads) {
  const List list(scene, factor);
  const BodyArrays<V> bodies(scene);
  CpuExecutor exec(threads);
  Search<V, CpuExecutor> filter;
  KernelSearch<V, CpuExecutor> search;
  ContactRows<CpuExecutor> rows, expected;
  filter.find(exec, list.candidates(), bodies.view(), bodies.box, rows);
  search.find(exec, list.candidates(), bodies.view(), bodies.box, expected);
  INFO(bodies.count() << " bodies, " << list.pairs.size() << " candidates, threads " << threads);
  const std::vector<Pair> found(rows.pairs().begin(), rows.pairs().end());
  REQUIRE(difference(found, {expected.pairs().begin(), expected.pairs().end()}) == "");
  REQUIRE(difference(found, pairs_by_definition(scene)) == "");
  REQUIRE(exec.download(std::as_const(rows).first()) == exec.download(std::as_const(expected).first()));
}

}  // namespace

TEST_CASE("what stays of a list, and where rows begin, is the same by vectors as by kernels") {
  for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
    for (const double largest : {0.05, 0.2}) {
      for (int count = 0; count < 120; count += count < 40 ? 1 : 13) {
        Cloud cloud{.count = count, .smallest = 0.05, .largest = largest, .boundary = boundary};
        check<Vec3>(make_cloud(cloud, static_cast<uint64_t>(count)), 3.0, 1);
        cloud.dimensions = 2;
        check<Vec2>(make_cloud(cloud, static_cast<uint64_t>(count)), 3.0, 1);
      }
    }
  }
}

TEST_CASE("lists of many blocks are filtered alike by any number of threads") {
  const int threads = GENERATE(1, 2, 8);
  // Several blocks of pairs; bodies without pairs at the start, in the middle and at the end of the order.
  Scene scene = make_cloud({.count = 6000, .smallest = 0.03, .largest = 0.06}, 1);
  for (const int from : {0, 2500, 5800}) {
    for (int i = from; i < from + 200; ++i) scene.bodies.radius[static_cast<size_t>(i)] = 1e-6;
  }
  check<Vec3>(scene, 2.0, threads);
  check<Vec2>(make_cloud({.count = 5000, .dimensions = 2, .smallest = 0.01, .largest = 0.02}, 1), 1.5, threads);
}

TEST_CASE("pairs are tested one by one at every length of a list") {
  const BodyArrays<Vec3> bodies(make_cloud({.count = 60, .smallest = 0.1, .largest = 0.5}, 6));
  std::vector<Pair> all;
  for (int i = 0; i < 60; ++i) {
    for (int j = i + 1; j < 60; ++j) all.push_back({i, j});
  }
  for (int length = 0; length <= 200; ++length) {
    const Span<const Pair> pairs(all.data() + length, length);
    PairBuffer found;
    found.reserve(1);
    *found.end() = {-7, -7};
    found.set_end(found.end() + 1);
    vector_tests<Vec3>().test_pairs(bodies.view().position, bodies.view().radius, bodies.box, pairs, found);
    std::vector<Pair> expected{{-7, -7}};
    for (const Pair& pair : pairs) {
      const Vec3 d = bodies.box.displacement(bodies.view().position[pair.i], bodies.view().position[pair.j]);
      if (in_contact(d, bodies.view().radius[pair.i] + bodies.view().radius[pair.j])) expected.push_back(pair);
    }
    INFO("length " << length);
    REQUIRE(difference({found.span().begin(), found.span().end()}, expected) == "");
  }
}
