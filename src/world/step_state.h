// SPDX-License-Identifier: MIT
// What a substep works on: the bodies, the domain, and the contacts of the present positions, found when they are asked for.
//
//     motion ──contacts()──▶ detector ──▶ contact list        once for the same positions
//        └── writes position, velocity ──moved()──▶ the next contacts() searches again
//
// Equal radii and equal masses are one number each.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bodies/bodies_view.h"
#include "bodies/body_snapshot.h"
#include "bodies/box.h"
#include "bodies/contacts.h"
#include "bodies/pair.h"
#include "broad_phase/choose_broad_phase.h"
#include "core/span.h"
#include "narrow_phase/collider.h"
#include "narrow_phase/contact_list.h"
#include "world/spatial_order.h"

namespace ballpit {

/// Kernel: body i's image inside a periodic domain.
template <class V>
struct Wrap {
  Box<V> box;
  Span<V> position;
  HOST_DEVICE void operator()(int i) const { position[i] = box.wrap(position[i]); }
};

/// Kernel: radii with a margin.
template <class Real>
struct AddMargin {
  Span<const Real> radius;
  Real margin;
  Span<Real> grown;
  HOST_DEVICE void operator()(int i) const { grown[i] = radius[i] + margin; }
};

template <class V, class Exec>
class StepState {
 public:
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  /// `margin` [m]: how near spheres are to be for near_contacts().
  StepState(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings, double margin = 0)
      : exec_(std::move(exec)),
        box_{narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary},
        gravity_(narrow<V>(scene.physics.gravity)),
        margin_(static_cast<Real>(margin)),
        parameters_(parameters_of(settings, scene.bodies.size(), narrowed(scene.bodies.radius))),
        choice_(choose_broad_phase(settings, parameters_)),
        detector_(choice_.method, parameters_, skin_of(settings)),
        order_(box_, scene.bodies.size()) {
    upload(scene.bodies);
  }

  Exec& exec() { return *exec_; }
  const Box<V>& box() const { return box_; }
  const V& gravity() const { return gravity_; }  ///< [m/s²]
  bool has_gravity() const { return dot(gravity_, gravity_) > 0; }
  int64_t count() const { return position.size(); }
  const BroadPhaseParameters<V>& parameters() const { return parameters_; }
  const BroadPhaseChoice& choice() const { return choice_; }
  Detector<V, Exec>& detector() { return detector_; }
  SpatialOrder<V, Exec>& order() { return order_; }

  BodiesView<V> bodies() const {
    return {position.span(), velocity.span(), per_body(radius_), per_body(inverse_mass_)};
  }

  /// Contacts are found so from now on. What cannot be, or lacks memory for it, throws before anything has changed.
  void detect_by(const Settings& settings);

  /// The pairs in contact at the present positions, in canonical order.
  Span<const Pair> pairs() {
    detect();
    return detector_.pairs();
  }

  /// The same, measured with the present velocities and listed by body.
  ContactsView<V> contacts();

  /// Pairs among which all contacts are, in canonical order, found once for the same positions.
  const NearPairs& near_pairs();

  /// The same, listed by body, and not measured; listed anew only where the pairs are others.
  ContactsView<V> linked_near_pairs();

  /// The contacts of spheres whose radii are larger by the margin: those that touch, and those that may come to touch while
  /// positions are changed a little. Measured as they are, so overlaps may be negative.
  ContactsView<V> near_contacts();

  /// To be called by whoever has changed positions. They may have left a periodic domain.
  void moved();

  /// Whether the candidate list shows that all bodies are inside the domain; no pass over them then, but the list's own.
  bool shows_all_inside() { return detector_.shows_all_inside(*exec_, bodies()); }

  /// Sorts the bodies in memory by where they are; `more` rearranges what others keep for each body.
  template <class More>
  void sort(const More& more) {
    order_.sort(*exec_, position.span());
    order_.rearrange(*exec_, position, spare_);
    order_.rearrange(*exec_, velocity, spare_);
    order_.rearrange(*exec_, radius_, scalar_spare_);
    order_.rearrange(*exec_, inverse_mass_, scalar_spare_);
    more([&](Buffer<V>& values) { order_.rearrange(*exec_, values, spare_); });
    order_.commit(*exec_);
    forget_contacts();
  }

