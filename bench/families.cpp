// SPDX-License-Identifier: MIT
#include "families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/random.h"

namespace ballpit {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadius = 0.5;                                          // of equal spheres
constexpr double kVolume = 4.0 / 3 * kPi * kRadius * kRadius * kRadius;  // of one of them
constexpr double kGap = 4e-6;  // least |d² − R²| of a pair, as a fraction of R², where R is the sum of radii
constexpr double kFinestStep = 0x1p-18;  // between coordinates
constexpr double kRadiusStep = 0x1p-12;  // between radii; a multiple of that between coordinates
constexpr double kDriftPerStep = 0.01;   // in radii
constexpr double kNudge = 1.0 / 64;      // in radii; moves apart spheres that nearly touch

/// By Newton's iteration from above. Unlike std::cbrt, its operations have the same result on every platform.
double cube_root(double a) {
  double x = std::max(a, 1.0);
  for (;;) {
    const double next = (2 * x + a / (x * x)) / 3;
    if (!(next < x)) return x;
    x = next;
  }
}

/// Gaussian with variance 1, as the sum of twelve uniform numbers: without logarithm and cosine, and within ±6.
double gaussian(Random& random) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += random.uniform();
  return sum;
}

/// A family's spheres before rounding.
struct Draft {
  std::vector<Vec3d> position;
  std::vector<double> radius{kRadius};
};

Draft uniform_in(const Vec3d& box, int64_t count, Random& random) {
  Draft draft;
  for (int64_t i = 0; i < count; ++i) draft.position.push_back(random.uniform(Vec3d(0.0), box));
  return draft;
}

Draft make_u05(int64_t count, Random& random) {
  return uniform_in(Vec3d(cube_root(kVolume * static_cast<double>(count) / 0.05)), count, random);
}

Draft make_u30(int64_t count, Random& random) {
  return uniform_in(Vec3d(cube_root(kVolume * static_cast<double>(count) / 0.30)), count, random);
}

/// Each sphere up to a tenth of the spacing beside its place in a cubic lattice.
Draft make_pile(int64_t count, Random& random) {
  const double spacing = cube_root(kVolume / 0.60);
  int64_t side = 1;
  while (side * side * side < count) ++side;
  Draft draft;
  for (int64_t i = 0; i < count; ++i) {
    const Vec3d place(i % side, i / side % side, i / (side * side));
    draft.position.push_back((place + random.uniform(Vec3d(0.4), Vec3d(0.6))) * spacing);
  }
  return draft;
}

/// Density ~ r⁻³ between r = 0.1 and 1: then 1/r² is uniform.
Draft make_poly(int64_t count, Random& random) {
  std::vector<double> radius;
  double volume = 0;
  for (int64_t i = 0; i < count; ++i) {
    const double r = 1 / std::sqrt(random.uniform(1, 100));
    radius.push_back(std::round(r / kRadiusStep) * kRadiusStep);
    volume += 4.0 / 3 * kPi * r * r * r;
  }
  Draft draft = uniform_in(Vec3d(cube_root(volume / 0.30)), count, random);
  draft.radius = std::move(radius);
  return draft;
}

/// Gaussian clouds with uniform centres in a cube; all spheres fill a hundredth of it.
Draft make_clus(int64_t count, Random& random) {
  constexpr double kSigma = 3.5;
  const Vec3d box(cube_root(kVolume * static_cast<double>(count) / 0.01));
  const Draft clouds = uniform_in(box, std::max<int64_t>(1, count / 1000), random);
  Draft draft;
  for (int64_t i = 0; i < count; ++i) {
    const Vec3d centre = clouds.position[random.bits() % clouds.position.size()];
    const double x = gaussian(random), y = gaussian(random), z = gaussian(random);
    draft.position.push_back(centre + kSigma * Vec3d(x, y, z));
  }
  return draft;
}

/// 60 % of the plane's area, all at the same height.
Draft make_floor(int64_t count, Random& random) {
  const double side = std::sqrt(kPi * kRadius * kRadius * static_cast<double>(count) / 0.60);
  Draft draft = uniform_in(Vec3d(side, side, 0.0), count, random);
  for (Vec3d& position : draft.position) position.z = kRadius;
  return draft;
}

