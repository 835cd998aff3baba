// SPDX-License-Identifier: MIT
#include "narrow_phase/contact_list.h"

#include <array>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "exec/cpu_executor.h"
#include "tests/support/body_arrays.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

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

/// The contacts (0, 1) and (1, 2), or whatever else, with the rows that they make.
struct Contacts {
  std::vector<Pair> pairs;
  std::vector<int> first;

  Contacts(std::vector<Pair> sorted, int bodies) : pairs(std::move(sorted)), first(static_cast<size_t>(bodies) + 1, 0) {
    for (const Pair& pair : pairs) ++first[static_cast<size_t>(pair.i) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
  }

  template <class V>
  ContactsView<V> listed(CpuExecutor& exec, ContactList<V, CpuExecutor>& list, const BodiesView<V>& bodies,
                         const Box<V>& box) const {
    list.build(exec, {pairs.data(), static_cast<int64_t>(pairs.size())},
               {first.data(), static_cast<int64_t>(first.size())}, bodies, box);
    return list.view();
  }
};

}  // namespace

TEST_CASE("a contact's normal points from i to j, its overlap and its speed are those of the pair") {
  Row row;
  CpuExecutor exec(1);
  ContactList<Vec3, CpuExecutor> list;
  const Contacts both({{0, 1}, {1, 2}}, 3);
  const ContactsView<Vec3> contacts = both.listed(exec, list, row.view(), row.box);
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
  ContactList<Vec3, CpuExecutor> list;
  const Contacts both({{0, 1}, {1, 2}}, 3);
  const ContactsView<Vec3> contacts = both.listed(exec, list, row.view(), row.box);
  std::vector<std::array<int, 3>> seen;
  for (int body = 0; body < 3; ++body) {
    contacts.for_each_of(body, [&](int c, int other, int side) { seen.push_back({c, other, side}); });
  }
  // body 0: contact 0 with 1; body 1: contact 1 with 2, then contact 0 with 0; body 2: contact 1 with 1
  CHECK(seen == std::vector<std::array<int, 3>>{{0, 1, 1}, {0, 0, -1}, {1, 2, 1}, {1, 1, -1}});
  CHECK(contacts.count_of(1) == 2);
}

TEST_CASE("each contact is incoming at its second body once, in the order of the contacts") {
  const int threads = GENERATE(1, 2, 8);
  const Scene scene = make_cloud({.count = 3000, .smallest = 0.02, .largest = 0.15}, 3);
  const BodyArrays<Vec3> bodies(scene);
  const Contacts contacts(pairs_by_definition(scene), 3000);
  REQUIRE(contacts.pairs.size() > 5000);
  CpuExecutor exec(threads);
  ContactList<Vec3, CpuExecutor> list;
  const ContactsView<Vec3> view = contacts.listed(exec, list, bodies.view(), bodies.box);
  REQUIRE(view.incoming_first.size() == 3001);
  REQUIRE(view.incoming_first[3000] == static_cast<int>(contacts.pairs.size()));
  REQUIRE(view.incoming.size() == static_cast<int64_t>(contacts.pairs.size()));
  int before = 0;
  for (int body = 0; body < 3000; ++body) {
    REQUIRE(view.incoming_first[body] == before);
    before = view.incoming_first[body + 1];
    int last = -1;
    for (int k = view.incoming_first[body]; k < view.incoming_first[body + 1]; ++k) {
      const IncomingContact incoming = view.incoming[k];
      REQUIRE(contacts.pairs[static_cast<size_t>(incoming.contact)] == Pair{incoming.body, body});
      REQUIRE(incoming.contact > last);
      last = incoming.contact;
    }
  }
}

TEST_CASE("no contacts and no bodies leave empty lists") {
  CpuExecutor exec(1);
  for (const int count : {0, 3}) {
    const BodyArrays<Vec3> bodies(make_cloud({.count = count}, 1));
    ContactList<Vec3, CpuExecutor> list;
    const Contacts none({}, count);
    const ContactsView<Vec3> view = none.listed(exec, list, bodies.view(), bodies.box);
    CHECK(view.incoming.empty());
    CHECK(exec.download(view.incoming_first) == std::vector<int>(static_cast<size_t>(count) + 1, 0));
    for (int body = 0; body < count; ++body) CHECK(view.count_of(body) == 0);
  }
}

TEST_CASE("coincident centres have a normal") {
  Row row;
  row.position[1] = row.position[0];
  CpuExecutor exec(1);
  ContactList<Vec3, CpuExecutor> list;
  const Contacts one({{0, 1}}, 3);
  one.listed(exec, list, row.view(), row.box);
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
