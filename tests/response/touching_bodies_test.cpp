// SPDX-License-Identifier: MIT
#include "response/touching_bodies.h"

#include <set>
#include <string_view>

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "tests/support/body_arrays.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

using Touching = TouchingBodies<Vec3, CpuExecutor>;

/// Bodies apart from each other, some of which touch the floor, and contacts between others, as a response sees them.
struct Bed {
  BodyArrays<Vec3> bodies;
  std::vector<Pair> pairs;
  std::vector<IncomingContact> incoming;
  std::vector<int> first, incoming_first;
  std::vector<float> share;

  Bed(int count, const std::set<int>& on_floor, const std::vector<Pair>& contacts)
      : bodies(scene_of(count, on_floor)), pairs(contacts), share(static_cast<size_t>(count), -1.0f) {
    for (int i = 0; i <= count; ++i) {
      first.push_back(0);
      incoming_first.push_back(static_cast<int>(incoming.size()));
      for (int c = 0; c < static_cast<int>(pairs.size()); ++c) {
        first.back() += pairs[static_cast<size_t>(c)].i < i;
        if (pairs[static_cast<size_t>(c)].j == i) incoming.push_back({c, pairs[static_cast<size_t>(c)].i});
      }
    }
  }

  ImpulseView<Vec3> view() {
    const auto span = [](auto& values) { return Span(values.data(), static_cast<int64_t>(values.size())); };
    ImpulseView<Vec3> view{};
    view.bodies = bodies.view();
    view.walls.box = bodies.box;
    view.contacts.pairs = span(pairs);
    view.contacts.first = span(first);
    view.contacts.incoming_first = span(incoming_first);
    view.contacts.incoming = span(incoming);
    view.share = span(share);
    return view;
  }

 private:
  static Scene scene_of(int count, const std::set<int>& on_floor) {
    Scene scene = wide_box(count);
    for (int i = 0; i < count; ++i) {
      add_sphere(scene, {i * 0.5, on_floor.count(i) ? -count + 0.05 : 0, 0}, {0.25 * i, 0, 0}, 0.1 + 0.001 * i);
    }
    return scene;
  }
};

int launches_of(World& world, std::string_view name) {
  int count = 0;
  for (const Stage& stage : world.report().stages) count += stage.name == name ? static_cast<int>(stage.launches) : 0;
  return count;
}

}  // namespace

TEST_CASE("bodies with a contact or at a wall are numbered, and their contacts are between the numbers") {
  const int threads = GENERATE(1, 2, 5);
  // Bodies at both ends of the blocks, and a block without any.
  Bed bed(2000, {511, 1999}, {{0, 512}, {0, 1535}, {512, 1536}});
  const std::vector<int> expected{0, 511, 512, 1535, 1536, 1999};
  CpuExecutor exec(threads);
  Touching touching;
  const ImpulseView<Vec3> all = bed.view();
  touching.find(exec, {all, {bed.share.data(), 2000}});
  REQUIRE(touching.are_few());
  const ImpulseView<Vec3> few = touching.view(exec, all);

  REQUIRE(std::vector<int>(touching.bodies().begin(), touching.bodies().end()) == expected);
  REQUIRE(few.bodies.size() == 6);
  const float shares[] = {2, 1, 2, 1, 1, 1};
  for (int k = 0; k < 6; ++k) {
    const int i = expected[static_cast<size_t>(k)];
    INFO("body " << i);
    CHECK(few.bodies.position[k] == all.bodies.position[i]);
    CHECK(few.bodies.velocity[k] == all.bodies.velocity[i]);
    CHECK(few.bodies.radius[k] == all.bodies.radius[i]);
    CHECK(few.bodies.inverse_mass[k] == all.bodies.inverse_mass[i]);
    CHECK(few.share[k] == shares[k]);
    CHECK(few.contacts.count_of(k) == all.contacts.count_of(i));
    std::vector<int> contacts, contacts_of_all;
    few.contacts.for_each_of(k, [&](int c, int other, int side) {
      contacts.insert(contacts.end(), {c, expected[static_cast<size_t>(other)], side});
    });
    all.contacts.for_each_of(i, [&](int c, int other, int side) {
      contacts_of_all.insert(contacts_of_all.end(), {c, other, side});
    });
    CHECK(contacts == contacts_of_all);
  }
  const std::vector<Pair> pairs(few.contacts.pairs.begin(), few.contacts.pairs.end());
  CHECK(pairs == std::vector<Pair>{{0, 2}, {0, 3}, {2, 4}});
}

