// SPDX-License-Identifier: MIT
// The bodies of a world in the memory of its executor, and the domain that they move in. Equal radii and equal masses are
// stored as one number each. Now and then the bodies are sorted in memory (spatial_order.h): "slot" is where a body is
// stored, "id" is its number in the scene.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bodies/bodies_view.h"
#include "bodies/body_snapshot.h"
#include "bodies/box.h"
#include "core/span.h"
#include "scene/scene.h"
#include "world/spatial_order.h"

namespace ballpit {

/// Kernel: body i's image inside a periodic domain.
template <class V>
struct Wrap {
  Box<V> box;
  Span<V> position;
  HOST_DEVICE void operator()(int i) const { position[i] = box.wrap(position[i]); }
};

template <class V, class Exec>
class BodyStore {
 public:
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  /// What a snapshot holds of the bodies: their arrays by slot, and their order.
  struct Saved {
    std::vector<V> position, velocity;
    std::vector<Real> radius, inverse_mass;
    std::vector<int> order;
  };

  BodyStore(std::unique_ptr<Exec> exec, const Scene& scene)
      : exec_(std::move(exec)),
        box_{narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary},
        gravity_(narrow<V>(scene.physics.gravity)),
        order_(box_, scene.bodies.size()) {
    upload(scene.bodies);
  }

  Exec& exec() const { return *exec_; }
  const Box<V>& box() const { return box_; }
  const V& gravity() const { return gravity_; }  ///< [m/s²]
  bool has_gravity() const { return dot(gravity_, gravity_) > 0; }
  int64_t count() const { return position.size(); }
  const SpatialOrder<V, Exec>& order() const { return order_; }

  BodiesView<V> view() const { return {position.span(), velocity.span(), per_body(radius_), per_body(inverse_mass_)}; }

  /// Moves what has left a periodic domain back into it.
  void wrap() {
    if (box_.is_periodic()) exec_->parallel_for("wrap", count(), Wrap<V>{box_, position.span()});
  }

  /// Sorts the bodies in memory by where they are; more(rearrange) calls rearrange(values) for other arrays by slot.
  template <class More>
  void sort(const More& more) {
    order_.sort(*exec_, position.span());
    for (Buffer<V>* const values : {&position, &velocity}) order_.rearrange(*exec_, *values, spare_);
    for (Buffer<Real>* const values : {&radius_, &inverse_mass_}) order_.rearrange(*exec_, *values, scalar_spare_);
    more([&](Buffer<V>& values) { order_.rearrange(*exec_, values, spare_); });
    order_.commit(*exec_);
  }

  Saved save() const {
    return {exec_->download(position.span()), exec_->download(velocity.span()), exec_->download(radius_.span()),
            exec_->download(inverse_mass_.span()), order_.save(*exec_)};
  }

  void restore(const Saved& saved) {
    exec_->upload(position, saved.position);
    exec_->upload(velocity, saved.velocity);
    exec_->upload(radius_, saved.radius);
    exec_->upload(inverse_mass_, saved.inverse_mass);
    order_.restore(*exec_, saved.order);
  }

  /// The values of all bodies by id; one value where all are equal.
  template <class T>
  std::vector<T> downloaded(const Buffer<T>& buffer) const {
    return by_id(exec_->download(buffer.span()), exec_->download(order_.id_at()));
  }

  /// The bodies by id, in double precision, at other positions and velocities by slot.
  Bodies download(const Buffer<V>& position_of, const Buffer<V>& velocity_of) const;
  Bodies download() const { return download(position, velocity); }

  std::vector<Real> radii() const { return downloaded(radius_); }

  BodyShape shape() const { return {count(), kDimensions<V>, radius_.size() == 1, largest_radius_, smallest_radius_}; }

  int64_t bytes() const { return position.bytes() + velocity.bytes() + radius_.bytes() + inverse_mass_.bytes(); }

  Buffer<V> position;  ///< [m]
  Buffer<V> velocity;  ///< [m/s]

 private:
  static PerBody<Real> per_body(const Buffer<Real>& buffer) {
    return {buffer.span().data(), buffer.size() == 1 ? 0 : 1};
  }

  void upload(const Bodies& bodies);

  /// One number where all are equal, else one each.
  void upload_per_body(Buffer<Real>& buffer, const std::vector<double>& values) {
    const bool is_uniform = std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
    const auto last = is_uniform && !values.empty() ? values.begin() + 1 : values.end();
    const std::vector<Real> rounded(values.begin(), last);
    exec_->upload(buffer, rounded);
  }

  std::unique_ptr<Exec> exec_;
  Box<V> box_;
  V gravity_;
  SpatialOrder<V, Exec> order_;
  Buffer<Real> radius_, inverse_mass_, scalar_spare_;
  Buffer<V> spare_;                                 // for sorting, as scalar_spare_
  float largest_radius_ = 0, smallest_radius_ = 0;  // [m]
};

template <class V, class Exec>
Bodies BodyStore<V, Exec>::download(const Buffer<V>& position_of, const Buffer<V>& velocity_of) const {
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
void BodyStore<V, Exec>::upload(const Bodies& bodies) {
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

}  // namespace ballpit
