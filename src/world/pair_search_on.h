// SPDX-License-Identifier: MIT
// The pair search, written once for every executor. Spheres whose centres all have one z are searched in the plane.
// Instantiated by backend_cpu.cpp and cuda/backend_cuda.cu.
#pragma once

#include <algorithm>

#include "narrow_phase/collider.h"
#include "world/inspect_more.h"
#include "world/pair_search.h"

namespace ballpit {

/// Kernel: turns pairs of slots into pairs of bodies, lower body first.
struct NameBodies {
  Span<const Pair> slots;
  Span<const int> order;
  Span<Pair> bodies;

  HOST_DEVICE void operator()(int k) const {
    const int a = order[slots[k].i], b = order[slots[k].j];
    bodies[k] = a < b ? Pair{a, b} : Pair{b, a};
  }
};

/// A pair search in two or in three dimensions. Cell lists lead from sphere to sphere through memory. So many spheres are
/// sorted by the cells of a grid before the search, as in a world (spatial_order.h), and the pairs are renamed afterwards.
/// Methods with slots sort the spheres themselves.
template <class V, class Exec>
class SearchOn {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// Starts anew for these spheres, in the memory held.
  void plan(Exec& exec, const Settings& settings, const Box<V>& box, const SphereArrays& spheres) {
    auto parameters = broad_phase_parameters<V>(settings, box, spheres.radius, spheres.position.size());
    parameters.occupied_volume = occupied_volume(box, spheres.position);
    collider_.plan(choose_broad_phase(settings, parameters), parameters, skin_of(settings));
    exec.upload(radius_, spheres.radius.data(), spheres.radius.size());
    order_.resize(0);
    if (collider_.choice().method == BroadPhase::linked_cell && spheres.position.size() >= kFewestToOrder) {
      take_positions(exec, spheres);
      sort_by_cells(exec, grid_of_one_each(box, parameters.count, 2 * parameters.largest_radius()));
    }
  }

  void find(Exec& exec, const SphereArrays& spheres) {
    take_positions(exec, spheres);
    collider_.moved();
    if (order_.size() > 0) view_ = take_in_order(exec, view_, ordered_position_);
    const Span<const Pair> found = collider_.pairs(exec, bodies());
    if (order_.size() == 0) return;
    named_.resize(found.size());
    exec.parallel_for("name bodies", found.size(), NameBodies{found, order_.span(), named_.span()});
    put_into_rows(exec, Span<const Pair>(named_.span()), order_.size(), rows_);
  }

  /// The pairs found last, in canonical order.
  Span<const Pair> pairs() const { return order_.size() > 0 ? rows_.pairs() : collider_.pairs(); }

  const Collider<V, Exec>& collider() const { return collider_; }
  int64_t bytes() const {
    return collider_.bytes() + position_.bytes() + radius_.bytes() + ordered_position_.bytes() + order_.bytes() +
           offsets_.bytes() + named_.bytes() + rows_.bytes();
  }

 private:
  static constexpr int64_t kFewestToOrder = 16384;  // fewer fit a cache anyway

  /// Points view_ to the positions. Spheres in space are not copied if they are already where the executor works.
  void take_positions(Exec& exec, const SphereArrays& spheres) {
    const int64_t n = spheres.position.size();
    if constexpr (std::is_same_v<Exec, CpuExecutor> && kDimensions<V> == 3) {
      view_ = spheres.position;
      return;
    } else if constexpr (std::is_same_v<Exec, CpuExecutor>) {
      position_.resize(n);
      exec.parallel_for("flatten", n, [from = spheres.position, to = position_.span()](int i) { to[i] = V(from[i]); });
    } else if constexpr (kDimensions<V> == 3) {
      exec.upload(position_, spheres.position.data(), n);
    } else {
      std::vector<V> flat(static_cast<size_t>(n));
      std::transform(spheres.position.begin(), spheres.position.end(), flat.begin(),
                     [](const Vec3& p) { return V(p); });
      exec.upload(position_, flat.data(), n);
    }
    view_ = position_.span();
  }

  void sort_by_cells(Exec& exec, const Grid<V>& grid) {
    order_.resize(view_.size());
    offsets_.resize(grid.size() + 1);
    exec.bin("sort bodies", CellOfId<V>{grid, view_, {}}, offsets_.span(), order_.span());
    if (radius_.size() == 1) return;
    Buffer<Real> ordered;
    take_in_order(exec, Span<const Real>(radius_.span()), ordered);
    std::swap(radius_, ordered);
  }

  template <class T>
  Span<const T> take_in_order(Exec& exec, Span<const T> values, Buffer<T>& result) {
    result.resize(values.size());
    exec.parallel_for("rearrange bodies", values.size(), Rearrange<T>{values, order_.span(), {}, result.span()});
    return result.span();
  }

  BodiesView<V> bodies() const { return {view_, {}, radius_.span(), {}}; }

  Collider<V, Exec> collider_;
  Buffer<V> position_, ordered_position_;
  Span<const V> view_;  // of the positions, during plan() and find()
  Buffer<Real> radius_;
  Buffer<int> order_, offsets_;  // bodies by slot; empty if they are not sorted
  Buffer<Pair> named_;
  ContactRows<Exec> rows_;
};

template <class Exec>
class PairSearchOn final : public PairSearch {
 public:
  PairSearchOn(std::unique_ptr<Exec> exec, const Settings& settings) : exec_(std::move(exec)), settings_(settings) {
    if (!settings_.skin) settings_.skin = 0.0;
    if constexpr (Exec::kDefers) exec_->time_stages(true);
  }