  /// Calls visit(values) for what a snapshot holds; restored() is to follow where it was put back. Contacts and candidate
  /// lists are not in it: they are found again, and the same.
  template <class Visit>
  void for_each_saved(const Visit& visit) {
    visit(position);
    visit(velocity);
    visit(radius_);
    visit(inverse_mass_);
    order_.for_each_saved(visit);
  }
  void restored() {
    order_.restored(*exec_);
    forget_contacts();
  }

  /// The values of all bodies by id; one value where all are equal.
  template <class T>
  std::vector<T> downloaded(const Buffer<T>& buffer) const {
    return by_id(exec_->download(buffer.span()), exec_->download(order_.id_at()));
  }

  /// In double precision, by id.
  Bodies download(const Buffer<V>& position_of, const Buffer<V>& velocity_of) const;

  std::vector<Real> radii() const { return downloaded(radius_); }

  BodyShape shape() const { return {count(), kDimensions<V>, radius_.size() == 1, largest_radius_, smallest_radius_}; }

  /// Memory of the bodies themselves.
  int64_t bytes() const { return position.bytes() + velocity.bytes() + radius_.bytes() + inverse_mass_.bytes(); }

  Buffer<V> position;  ///< [m]
  Buffer<V> velocity;  ///< [m/s]

 private:
  static std::vector<Real> narrowed(const std::vector<double>& values) { return {values.begin(), values.end()}; }

  /// `radius` [m]: one for all, or one each.
  BroadPhaseParameters<V> parameters_of(const Settings& settings, int64_t count,
                                        const std::vector<Real>& radius) const {
    const Span<const Real> span(radius.data(), static_cast<int64_t>(radius.size()));
    auto parameters = broad_phase_parameters<V>(settings, box_, span, count);
    for (SizeClass<V>& spheres : parameters.classes) spheres.largest += margin_;
    return parameters;
  }

  static PerBody<Real> per_body(const Buffer<Real>& buffer) {
    return {buffer.span().data(), buffer.size() == 1 ? 0 : 1};
  }

  void upload(const Bodies& bodies) {
    std::vector<V> positions, velocities;
    for (const Vec3d& p : bodies.position) positions.push_back(box_.wrap(narrow<V>(p)));
    for (const Vec3d& v : bodies.velocity) velocities.push_back(narrow<V>(v));
    exec_->upload(position, positions);
    exec_->upload(velocity, velocities);
    std::vector<double> inverse_mass;
    for (const double mass : bodies.mass) inverse_mass.push_back(1.0 / mass);
    upload_per_body(radius_, bodies.radius);
    upload_per_body(inverse_mass_, inverse_mass);
    if (bodies.radius.empty()) return;
    const auto [least, most] = std::minmax_element(bodies.radius.begin(), bodies.radius.end());
    smallest_radius_ = static_cast<float>(*least);
    largest_radius_ = static_cast<float>(*most);
  }

  /// One number where all are equal, else one each.
  void upload_per_body(Buffer<Real>& buffer, const std::vector<double>& values) {
    const bool is_uniform = std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
    const auto last = is_uniform && !values.empty() ? values.begin() + 1 : values.end();
    const std::vector<Real> rounded(values.begin(), last);
    exec_->upload(buffer, rounded);
  }

  /// The bodies, or their places, are others now.
  void forget_contacts() {
    detector_.discard();
    linked_version_ = -1;
    is_detected_ = has_near_pairs_ = false;
  }

  void detect();

