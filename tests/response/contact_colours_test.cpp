// SPDX-License-Identifier: MIT
// Colours of contacts: no two contacts of one colour share a body, and few colours suffice.
#include "response/contact_colours.h"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "narrow_phase/contact_list.h"
#include "tests/support/body_arrays.h"
#include "tests/support/ledger_executor.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// The contacts of a cloud, and where each body's row starts.
struct Contacts {
  BodyArrays<Vec3> arrays;
  std::vector<Pair> pairs;
  std::vector<int> first;
  CpuExecutor exec{2};
  ContactList<Vec3, CpuExecutor> list;

  explicit Contacts(const Scene& scene) : arrays(scene) {
    for (int i = 0; i < arrays.count(); ++i) {
      first.push_back(static_cast<int>(pairs.size()));
      for (int j = i + 1; j < arrays.count(); ++j) {
        const Vec3 d = arrays.position[j] - arrays.position[i];
        const BodiesView<Vec3> view = arrays.view();
        if (in_contact<Vec3>(d, view.radius[i] + view.radius[j])) pairs.push_back({i, j});
      }
    }
    first.push_back(static_cast<int>(pairs.size()));
    list.build(exec, {pairs.data(), static_cast<int64_t>(pairs.size())},
               {first.data(), static_cast<int64_t>(first.size())}, arrays.view(), arrays.box);
  }
};

template <class Exec>
std::vector<std::vector<int>> colours_by(Exec& exec, const Contacts& contacts) {
  ContactColours<Vec3, Exec> colours;
  colours.build(exec, contacts.list.view(), contacts.arrays.count());
  const ColoursView view = colours.view();
  std::vector<std::vector<int>> result;
  for (int k = 0; k < *view.colours; ++k) {
    result.emplace_back(view.order.data() + view.begin(k), view.order.data() + view.end(k));
  }
  return result;
}

std::vector<std::vector<int>> colours_of(Contacts& contacts) { return colours_by(contacts.exec, contacts); }

}  // namespace

TEST_CASE("contacts of one colour share no body, and each contact has a colour") {
  const int count = GENERATE(0, 2, 400);
  Contacts contacts(make_cloud({.count = count, .smallest = 0.1, .largest = 0.2}, 2));
  std::set<int> seen;
  for (const std::vector<int>& colour : colours_of(contacts)) {
    std::set<int> bodies;
    for (const int c : colour) {
      CHECK(seen.insert(c).second);
      CHECK(bodies.insert(contacts.pairs[static_cast<size_t>(c)].i).second);
      CHECK(bodies.insert(contacts.pairs[static_cast<size_t>(c)].j).second);
    }
  }
  CHECK(seen.size() == contacts.pairs.size());
  if (count == 400) CHECK(contacts.pairs.size() > 500);
}

TEST_CASE("a device that finds all colours in one launch finds the same") {
  const int count = GENERATE(0, 1, 2, 400);
  Contacts contacts(make_cloud({.count = count, .smallest = 0.1, .largest = 0.2}, 2));
  ledger::Executor device;
  const auto colours = colours_by(device, contacts);
  CHECK(colours == colours_of(contacts));
  if (count == 400) CHECK(colours.size() > 5);
}

TEST_CASE("a solution by colours takes all bodies and then each contact, colour after colour, in each iteration") {
  Contacts contacts(make_cloud({.count = 60, .smallest = 0.1, .largest = 0.2}, 2));
  ContactColours<Vec3, CpuExecutor> colours;
  colours.build(contacts.exec, contacts.list.view(), contacts.arrays.count());
  std::vector<int> seen, expected;  // −1: a body
  std::vector<bool> first;
  for (int k = 0; k < 2; ++k) {
    expected.insert(expected.end(), 60, -1);
    for (const std::vector<int>& colour : colours_of(contacts)) {
      expected.insert(expected.end(), colour.begin(), colour.end());
    }
  }
  const auto note = [&](int what, bool is_first) {
    seen.push_back(what);
    first.push_back(is_first);
  };
  colours.solve(
      contacts.exec, "solve", 60, 2, [&](int, bool is_first) { note(-1, is_first); }, note);
  CHECK(seen == expected);
  CHECK(std::count(first.begin(), first.end(), true) == int64_t(seen.size() / 2));
  CHECK(std::is_sorted(first.rbegin(), first.rend()));
}

TEST_CASE("a row of a thousand contacts needs a handful of colours") {
  Scene scene;
  scene.domain.max = {1000, 1, 1};
  for (int k = 0; k < 1000; ++k) add_sphere(scene, {0.5 + k * 0.99, 0.5, 0.5}, Vec3d(0), 0.5);
  Contacts contacts(scene);
  CHECK(contacts.pairs.size() == 999);
  CHECK(colours_of(contacts).size() <= 10);
}

TEST_CASE("colours are no more than three times the contacts of the body that has most") {
  Contacts contacts(make_cloud({.count = 300, .smallest = 0.05, .largest = 0.15, .huge = 0.6}, 2));
  int most = 0;
  for (int i = 0; i < contacts.arrays.count(); ++i) most = std::max(most, contacts.list.view().count_of(i));
  REQUIRE(most > 20);
  CHECK(static_cast<int>(colours_of(contacts).size()) <= 3 * most);
}