/// A hundred times as tall as wide.
Draft make_column(int64_t count, Random& random) {
  const double width = cube_root(kVolume * static_cast<double>(count) / 0.55 / 100);
  return uniform_in(Vec3d(width, width, 100 * width), count, random);
}

struct Family {
  FamilyInfo info;
  Draft (*draft)(int64_t count, Random& random);
};

constexpr std::array<Family, 7> kFamilies{{
    {{"u05", "equal, uniform in a cube, 5 % of its volume"}, make_u05},
    {{"u30", "equal, uniform in a cube, 30 % of its volume"}, make_u30},
    {{"pile", "equal, jittered cubic lattice, 60 % of the volume"}, make_pile},
    {{"poly", "radii 1 : 10, density ~ r^-3, uniform in a cube, 30 % of its volume"}, make_poly},
    {{"clus", "equal, Gaussian clouds of about 1000"}, make_clus},
    {{"floor", "equal, all centres on a plane, 60 % of its area"}, make_floor},
    {{"column", "equal, uniform in a column 100 times as tall as wide, 55 % of its volume"}, make_column},
}};

const Family& find_family(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Family& family : kFamilies) {
    if (family.info.name == name) return family;
    names.push_back(family.info.name);
  }
  throw UserError("--families", name, join(names));
}

template <class T>
void shuffle(std::vector<T>& values, uint64_t seed) {
  Random random(seed);
  for (size_t k = values.size(); k > 1; --k) std::swap(values[k - 1], values[random.bits() % k]);
}

/// The finest step with which every x ± r and every difference of coordinates is at most 2²³ steps.
double step_for(const std::vector<Vec3d>& position, double largest_radius) {
  double reach = 0;
  for (const Vec3d& p : position) reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  double step = kFinestStep;
  while (2 * (reach + 2 * largest_radius) > step * 0x1p23) step *= 2;
  return step;
}

Vec3 round_to(double step, const Vec3d& p) {
  return narrow<Vec3>(Vec3d(std::round(p.x / step), std::round(p.y / step), std::round(p.z / step)) * step);
}

bool is_flat(const Spheres& spheres) {
  const float z = spheres.position.front().z;
  return std::all_of(spheres.position.begin(), spheres.position.end(), [z](const Vec3& p) { return p.z == z; });
}

// Pairs that nearly touch, by a sorted cell list:
//
//     y │ · · · · ·      Entries are sorted by cell, x fastest. The cells that follow a sphere's own among its 27
//       │ · A B C ·      neighbours are five runs of consecutive cells, hence five runs of consecutive entries: its own
//       │ · # D · ·      cell and the next one (# D), the row above it (A B C), and three rows of the next layer in z.
//       └───────── x     From one sphere to the next, all runs only move forward: five cursors sweep the list.
struct Entry {
  int64_t cell;
  Vec3 position;
  float radius;
  int32_t body;
};

struct CellList {
  std::vector<Entry> entries;
  std::array<int64_t, 5> first;  ///< of each run of cells, relative to the sphere's own
  std::array<int64_t, 5> last;
};

CellList sort_into_cells(const Spheres& spheres) {
  const double edge = 2.001 * *std::max_element(spheres.radius.begin(), spheres.radius.end());
  Vec3 low = spheres.position.front(), high = low;
  for (const Vec3& p : spheres.position) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Vec3d size = (Vec3d(high) - Vec3d(low)) / edge;
  const int64_t row = static_cast<int64_t>(size.x) + 3;  // an empty cell at either end, so that rows do not touch
  const int64_t layer = row * (static_cast<int64_t>(size.y) + 3);
  CellList list{{},
                {0, row - 1, layer - row - 1, layer - 1, layer + row - 1},
                {1, row + 1, layer - row + 1, layer + 1, layer + row + 1}};
  list.entries.reserve(spheres.position.size());
  for (size_t i = 0; i < spheres.position.size(); ++i) {
    const Vec3d c = (Vec3d(spheres.position[i]) - Vec3d(low)) / edge;
    const int64_t cell =
        static_cast<int64_t>(c.z) * layer + static_cast<int64_t>(c.y) * row + static_cast<int64_t>(c.x);
    const auto body = static_cast<int32_t>(i);
    list.entries.push_back({cell, spheres.position[i], spheres.radius_of(body), body});
  }
  std::sort(list.entries.begin(), list.entries.end(),
            [](const Entry& a, const Entry& b) { return a.cell != b.cell ? a.cell < b.cell : a.body < b.body; });
  return list;
}

