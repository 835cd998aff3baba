// SPDX-License-Identifier: MIT
// The pair search, written once for every executor. Spheres whose centres all have one z are searched in the plane.
// Instantiated by backend_cpu.cpp and cuda/backend_cuda.cu.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "simulate/choose_broad_phase.h"
#include "simulate/detector.h"
#include "simulate/pair_search.h"

namespace ballpit {

template <class V, class Exec>
class SearchOn {
  using Real = Scalar<V>;

 public:
  /// Starts anew for these spheres, in the memory held.
  void plan(Exec& exec, const Settings& settings, const Box<V>& box, const SphereArrays& spheres) {
    auto parameters = broad_phase_parameters<V>(settings, box, spheres.radius, spheres.position.size());
    parameters.occupied_volume = occupied_volume(box, spheres.position);
    choice_ = choose_broad_phase(settings, parameters);
    detector_.plan(choice_.method, parameters, skin_of(settings));
    exec.upload(radius_, spheres.radius.data(), spheres.radius.size());
  }

  void find(Exec& exec, const SphereArrays& spheres) {
    if constexpr (kDimensions<V> == 3) {
      exec.upload(position_, spheres.position.data(), spheres.position.size());
    } else {
      std::vector<V> flat(static_cast<size_t>(spheres.position.size()));
      std::transform(spheres.position.begin(), spheres.position.end(), flat.begin(),
                     [](const Vec3& p) { return V(p); });
      exec.upload(position_, flat.data(), spheres.position.size());
    }
    detector_.find(exec, bodies());
  }

  Detector<V, Exec>& detector() { return detector_; }
  const BroadPhaseChoice& choice() const { return choice_; }
  int64_t bytes() const { return detector_.bytes() + position_.bytes() + radius_.bytes(); }

 private:
  BodiesView<V> bodies() const {
    return {position_.span(), {}, {radius_.span().data(), radius_.size() == 1 ? 0 : 1}, {}};
  }

  BroadPhaseChoice choice_;
  Detector<V, Exec> detector_;
  typename Exec::template Buffer<V> position_;
  typename Exec::template Buffer<Real> radius_;
};

template <class Exec>
class PairSearchOn final : public PairSearch {
 public:
  PairSearchOn(std::unique_ptr<Exec> exec, const Settings& settings) : exec_(std::move(exec)), settings_(settings) {
    if (!settings_.skin) settings_.skin = 0.0;
  }

  void find(const SphereArrays& spheres) override {
    if (!may_go_on(spheres)) start(spheres, bounds(spheres.position));
    visit([&](auto& search) { search.find(*exec_, spheres); });
  }

  std::vector<Pair> pairs() override {
    std::vector<Pair> result;
    visit([&](auto& search) { result = exec_->download(search.detector().pairs()); });
    return result;
  }

  SearchReport report() override {
    SearchReport report;
    visit([&](auto& search) {
      report.method = search.choice().method;
      report.reason = search.choice().reason;
      report.candidates = search.detector().candidates(*exec_);
      report.contacts = search.detector().pairs().size();
      report.searches = searches_ + search.detector().searches();
      report.bytes = search.bytes();
    });
    report.stages = exec_->stage_times().stages();
    return report;
  }

  std::vector<int> work_per_thread() override {
    std::vector<int> work;
    visit([&](auto& search) { work = search.detector().work_per_thread(*exec_); });
    return work;
  }

 private:
  static Box<Vec3> bounds(Span<const Vec3> position) {
    Box<Vec3> box;
    box.boundary = Boundary::walls;
    if (position.empty()) return box;
    box.min = box.max = position[0];
    for (const Vec3& p : position) {
      box.min = glm::min(box.min, p);
      box.max = glm::max(box.max, p);
    }
    return box;
  }

  /// Whether the grid of the last search may serve for these spheres: with a skin, while their sizes are the same. Spheres that
  /// have left its box count to the cells at its border, which is right but slow: so now and then there is a new box.
  bool may_go_on(const SphereArrays& spheres) {
    if (*settings_.skin == 0 || count_ != spheres.position.size()) return false;
    if (!std::equal(spheres.radius.begin(), spheres.radius.end(), radius_.begin(), radius_.end())) return false;
    int64_t searches = 0;
    visit([&](auto& search) { searches = search.detector().searches(); });
    return searches < kSearchesInABox;
  }

  void start(const SphereArrays& spheres, const Box<Vec3>& box) {
    visit([&](auto& search) { searches_ += search.detector().searches(); });
    count_ = spheres.position.size();
    if (*settings_.skin > 0) radius_.assign(spheres.radius.begin(), spheres.radius.end());
    const bool is_planar = count_ > 0 && box.min.z == box.max.z && settings_.axis != "z";
    if (is_planar && *settings_.skin == 0) {  // with a skin, they may leave the plane
      spatial_.reset();
      if (!planar_) planar_.emplace();
      planar_->plan(*exec_, settings_, Box<Vec2>{Vec2(box.min), Vec2(box.max), Boundary::walls}, spheres);
    } else {
      planar_.reset();
      if (!spatial_) spatial_.emplace();
      spatial_->plan(*exec_, settings_, box, spheres);
    }
  }

  template <class Visit>
  void visit(Visit&& visit) {
    if (planar_) visit(*planar_);
    if (spatial_) visit(*spatial_);
  }

  static constexpr int64_t kSearchesInABox = 8;

  std::unique_ptr<Exec> exec_;
  Settings settings_;
  int64_t count_ = -1;
  std::vector<float> radius_;  // of the last start, where there is a skin
  int64_t searches_ = 0;
  std::optional<SearchOn<Vec2, Exec>> planar_;
  std::optional<SearchOn<Vec3, Exec>> spatial_;
};

}  // namespace ballpit
