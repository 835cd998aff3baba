// SPDX-License-Identifier: MIT
// The vector loops against one pair after the other, at every length where a vector may end too early or too late.
#include "narrow_phase/range_tests.h"

#include <algorithm>
#include <numeric>

#include <catch2/catch.hpp>

#include "core/random.h"

using namespace ballpit;

namespace {

struct Kind {
  bool is_equal, is_tagged, is_periodic;
};

std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds;
  for (int k = 0; k < 8; ++k) kinds.push_back({(k & 1) != 0, (k & 2) != 0, (k & 4) != 0});
  return kinds;
}

/// Slots with everything that a search may bring, about one pair in six in contact. Beyond the last slot, where vectors
/// may read but must not find, every value is that of a sphere that touches all.
template <class V>
struct SlotArrays {
  Kind kind;
  std::vector<float> coordinate[kDimensions<V>], radius;
  std::vector<int> body;
  std::vector<unsigned> tag;
  Box<V> box;
  int count;

  SlotArrays(int slots, const Kind& wanted, uint64_t seed) : kind(wanted), count(slots) {
    Random random(seed);
    box = {V(-1.0f), V(1.0f), kind.is_periodic ? Boundary::periodic : Boundary::walls};
    body.resize(static_cast<size_t>(slots) + kSlotPadding);
    std::iota(body.begin(), body.end(), 0);
    for (size_t k = static_cast<size_t>(slots); k > 1; --k) std::swap(body[k - 1], body[random.bits() % k]);
    for (int s = 0; s < slots + kSlotPadding; ++s) {
      const bool is_beyond = s >= slots;
      for (auto& values : coordinate) values.push_back(is_beyond ? 0.0f : static_cast<float>(random.uniform(-1, 1)));
      radius.push_back(is_beyond ? 10.0f : static_cast<float>(random.uniform(0.1, 0.5)));
      tag.push_back(static_cast<unsigned>(random.bits() % 3) + 0x7FFFFFFDu);
    }
    if (kind.is_equal) radius.assign(1, 0.35f);
  }

  SlotsView<V> view() const {
    SlotsView<V> view;
    view.count = count;
    const auto size = static_cast<int64_t>(body.size());
    for (int axis = 0; axis < kDimensions<V>; ++axis) view.coordinate[axis] = {coordinate[axis].data(), size};
    view.radius = {radius.data(), kind.is_equal ? 0 : 1};
    view.body = {body.data(), size};
    if (kind.is_tagged) view.tag = {tag.data(), size};
    return view;
  }

  SlotRange range(int first, int last, Random& random) const {
    return {first, last, static_cast<unsigned>(random.bits() % 3) + 0x7FFFFFFDu};
  }
};

/// One pair after the other, by in_contact().
template <class V>
void test_one_by_one(const SlotArrays<V>& arrays, int a, int b, std::vector<Pair>& found) {
  const SlotsView<V> slots = arrays.view();
  const V d = arrays.box.displacement(slots.position(a), slots.position(b));
  if (in_contact(d, slots.radius[a] + slots.radius[b])) {
    found.push_back({std::min(slots.body[a], slots.body[b]), std::max(slots.body[a], slots.body[b])});
  }
}

template <class V>
std::vector<Pair> found_one_by_one(const SlotArrays<V>& arrays, const std::vector<RangeTask>& tasks) {
  std::vector<Pair> found;
  for (const auto& [slot, range] : tasks) {
    for (int other = range.first; other < range.last; ++other) {
      if (!arrays.kind.is_tagged || range.tag == kAnyTag || arrays.tag[static_cast<size_t>(other)] == range.tag) {
        test_one_by_one(arrays, slot, other, found);
      }
    }
  }
  return found;
}

std::vector<Pair> sorted(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
  return pairs;
}

template <class V>
void check(const SlotArrays<V>& arrays, const std::vector<RangeTask>& tasks) {
  PairBuffer found;
  found.reserve(1);
  *found.end() = {-7, -7};
  found.set_end(found.end() + 1);  // what is there already stays
  vector_tests<V>().test_ranges(arrays.view(), arrays.box, {tasks.data(), static_cast<int64_t>(tasks.size())}, found);
  const std::vector<Pair> pairs(found.span().begin(), found.span().end());
  REQUIRE(pairs[0] == Pair{-7, -7});
  const bool is_same = sorted({pairs.begin() + 1, pairs.end()}) == sorted(found_one_by_one(arrays, tasks));
  REQUIRE(is_same);
}

template <class V>
void check_every_length() {
  for (const Kind& kind : all_kinds()) {
    for (int length = 1; length <= 200; ++length) {
      INFO(kDimensions<V> << " dimensions, equal " << kind.is_equal << ", tagged " << kind.is_tagged << ", periodic "
                          << kind.is_periodic << ", length " << length);
      Random random(static_cast<uint64_t>(length));
      const int start = 1 + static_cast<int>(random.bits() % 20);
      const SlotArrays<V> arrays(start + length, kind, random.bits());
      check(arrays, {{0, arrays.range(start, start + length, random)}});  // the range ends with the slots
      check(arrays, {{start, arrays.range(0, length, random)}, {0, {1, start + length, kAnyTag}}});
    }
  }
}

template <class V>
void check_random_tasks(uint64_t seed) {
  Random random(seed);
  const auto below = [&](int limit) { return static_cast<int>(random.bits() % static_cast<unsigned>(limit)); };
  const Kind kind = all_kinds()[random.bits() % 8];
  const SlotArrays<V> arrays(200 + below(3000), kind, seed);
  std::vector<RangeTask> tasks;
  for (int t = below(3000); t > 0; --t) {
    const int first = below(arrays.count), length = 1 + below(below(3) == 0 ? 300 : 20);
    tasks.push_back({below(arrays.count), arrays.range(first, std::min(arrays.count, first + length), random)});
    if (below(10) == 0) tasks.back().range.tag = kAnyTag;
  }
  INFO("seed " << seed);
  check(arrays, tasks);
}

}  // namespace

TEST_CASE("ranges of 1 to 200 slots are tested as one pair after the other would be") {
  INFO("instructions: " << range_test_instructions());
  check_every_length<Vec2>();
  check_every_length<Vec3>();
}

TEST_CASE("ranges of any number and length are tested as one pair after the other would be") {
  for (uint64_t seed = 1; seed <= 150; ++seed) {
    check_random_tasks<Vec2>(seed);
    check_random_tasks<Vec3>(seed);
  }
}

TEST_CASE("pairs that touch exactly are in contact for vectors as for in_contact") {
  // Distances at the last bit before, on and after the sum of radii, along each axis and across.
  for (const bool is_periodic : {false, true}) {
    SlotArrays<Vec3> arrays(64, {false, false, is_periodic}, 1);
    Random random(4);
    for (size_t s = 0; s < 64; ++s) {
      arrays.radius[s] = 0.1f * static_cast<float>(random.uniform(1, 2));
      const Vec3d direction = s == 0 ? Vec3d(0) : (s % 2 == 0 ? Vec3d(1, 0, 0) : random.direction(3));
      const double far =
          s == 0 ? 0 : double(arrays.radius[0] + arrays.radius[s]) * (1 + (static_cast<int>(s) % 5 - 2) * 6e-8);
      for (int axis = 0; axis < 3; ++axis)
        arrays.coordinate[axis][s] = static_cast<float>(0.95 + far * direction[axis]);
    }
    check(arrays, {{0, {1, 64}}});
  }
}

TEST_CASE("the instructions in use have a name") { CHECK(std::string(range_test_instructions()).size() > 2); }
