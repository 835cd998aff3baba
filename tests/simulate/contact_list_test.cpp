// SPDX-License-Identifier: MIT
#include "simulate/narrowphase/contact_list.h"

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"

using namespace ballpit;

namespace {

/// Three spheres in a row along x: 0 and 2 both touch 1.
struct Row {
  std::vector<Vec3> position{{1.0f, 0, 0}, {1.9f, 0, 0}, {2.7f, 0, 0}};
  std::vector<Vec3> velocity{{2, 1, 0}, {0, 0, 0}, {0.5f, 0, 0}};
  float radius = 0.5f, inverse_mass = 1.0f;
  Box<Vec3> box{Vec3(0.0f), Vec3(4.0f), Boundary::walls};

  BodiesView<Vec3> view() const {
    return {{position.data(), 3}, {velocity.data(), 3}, {&radius, 0}, {&inverse_mass, 0}};
  }
};

struct AllAfter {
  template <class Visit>
  void for_each(int i, Visit&& visit) const {
    for (int j = 2; j > i; --j) {  // descending: the order must not matter
      if (!visit(j)) return;
    }
  }
};

}  // namespace

TEST_CASE("contacts are counted, placed and sorted whatever order their candidates come in") {
  Row row;
  row.position = {{1, 0, 0}, {1.5f, 0, 0}, {1.2f, 0.2f, 0}};
  CpuExecutor exec(1);
  ContactFinder<Vec3, CpuExecutor> found;
  found.find(exec, AllAfter{}, row.view(), row.box);
  REQUIRE(found.pairs().size() == 3);
  CHECK(found.pairs()[0] == Pair{0, 1});
  CHECK(found.pairs()[1] == Pair{0, 2});
  CHECK(found.pairs()[2] == Pair{1, 2});
  CHECK(found.tested()[0] == 2);
  CHECK(found.tested()[2] == 0);
}

TEST_CASE("a contact's normal points from i to j, its overlap and its speed are those of the pair") {
  Row row;
  CpuExecutor exec(1);
  ContactFinder<Vec3, CpuExecutor> found;
  ContactList<Vec3, CpuExecutor> list;
  found.find(exec, AllAfter{}, row.view(), row.box);
  list.build(exec, found, row.view(), row.box);
  const ContactsView<Vec3> contacts = list.view();
  REQUIRE(contacts.pairs.size() == 2);
  CHECK(contacts.geometry[0].normal.x == Approx(1));
  CHECK(contacts.geometry[0].overlap == Approx(0.1));
  CHECK(contacts.geometry[0].separation == Approx(-2));
  CHECK(contacts.geometry[1].overlap == Approx(0.2));
  CHECK(contacts.geometry[1].separation == Approx(0.5));
}

TEST_CASE("each body lists its own contacts, with the side that it is on") {
  Row row;
  CpuExecutor exec(1);
  ContactFinder<Vec3, CpuExecutor> found;
  ContactList<Vec3, CpuExecutor> list;
  found.find(exec, AllAfter{}, row.view(), row.box);
  list.build(exec, found, row.view(), row.box);
  const ContactsView<Vec3> contacts = list.view();
  std::vector<std::array<int, 3>> seen;
  for (int body = 0; body < 3; ++body) {
    contacts.for_each_of(body, [&](int c, int other, int side) { seen.push_back({c, other, side}); });
  }
  // body 0: contact 0 with 1; body 1: contact 1 with 2, then contact 0 with 0; body 2: contact 1 with 1
  CHECK(seen == std::vector<std::array<int, 3>>{{0, 1, 1}, {1, 2, 1}, {0, 0, -1}, {1, 1, -1}});
  CHECK(contacts.count_of(1) == 2);
}

TEST_CASE("coincident centres have a normal") {
  Row row;
  row.position[1] = row.position[0];
  CpuExecutor exec(1);
  ContactFinder<Vec3, CpuExecutor> found;
  ContactList<Vec3, CpuExecutor> list;
  found.find(exec, AllAfter{}, row.view(), row.box);
  list.build(exec, found, row.view(), row.box);
  CHECK(list.view().geometry[0].normal == Vec3(0, 0, 1));
  CHECK(list.view().geometry[0].overlap == 1.0f);
}

TEST_CASE("displacement takes the nearest image of a periodic domain, and is antisymmetric to the bit") {
  const Box<Vec2> box{{0, 0}, {1, 2}, Boundary::periodic};
  CHECK(box.displacement({0.1f, 0.1f}, {0.9f, 1.9f}).x == Approx(-0.2));
  CHECK(box.displacement({0.1f, 0.1f}, {0.9f, 1.9f}).y == Approx(-0.2));
  const Vec2 a{0.123f, 0.987f}, b{0.777f, 0.111f};
  CHECK(box.displacement(a, b) == -box.displacement(b, a));
  CHECK(box.wrap({1.25f, -0.5f}).x == Approx(0.25));
  CHECK(box.wrap({1.25f, -0.5f}).y == Approx(1.5));
}