TEST_CASE("blocks have all bodies once, and those that touch something with their numbers") {
  Bed bed(1030, {3, 1029}, {{511, 512}});
  CpuExecutor exec(1);
  Touching touching;
  touching.find(exec, {bed.view(), {bed.share.data(), 1030}});
  std::vector<std::vector<int>> blocks;
  touching.for_each_block(exec, "blocks", [&](const TouchingBlock& block) {
    std::vector<int> row{block.begin, block.end, block.first};
    row.insert(row.end(), block.bodies.begin(), block.bodies.end());
    blocks.push_back(row);
  });
  CHECK(blocks == std::vector<std::vector<int>>{{0, 512, 0, 3, 511}, {512, 1024, 2, 512}, {1024, 1030, 3, 1029}});
}

TEST_CASE("where most bodies touch something, no copies are made, and where none does, the view is empty") {
  CpuExecutor exec(1);
  Touching touching;
  Bed half(4, {0, 2}, {}), none(4, {}, {});
  touching.find(exec, {half.view(), {half.share.data(), 4}});
  CHECK_FALSE(touching.are_few());
  touching.find(exec, {none.view(), {none.share.data(), 4}});
  REQUIRE(touching.are_few());
  CHECK(touching.view(exec, none.view()).bodies.size() == 0);
}

TEST_CASE("bodies that touch nothing do not change the motion of those that do, bit by bit") {
  const int dimensions = GENERATE(2, 3);
  const bool is_swept = GENERATE(false, true);
  const char* const solver = GENERATE("jacobi", "gauss-seidel");
  const double largest = GENERATE(0.066, 0.072);
  INFO(dimensions << "D, swept " << is_swept << ", " << solver << ", radii up to " << largest);
  Settings settings = settings_of("impulse", 1.0 / 960);
  settings.solver = named<Solver>(solver);
  settings.is_swept = is_swept;
  settings.precision = Precision::float32;
  settings.keeps_tally = true;
  settings.threads = 2;
  Scene crowd = make_crowd(dimensions, 6, Boundary::walls, 0.5, 0.066, largest);
  crowd.domain.max = {40, 5, dimensions == 2 ? 0 : 5};
  Scene among_others = crowd;
  for (int k = 0; k < 2000; ++k) {
    add_sphere(among_others, {2 + 0.15 * (k % 200), 1 + 0.15 * (k / 200), dimensions == 2 ? 0 : 2}, Vec3d(0), 0.07);
  }
  const auto alone = make_cpu_world(crowd, settings), among = make_cpu_world(among_others, settings);
  for (int k = 0; k < 12; ++k) {
    alone->step();
    among->step();
  }
  const Bodies expected = alone->bodies(), found = among->bodies();
  for (size_t i = 0; i < crowd.bodies.position.size(); ++i) {
    REQUIRE(found.position[i] == expected.position[i]);
    REQUIRE(found.velocity[i] == expected.velocity[i]);
  }
  CHECK(found.position[crowd.bodies.position.size()].y < 1);  // the others fall
  CHECK(among->report().tally.floor_impulse == alone->report().tally.floor_impulse);
  CHECK(among->report().tally.virial == alone->report().tally.virial);
  CHECK(alone->report().tally.floor_impulse > 0);
  CHECK(launches_of(*alone, "number touching") == 0);  // or both worlds would run the same code
  CHECK(launches_of(*among, "number touching") > 0);
}
