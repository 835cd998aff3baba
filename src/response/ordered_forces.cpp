// SPDX-License-Identifier: MIT
// Highway includes this file once for each instruction set, and selects one when the program runs. Vectors always have
// four lanes: longer ones gain nothing, since positions are loaded one by one.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "response/ordered_forces.cpp"
#include "response/ordered_forces.h"

#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ballpit {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

template <class V>
OrderedFunctions<V> Functions() {
  return {};
}

#else

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::FixedTag<float, 4>;
using Floats = hn::Vec<Lanes>;

/// x, y, z and whatever is stored after them.
template <class V>
HWY_INLINE Floats Load(const V& v) {
  return hn::LoadU(Lanes(), &v.x);
}

template <class V>
int AccelerateBySums(const BodiesView<V>& bodies, const Box<V>& box, const V& gravity, Span<const Vec4> sum,
                     Span<V> acceleration, Span<int> at_walls) {
  Vec4 low(-Box<V>::kFar), high(Box<V>::kFar), g(0);  // infinitely far if there are no walls
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    g[axis] = gravity[axis];
    if (box.is_periodic()) continue;
    low[axis] = box.min[axis];
    high[axis] = box.max[axis];
  }
  const Floats lowest = Load(low), highest = Load(high), pull = Load(g);
  const BodiesView<V> local = bodies;  // which no pointer can alias, so it stays in registers
  const int n = static_cast<int>(acceleration.size());
  int count = 0;
  for (int i = 0; i < n; ++i) {
    const Floats p = Load(local.position[i]), radius = hn::Set(Lanes(), local.radius[i]);
    at_walls[count] = i;
    count += !hn::AllFalse(Lanes(), hn::Or(hn::Le(hn::Sub(p, lowest), radius), hn::Le(hn::Sub(highest, p), radius)));
    const Floats a = hn::Add(pull, hn::Mul(Load(sum[i]), hn::Set(Lanes(), local.inverse_mass[i])));
    hn::StoreU(a, Lanes(), &acceleration[i].x);  // what lies behind is overwritten next
  }
  return count;
}

/// The components of four vectors; in the plane z is not used.
template <class V>
struct Components {
  Floats x, y, z;

  explicit HWY_INLINE Components(const Floats (&v)[4]) {
    const Floats xy01 = hn::InterleaveLower(Lanes(), v[0], v[1]), xy23 = hn::InterleaveLower(Lanes(), v[2], v[3]);
    const Floats zw01 = hn::InterleaveUpper(Lanes(), v[0], v[1]), zw23 = hn::InterleaveUpper(Lanes(), v[2], v[3]);
    x = hn::ConcatLowerLower(Lanes(), xy23, xy01);
    y = hn::ConcatUpperUpper(Lanes(), xy23, xy01);
    z = hn::ConcatLowerLower(Lanes(), zw23, zw01);
  }

  HWY_INLINE Floats Dot(const Components& other) const {
    const Floats plane = hn::Add(hn::Mul(x, other.x), hn::Mul(y, other.y));
    return kDimensions<V> == 2 ? plane : hn::Add(plane, hn::Mul(z, other.z));
  }
};

template <bool kPeriodic, bool kEqual, class V>
class ForceAdder {
 public:
  ForceAdder(const PairForce<V>& force_of, Span<Vec4> sum) : force_of_(force_of), sum_(sum) {
    alignas(16) float period[4] = {1, 1, 1, 1};
    for (int axis = 0; axis < kDimensions<V>; ++axis) period[axis] = force_of.box.max[axis] - force_of.box.min[axis];
    period_ = hn::Load(Lanes(), period);
    if (bodies().size() == 0) return;
    radii_ = hn::Set(Lanes(), bodies().radius[0] + bodies().radius[0]);
    const float mass = 1 / (bodies().inverse_mass[0] + bodies().inverse_mass[0]);
    dashpot_ = hn::Set(Lanes(), force_of.law.dashpot(force_of.law.damping, mass));
  }

  void AddAll(Span<const Pair> pairs) const {
    const ForceAdder self = *this;  // a local copy, which no pointer can alias, stays in registers
    int64_t k = 0;
    for (; k + 4 <= pairs.size(); k += 4) self.AddFour(pairs.data() + k);
    for (; k < pairs.size(); ++k) self.AddOne(pairs[k]);
  }

 private:
  HWY_INLINE const BodiesView<V>& bodies() const { return force_of_.bodies; }

