// SPDX-License-Identifier: MIT
#include "narrow_phase/vector_search.h"

#include <catch2/catch.hpp>

#include "narrow_phase/collider.h"
#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// Both searches on the candidates of one broad phase.
template <class Method, class V>
void compare(const BodyArrays<V>& bodies, const Settings& settings, int threads) {
  CpuExecutor exec(threads);
  Method method(bodies.parameters(settings));
  method.prepare(exec, bodies.view());
  KernelSearch<V, CpuExecutor> kernels;
  VectorSearch<V> vectors;
  ContactRows<CpuExecutor> expected, found;
  kernels.find(exec, method.candidates(), bodies.view(), bodies.box, expected);
  vectors.find(exec, method.candidates(), bodies.view(), bodies.box, found);
  const bool is_same = exec.download(found.pairs()) == exec.download(expected.pairs());
  REQUIRE(is_same);
  REQUIRE(kernels.tests(exec) == vectors.tests());
}

template <class V>
void compare_all(const Scene& scene, int threads) {
  const BodyArrays<V> bodies(scene);
  compare<BruteForce<V, CpuExecutor>>(bodies, {}, threads);
  compare<SortAndSweep<V, CpuExecutor>>(bodies, {}, threads);
  for (const char* const table : {"auto", "dense", "hashed"}) {
    INFO("table " << table);
    compare<SortedGrid<V, CpuExecutor>>(bodies, settings_of({.table = table}), threads);
  }
}

void compare_all(const Scene& scene, int threads) {
  scene.domain.dimensions == 2 ? compare_all<Vec2>(scene, threads) : compare_all<Vec3>(scene, threads);
}

}  // namespace

TEST_CASE("kernels and vectors find the same pairs with the same number of tests, on every input") {
  for (const Input& input : inputs()) {
    INFO(input.name);
    compare_all(input.make(41), 1);
  }
}

TEST_CASE("kernels and vectors find the same pairs where blocks are searched at once", "[slow]") {
  const int threads = GENERATE(1, 2, 8);
  for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
    compare_all(make_cloud({.count = 5000, .smallest = 0.05, .largest = 0.05, .boundary = boundary}, 1), threads);
    compare_all(make_cloud({.count = 5000, .smallest = 0.02, .largest = 0.1, .boundary = boundary}, 1), threads);
    compare_all(
        make_cloud({.count = 5000, .dimensions = 2, .smallest = 0.01, .largest = 0.03, .boundary = boundary}, 1),
        threads);
  }
}

TEST_CASE("a search that follows a larger one finds nothing of it") {
  CpuExecutor exec(2);
  Search<Vec3, CpuExecutor> search;
  ContactRows<CpuExecutor> rows;
  for (const int count : {6000, 300, 0, 5000}) {
    const Scene scene = make_cloud({.count = count, .smallest = 0.06, .largest = 0.06}, 1);
    const BodyArrays<Vec3> bodies(scene);
    SortedGrid<Vec3, CpuExecutor> grid(bodies.parameters({}));
    grid.prepare(exec, bodies.view());
    search.find(exec, grid.candidates(), bodies.view(), bodies.box, rows);
    const std::vector<Pair> found(rows.pairs().begin(), rows.pairs().end());
    CHECK(difference(found, pairs_by_definition(scene)) == "");
    REQUIRE(rows.first().size() == count + 1);
    CHECK(rows.first()[0] == 0);
    CHECK(rows.first()[count] == static_cast<int>(found.size()));
    for (int i = 0; i < count; ++i) {
      for (int k = rows.first()[i]; k < rows.first()[i + 1]; ++k) REQUIRE(found[static_cast<size_t>(k)].i == i);
    }
  }
}
