// SPDX-License-Identifier: MIT
// The bodies of a world in the memory of its executor, and their domain. Equal radii and equal masses are stored as one number
// each. Bodies are sorted in memory (spatial_order.h): "slot" is where one is stored, "id" is its number in the scene.
#pragma once

#include <memory>

#include "bodies/bodies_view.h"
#include "exec/atomics.h"
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

    int id(int slot) const { return order.empty() ? slot : order[static_cast<size_t>(slot)]; }
    BodiesView<V> view() const {
      const auto span = [](const auto& values) { return Span(values.data(), static_cast<int64_t>(values.size())); };
      return {span(position), span(velocity), span(radius), span(inverse_mass)};
    }
  };

  BodyStore(std::unique_ptr<Exec> exec, const Scene& scene)
      : exec_(std::move(exec)),
        box_{narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary},
        gravity_(narrow<V>(scene.physics.gravity)),
        order_(box_, scene.bodies.size()) {
    upload(scene.bodies);
  }

  /// From now on holds these bodies, each stored at its id.
  void replace(const Bodies& bodies) {
    order_ = SpatialOrder<V, Exec>(box_, bodies.size());
    upload(bodies);
  }

  Exec& exec() const { return *exec_; }
  const Box<V>& box() const { return box_; }
  const V& gravity() const { return gravity_; }  ///< [m/s²]
  bool has_gravity() const { return dot(gravity_, gravity_) > 0; }
  int64_t count() const { return position.size(); }
  const SpatialOrder<V, Exec>& order() const { return order_; }

  BodiesView<V> view() const { return {position.span(), velocity.span(), radius_.span(), inverse_mass_.span()}; }

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
    const auto saved_count = static_cast<int64_t>(saved.position.size());
    if (saved_count != count()) order_ = SpatialOrder<V, Exec>(box_, saved_count);
    exec_->upload(position, saved.position);
    exec_->upload(velocity, saved.velocity);
    exec_->upload(radius_, saved.radius);
    exec_->upload(inverse_mass_, saved.inverse_mass);
    note_radii(saved.radius);
    order_.restore(*exec_, saved.order);
  }

  /// The values of all bodies by id; one value where all are equal.
  template <class T>
  std::vector<T> downloaded(const Buffer<T>& buffer) const {
    std::vector<T> values = exec_->download(buffer.span());
    const std::vector<int> id_at = exec_->download(order_.id_at());
    if (values.size() != id_at.size()) return values;
    std::vector<T> result(values.size());
    for (size_t slot = 0; slot < values.size(); ++slot) result[static_cast<size_t>(id_at[slot])] = values[slot];
    return result;
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
  void upload(const Bodies& bodies);

  template <class T>
  void note_radii(const std::vector<T>& radius) {
    if (radius.empty()) return;
    const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
    smallest_radius_ = static_cast<float>(*least);
    largest_radius_ = static_cast<float>(*most);
  }

  /// One number where all are equal, else one each.
  void upload_per_body(Buffer<Real>& buffer, const std::vector<double>& values) {
    const bool is_uniform = std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
    const auto last = is_uniform && !values.empty() ? values.begin() + 1 : values.end();
    exec_->upload(buffer, std::vector<Real>(values.begin(), last));
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
  note_radii(bodies.radius);
}

template <class V>
HOST_DEVICE void write_body(const BodyTarget& target, int64_t id, const V& position, double radius) {
  constexpr int d = kDimensions<V>;
  for (int axis = 0; axis < d; ++axis) target.position[id * d + axis] = static_cast<float>(position[axis]);
  if (!target.radius.empty()) target.radius[id] = static_cast<float>(radius);
}

/// Kernel: the bodies of pair k touch.
struct NoteTouching {
  Span<const Pair> pairs;
  Span<int> touching;  // by slot
  HOST_DEVICE void operator()(int k) const {
    atomic_exchange(&touching[pairs[k].i], 1);
    atomic_exchange(&touching[pairs[k].j], 1);
  }
};

/// Kernel: writes the body in a slot.
template <class V>
struct WriteBody {
  BodiesView<V> bodies;
  Span<const int> id_at, touching;
  BodyTarget target;

  HOST_DEVICE void operator()(int slot) const {
    const int id = id_at.empty() ? slot : id_at[slot];
    write_body(target, id, bodies.position[slot], double(bodies.radius[slot]));
    target.touching[id] = static_cast<uint8_t>(touching[slot]);
  }
};

/// `pairs` are in contact.
template <class V, class Exec>
void write_bodies(const BodyStore<V, Exec>& bodies, Span<const Pair> pairs, const BodyTarget& target) {
  Exec& exec = bodies.exec();
  const Span<int> touching = exec.template scratch<int>(0, bodies.count());
  exec.fill("write bodies", touching, 0);
  exec.parallel_for("write bodies", pairs.size(), NoteTouching{pairs, touching});
  exec.parallel_for("write bodies", bodies.count(),
                    WriteBody<V>{bodies.view(), bodies.order().id_at(), touching, target});
}

}  // namespace ballpit