  void AddOne(const Pair& pair) const {
    float along;
    const V force = force_of_(pair, along);
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      sum_[pair.i][axis] -= force[axis];
      sum_[pair.j][axis] += force[axis];
    }
  }

  HWY_INLINE void AddFour(const Pair* pairs) const {
    Floats apart[4];
    for (int k = 0; k < 4; ++k) {
      apart[k] = Displacement(bodies().position[pairs[k].i], bodies().position[pairs[k].j]);
    }
    const Components<V> d(apart);
    const Floats squared = d.Dot(d), radii = RadiiOf(pairs);
    const hn::Mask<Lanes> touching = hn::Le(squared, hn::Mul(radii, radii));
    if (hn::AllFalse(Lanes(), touching)) return;
    if (!hn::AllTrue(Lanes(), hn::Gt(squared, hn::Zero(Lanes())))) {  // centres coincide
      for (int k = 0; k < 4; ++k) AddOne(pairs[k]);
      return;
    }
    const Floats distance = hn::Sqrt(squared);
    const Floats along = ForceAlong(pairs, d, distance, hn::Sub(radii, distance));
    const Floats scale = hn::IfThenElseZero(touching, hn::Div(along, distance));
    Scatter<0>(pairs[0], apart[0], scale);
    Scatter<1>(pairs[1], apart[1], scale);
    Scatter<2>(pairs[2], apart[2], scale);
    Scatter<3>(pairs[3], apart[3], scale);
  }

  HWY_INLINE Floats Displacement(const V& a, const V& b) const {
    Floats d = hn::Sub(Load(b), Load(a));
    if constexpr (kPeriodic) d = hn::Sub(d, hn::Mul(period_, hn::Round(hn::Div(d, period_))));
    return d;
  }

  HWY_INLINE Floats RadiiOf(const Pair* pairs) const {
    if constexpr (kEqual) return radii_;
    alignas(16) float radii[4];
    for (int k = 0; k < 4; ++k) radii[k] = bodies().radius[pairs[k].i] + bodies().radius[pairs[k].j];
    return hn::Load(Lanes(), radii);
  }

  HWY_INLINE Floats DashpotOf(const Pair* pairs) const {
    if constexpr (kEqual) return dashpot_;
    alignas(16) float softness[4];
    for (int k = 0; k < 4; ++k) softness[k] = bodies().inverse_mass[pairs[k].i] + bodies().inverse_mass[pairs[k].j];
    const Floats mass = hn::Div(hn::Set(Lanes(), 1.0f), hn::Load(Lanes(), softness));
    const PenaltyLaw<float>& law = force_of_.law;
    return hn::Mul(hn::Set(Lanes(), law.damping), hn::Sqrt(hn::Mul(hn::Set(Lanes(), law.stiffness), mass)));
  }

  /// PenaltyLaw::force() of four pairs; undefined for those that do not touch.
  HWY_INLINE Floats ForceAlong(const Pair* pairs, const Components<V>& d, Floats distance, Floats overlap) const {
    const PenaltyLaw<float>& law = force_of_.law;
    Floats force = hn::Mul(hn::Set(Lanes(), law.stiffness), overlap);
    if (law.is_hertz) force = hn::Mul(force, hn::Sqrt(overlap));
    if (law.damping > 0) {
      Floats relative[4];
      for (int k = 0; k < 4; ++k) {
        relative[k] = hn::Sub(Load(bodies().velocity[pairs[k].j]), Load(bodies().velocity[pairs[k].i]));
      }
      const Floats separation = hn::Div(Components<V>(relative).Dot(d), distance);
      const Floats damped = hn::Mul(DashpotOf(pairs), separation);
      const Floats factor = law.is_hertz
                                ? hn::Mul(hn::Set(Lanes(), PenaltyLaw<float>::kRootOf5), hn::Sqrt(hn::Sqrt(overlap)))
                                : hn::Set(Lanes(), 2.0f);
      force = hn::Sub(force, hn::Mul(damped, factor));
    }
    return law.ends_with_force ? hn::Max(force, hn::Zero(Lanes())) : force;
  }

  template <int kLane>
  HWY_INLINE void Scatter(const Pair& pair, Floats apart, Floats scale) const {
    const Floats force = hn::Mul(apart, hn::Broadcast<kLane>(scale));
    Vec4& a = sum_[pair.i];
    Vec4& b = sum_[pair.j];
    hn::StoreU(hn::Sub(Load(a), force), Lanes(), &a.x);
    hn::StoreU(hn::Add(Load(b), force), Lanes(), &b.x);
  }

  PairForce<V> force_of_;
  Span<Vec4> sum_;
  Floats period_, radii_, dashpot_;
};

template <class V>
void AddForces(const PairForce<V>& force_of, Span<const Pair> pairs, Span<Vec4> sum) {
  const bool is_equal = force_of.bodies.radius.is_uniform() && force_of.bodies.inverse_mass.is_uniform();
  if (force_of.box.is_periodic()) {
    is_equal ? ForceAdder<true, true, V>(force_of, sum).AddAll(pairs)
             : ForceAdder<true, false, V>(force_of, sum).AddAll(pairs);
  } else {
    is_equal ? ForceAdder<false, true, V>(force_of, sum).AddAll(pairs)
             : ForceAdder<false, false, V>(force_of, sum).AddAll(pairs);
  }
}

template <class V>
OrderedFunctions<V> Functions() {
  return {AddForces<V>, AccelerateBySums<V>};
}

#endif

OrderedFunctions<Vec2> Functions2() { return Functions<Vec2>(); }
OrderedFunctions<Vec3> Functions3() { return Functions<Vec3>(); }

}  // namespace HWY_NAMESPACE
}  // namespace ballpit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ballpit {

HWY_EXPORT(Functions2);
HWY_EXPORT(Functions3);

template <>
OrderedFunctions<Vec2> ordered_functions() {
  return HWY_DYNAMIC_DISPATCH(Functions2)();
}
template <>
OrderedFunctions<Vec3> ordered_functions() {
  return HWY_DYNAMIC_DISPATCH(Functions3)();
}

}  // namespace ballpit
#endif
