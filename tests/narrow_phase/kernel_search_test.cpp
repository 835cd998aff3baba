// SPDX-License-Identifier: MIT
#include "narrow_phase/kernel_search.h"

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "tests/support/body_arrays.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// All bodies after i, the last one first: the order of candidates must not matter.
struct AllAfter {
  int count;

  template <class Visit>
  void for_each(int i, Visit&& visit) const {
    for (int j = count - 1; j > i; --j) {
      if (!visit(j)) return;
    }
  }
};

Scene three_in_a_heap() {
  Scene scene;
  scene.domain.max = Vec3d(4.0);
  add_sphere(scene, {1, 1, 1}, Vec3d(0.0), 0.5);
  add_sphere(scene, {1.5, 1, 1}, Vec3d(0.0), 0.5);
  add_sphere(scene, {1.2, 1.2, 1}, Vec3d(0.0), 0.5);
  return scene;
}

}  // namespace

TEST_CASE("contacts are counted, placed and sorted whatever order their candidates come in") {
  const BodyArrays<Vec3> bodies(three_in_a_heap());
  CpuExecutor exec(1);
  KernelSearch<Vec3, CpuExecutor> search;
  ContactRows<CpuExecutor> rows;
  search.find(exec, AllAfter{3}, bodies.view(), bodies.box, rows);
  REQUIRE(rows.pairs().size() == 3);
  CHECK(rows.pairs()[0] == Pair{0, 1});
  CHECK(rows.pairs()[1] == Pair{0, 2});
  CHECK(rows.pairs()[2] == Pair{1, 2});
  CHECK(exec.download(rows.first()) == std::vector<int>{0, 2, 3, 3});
  CHECK(exec.download(search.tested()) == std::vector<int>{2, 1, 0});
  CHECK(search.tests(exec) == 3);
}

TEST_CASE("bodies with more contacts than are kept from counting to filling have all of them") {
  const int threads = GENERATE(1, 2);
  // Some bodies have none, some as many as are kept, one more, and many.
  const Scene scene = make_cloud({.count = 1500, .smallest = 0.01, .largest = 0.4, .is_log_uniform = true}, 2);
  const BodyArrays<Vec3> bodies(scene);
  CpuExecutor exec(threads);
  KernelSearch<Vec3, CpuExecutor> search;
  ContactRows<CpuExecutor> rows;
  search.find(exec, AllAfter{bodies.count()}, bodies.view(), bodies.box, rows);
  const std::vector<Pair> found(rows.pairs().begin(), rows.pairs().end());
  CHECK(difference(found, pairs_by_definition(scene)) == "");
  int most = 0;
  std::vector<int> rows_of_length(20, 0);
  for (int i = 0; i < bodies.count(); ++i) {
    const int length = rows.first()[i + 1] - rows.first()[i];
    most = std::max(most, length);
    if (length < 20) ++rows_of_length[static_cast<size_t>(length)];
  }
  CHECK(most > 50);
  CHECK((rows_of_length[0] > 0 && rows_of_length[kKept] > 0 && rows_of_length[kKept + 1] > 0));
}

TEST_CASE("a number of contacts that an index cannot hold is an error that names it") {
  CHECK(checked_count(2147483647, "contacts") == 2147483647);
  CHECK_THROWS_WITH(checked_count(2147483648, "contacts"), Catch::Contains("contacts: too many: 2147483648"));
  CHECK_THROWS_AS(checked_count(2147483648, "contacts"), RunError);
}