  void find(const SphereArrays& spheres) override {
    if (!may_go_on(spheres)) start(spheres, spheres.period ? *spheres.period : bounds(spheres.position));
    std::visit([&](auto& search) { search.find(*exec_, spheres); }, search_);
  }

  std::vector<Pair> pairs() override {
    return std::visit([&](const auto& search) { return exec_->download(search.pairs()); }, search_);
  }

  SearchReport report() override {
    SearchReport report;
    std::visit(
        [&](auto& search) {
          report.method = name_of(search.collider().choice().method);
          report.reason = search.collider().choice().reason;
          report.candidates = search.collider().tests(*exec_);
          report.contacts = search.collider().pairs().size();
          report.bytes = search.bytes();
        },
        search_);
    report.searches = searches_ + searches();
    report.stages = exec_->stage_times().stages();
    return report;
  }

  std::vector<int> work_per_thread() override {
    return std::visit([&](const auto& search) { return thread_work(*exec_, search.collider()).first; }, search_);
  }

 private:
  Box<Vec3> bounds(Span<const Vec3> position) {
    Box<Vec3> box;
    box.boundary = Boundary::walls;
    if (position.empty()) return box;
    const int64_t blocks = (position.size() + kBoundsBlock - 1) / kBoundsBlock;
    std::vector<Box<Vec3>> parts(static_cast<size_t>(blocks));
    const auto bound = [&](int64_t b) {
      const int64_t from = b * kBoundsBlock, to = std::min(position.size(), from + kBoundsBlock);
      parts[static_cast<size_t>(b)] = bounds_of({position.data() + from, to - from});
    };
    if constexpr (std::is_same_v<Exec, CpuExecutor>) {
      exec_->parallel_for_blocks("find bounds", blocks, bound);
    } else {
      for (int64_t b = 0; b < blocks; ++b) bound(b);
    }
    box.min = parts[0].min;
    box.max = parts[0].max;
    for (const Box<Vec3>& part : parts) {
      box.min = glm::min(box.min, part.min);
      box.max = glm::max(box.max, part.max);
    }
    return box;
  }

  /// Takes all coordinates as one array, a few positions at a time: such a loop compiles to vector instructions.
  static Box<Vec3> bounds_of(Span<const Vec3> position) {
    constexpr int64_t kLanes = 24;
    const Span<const float> x = components(position);
    float low[kLanes], high[kLanes];
    for (int64_t k = 0; k < kLanes; ++k) low[k] = high[k] = x[k % 3];
    const auto widen = [&](int64_t k, float value) {
      low[k] = value < low[k] ? value : low[k];
      high[k] = value > high[k] ? value : high[k];
    };
    int64_t at = 0;
    for (; at + kLanes <= x.size(); at += kLanes) {
      for (int64_t k = 0; k < kLanes; ++k) widen(k, x[at + k]);
    }
    for (; at < x.size(); ++at) widen(at % 3, x[at]);
    Box<Vec3> box;
    box.min = box.max = position[0];
    for (int k = 0; k < kLanes; ++k) {
      box.min[k % 3] = std::min(box.min[k % 3], low[k]);
      box.max[k % 3] = std::max(box.max[k % 3], high[k]);
    }
    return box;
  }

  static bool is_in_a_plane(Span<const Vec3> position) {
    return std::all_of(position.begin(), position.end(), [&](const Vec3& p) { return p.z == position[0].z; });
  }

  /// Whether the grid of the last search serves these spheres: with a skin, while their radii stay the same. Spheres outside
  /// its box belong to the cells at its border, which is correct but slow; so a new box is made now and then.
  bool may_go_on(const SphereArrays& spheres) {
    if (*settings_.skin == 0 || spheres.period || count_ != spheres.position.size()) return false;
    if (!std::equal(spheres.radius.begin(), spheres.radius.end(), radius_.begin(), radius_.end())) return false;
    return searches() < kSearchesInABox;
  }

  void start(const SphereArrays& spheres, const Box<Vec3>& box) {
    searches_ += searches();
    count_ = spheres.position.size();
    if (*settings_.skin > 0) radius_.assign(spheres.radius.begin(), spheres.radius.end());
    const bool is_planar = count_ > 0 && is_in_a_plane(spheres.position) && settings_.axis != SweepAxis::z;
    if (is_planar && *settings_.skin == 0) {  // with a skin, later spheres may leave the plane
      search_of<Vec2>().plan(*exec_, settings_, Box<Vec2>{Vec2(box.min), Vec2(box.max), box.boundary}, spheres);
    } else {
      search_of<Vec3>().plan(*exec_, settings_, box, spheres);
    }
  }

  template <class V>
  SearchOn<V, Exec>& search_of() {
    if (auto* const search = std::get_if<SearchOn<V, Exec>>(&search_)) return *search;
    return search_.template emplace<SearchOn<V, Exec>>();
  }

  int64_t searches() const {
    return std::visit([](const auto& search) { return search.collider().searches(); }, search_);
  }

  static constexpr int64_t kSearchesInABox = 8;
  static constexpr int64_t kBoundsBlock = 1 << 14;  // spheres

  std::unique_ptr<Exec> exec_;
  Settings settings_;
  int64_t count_ = -1;
  std::vector<float> radius_;  // of the last start, where there is a skin
  int64_t searches_ = 0;
  std::variant<SearchOn<Vec3, Exec>, SearchOn<Vec2, Exec>> search_;
};

}  // namespace ballpit