bool nearly_touch(const Entry& a, const Entry& b) {
  const Vec3d d = Vec3d(a.position) - Vec3d(b.position);
  const double sum = static_cast<double>(a.radius) + b.radius;
  return std::abs(dot(d, d) - sum * sum) <= kGap * sum * sum;
}

/// One body of each pair that nearly touches, in ascending order.
std::vector<int32_t> find_nearly_touching(const Spheres& spheres) {
  const CellList list = sort_into_cells(spheres);
  const std::vector<Entry>& entries = list.entries;
  std::vector<int32_t> found;
  for (size_t run = 0; run < list.first.size(); ++run) {
    for (size_t k = 0, begin = 0, end = 0; k < entries.size(); ++k) {
      while (begin < entries.size() && entries[begin].cell < entries[k].cell + list.first[run]) ++begin;
      while (end < entries.size() && entries[end].cell <= entries[k].cell + list.last[run]) ++end;
      for (size_t m = std::max(begin, k + 1); m < end; ++m) {
        if (nearly_touch(entries[k], entries[m])) found.push_back(std::max(entries[k].body, entries[m].body));
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Nudges one sphere of each pair that nearly touches, until there is none.
void part_nearly_touching(Spheres& spheres, double step, uint64_t seed) {
  Random random(seed);
  const int dimensions = is_flat(spheres) ? 2 : 3;
  for (;;) {
    const std::vector<int32_t> bodies = find_nearly_touching(spheres);
    if (bodies.empty()) return;
    for (const int32_t body : bodies) {
      Vec3& position = spheres.position[static_cast<size_t>(body)];
      const double nudge = std::max(2 * step, kNudge * spheres.radius_of(body));
      position = round_to(step, Vec3d(position) + nudge * random.direction(dimensions));
    }
  }
}

/// Independent numbers for each use of a seed.
uint64_t seed_for(uint64_t seed, uint64_t use) { return Random(Random(seed).bits() + use).bits(); }

enum SeedUse : uint64_t { kDraftSeed, kShuffleSeed, kPartSeed, kDriftSeed, kDriftPartSeed };

}  // namespace

std::span<const FamilyInfo> families() {
  static const auto infos = [] {
    std::array<FamilyInfo, kFamilies.size()> result;
    std::transform(kFamilies.begin(), kFamilies.end(), result.begin(),
                   [](const Family& family) { return family.info; });
    return result;
  }();
  return infos;
}

Spheres make_family(std::string_view name, int64_t count, uint64_t seed) {
  const Family& family = find_family(name);
  if (count < 1 || count > INT32_MAX) {
    throw UserError("--count", std::to_string(count), "1 to " + std::to_string(INT32_MAX));
  }
  Random random(seed_for(seed, kDraftSeed));
  Draft draft = family.draft(count, random);
  shuffle(draft.position, seed_for(seed, kShuffleSeed));
  if (draft.radius.size() > 1) shuffle(draft.radius, seed_for(seed, kShuffleSeed));
  const double step = step_for(draft.position, *std::max_element(draft.radius.begin(), draft.radius.end()));
  Spheres spheres;
  for (const Vec3d& p : draft.position) spheres.position.push_back(round_to(step, p));
  for (const double r : draft.radius) spheres.radius.push_back(static_cast<float>(r));
  part_nearly_touching(spheres, step, seed_for(seed, kPartSeed));
  return spheres;
}

Spheres drifted(const Spheres& start, int64_t steps, uint64_t seed) {
  Random random(seed_for(seed, kDriftSeed));
  const int dimensions = is_flat(start) ? 2 : 3;
  std::vector<Vec3d> position;
  for (int64_t i = 0; i < start.count(); ++i) {
    const double way = kDriftPerStep * static_cast<double>(steps) * start.radius_of(i);
    position.push_back(Vec3d(start.position[static_cast<size_t>(i)]) + way * random.direction(dimensions));
  }
  const double step = step_for(position, *std::max_element(start.radius.begin(), start.radius.end()));
  Spheres result{{}, start.radius};
  for (const Vec3d& p : position) result.position.push_back(round_to(step, p));
  part_nearly_touching(result, step, seed_for(seed + static_cast<uint64_t>(steps), kDriftPartSeed));
  return result;
}

}  // namespace ballpit