  std::unique_ptr<Exec> exec_;
  Box<V> box_;
  V gravity_;
  Real margin_;  // [m]
  BroadPhaseParameters<V> parameters_;
  BroadPhaseChoice choice_;
  Detector<V, Exec> detector_;
  SpatialOrder<V, Exec> order_;
  ContactList<V, Exec> list_;
  Buffer<Real> radius_, inverse_mass_, scalar_spare_, grown_;
  float largest_radius_ = 0, smallest_radius_ = 0;  // [m]
  Buffer<V> spare_;                                 // for sorting
  ContactList<V, Exec> near_list_;
  NearPairs near_pairs_;
  int64_t linked_version_ = -1;
  bool is_detected_ = false, has_near_pairs_ = false;
  bool is_list_without_margin_ = false;  // it lacks what near_contacts() asks for
};

template <class V, class Exec>
void StepState<V, Exec>::detect_by(const Settings& settings) {
  auto parameters = parameters_of(settings, count(), radii());
  BroadPhaseChoice choice = choose_broad_phase(settings, parameters);
  Detector<V, Exec> detector(choice.method, parameters, skin_of(settings));
  detector.find(*exec_, bodies());
  parameters_ = std::move(parameters);
  choice_ = std::move(choice);
  detector_ = std::move(detector);
  forget_contacts();
  is_list_without_margin_ = false;
}

template <class V, class Exec>
ContactsView<V> StepState<V, Exec>::contacts() {
  detect();
  list_.build(*exec_, detector_.pairs(), detector_.first(), bodies(), box_);
  return list_.view();
}

template <class V, class Exec>
const NearPairs& StepState<V, Exec>::near_pairs() {
  if (has_near_pairs_) return near_pairs_;
  const bool are_found = is_detected_ && !detector_.has_used_list();
  const int64_t searches = detector_.searches();
  near_pairs_ = are_found ? detector_.contacts() : detector_.near_pairs(*exec_, bodies());
  is_list_without_margin_ |= detector_.searches() > searches;
  has_near_pairs_ = true;
  is_detected_ = is_detected_ || near_pairs_.are_contacts;
  return near_pairs_;
}

template <class V, class Exec>
ContactsView<V> StepState<V, Exec>::linked_near_pairs() {
  const NearPairs& near = near_pairs();
  if (linked_version_ != near.version) {
    near_list_.link(*exec_, near.pairs, near.first);
    linked_version_ = near.version;
  }
  return near_list_.view();
}

template <class V, class Exec>
ContactsView<V> StepState<V, Exec>::near_contacts() {
  grown_.resize(radius_.size());
  exec_->parallel_for("grow radii", grown_.size(), AddMargin<Real>{radius_.span(), margin_, grown_.span()});
  BodiesView<V> grown = bodies();
  grown.radius = per_body(grown_);
  if (is_list_without_margin_) detector_.discard();
  is_list_without_margin_ = false;
  detector_.find(*exec_, grown);
  is_detected_ = false;
  list_.build(*exec_, detector_.pairs(), detector_.first(), bodies(), box_);
  return list_.view();
}

template <class V, class Exec>
void StepState<V, Exec>::moved() {
  if (box_.is_periodic()) exec_->parallel_for("wrap", count(), Wrap<V>{box_, position.span()});
  detector_.moved();
  is_detected_ = has_near_pairs_ = false;
}

template <class V, class Exec>
Bodies StepState<V, Exec>::download(const Buffer<V>& position_of, const Buffer<V>& velocity_of) const {
  Bodies result;
  for (const V& p : downloaded(position_of)) result.position.push_back(widen(p));
  for (const V& v : downloaded(velocity_of)) result.velocity.push_back(widen(v));
  const auto radius = downloaded(radius_), inverse = downloaded(inverse_mass_);
  for (size_t i = 0; i < result.position.size(); ++i) {
    result.radius.push_back(radius[radius.size() == 1 ? 0 : i]);
    result.mass.push_back(1.0 / inverse[inverse.size() == 1 ? 0 : i]);
  }
  return result;
}

template <class V, class Exec>
void StepState<V, Exec>::detect() {
  if (is_detected_) return;
  const int64_t searches = detector_.searches();
  detector_.find(*exec_, bodies());
  is_detected_ = true;
  has_near_pairs_ = false;  // where there is no candidate list, these were its memory
  is_list_without_margin_ |= detector_.searches() > searches;
}

}  // namespace ballpit
