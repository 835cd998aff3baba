// SPDX-License-Identifier: MIT
// Sums the forces of the penalty response on one thread of the CPU in single precision. It goes along the pairs, four
// at a time, and adds each force to both bodies. Each pair is read once, nothing is stored for it, and bodies need no
// contact lists. The arithmetic and its order are those of PairForce and GatherForces, so the results are
// bit-identical.
//
//     pairs   (0,3) (0,7) (2,5) (3,4)      four displacements, transposed into x x x x, y y y y, z z z z
//     force   f     f     0     f          four forces; 0 if a pair does not touch
//     sum[i] −= f, sum[j] += f             pair after pair
//
// Measured on beds of 10 000 spheres (bench_beds): 3.4 times as fast as the kernels on one thread if dense, 1.7 times if
// loose; so it is used where there are at most two. A kernel that adds each force to both bodies without vector
// instructions is only 1.15 times as fast.
#pragma once

#include <type_traits>

#include "exec/cpu_executor.h"
#include "response/pair_force.h"

namespace ballpit {

template <class V, class Exec>
inline constexpr bool kHasOrderedForces = std::is_same_v<Exec, CpuExecutor>&& std::is_same_v<Scalar<V>, float>;

/// The sums, by the best instructions of this processor; null if it has none. Positions, velocities and accelerations
/// are those of a HostBuffer: each is read or written as a whole register.
template <class V>
struct OrderedFunctions {
  /// sum[i] −= f, sum[j] += f for each pair, in their order.
  void (*add_forces)(const PairForce<V>& force_of, Span<const Pair> pairs, Span<Vec4> sum) = nullptr;

  /// acceleration[i] = gravity + sum[i] · inverse mass for each body [m/s²]. Writes the bodies that touch a wall, or
  /// nearly do, to `at_walls`, and returns their number.
  int (*accelerate)(const BodiesView<V>& bodies, const Box<V>& box, const V& gravity, Span<const Vec4> sum,
                    Span<V> acceleration, Span<int> at_walls) = nullptr;
};

/// For Vec2 and Vec3.
template <class V>
OrderedFunctions<V> ordered_functions();

/// For other executors and precisions: empty.
template <class V, class Exec>
class OrderedForces {
 public:
  int64_t bytes() const { return 0; }
};

template <class V>
requires kHasOrderedForces<V, CpuExecutor>
class OrderedForces<V, CpuExecutor> {
 public:
  /// Whether the processor has the instructions.
  bool is_available() const { return functions_.add_forces != nullptr; }

  /// All accelerations without the walls' forces [m/s²]. Returns the bodies that may touch a wall, ascending.
  template <class State>
  Span<const int> accelerate(State& state, Span<const Pair> pairs, const PenaltyLaw<float>& law, Span<V> acceleration) {
    CpuExecutor& exec = state.exec();
    const BodiesView<V> bodies = state.view();
    const int64_t n = bodies.size();
    sum_.resize(n);
    at_walls_.resize(state.box().is_periodic() ? 1 : n);  // the entry after the last is always written
    exec.fill("clear forces", sum_.span(), Vec4(0));
    exec.parallel_for_blocks("pair forces", 1, [&](int64_t) {
      functions_.add_forces(PairForce<V>{law, bodies, state.box()}, pairs, sum_.span());
    });
    int count = 0;
    exec.parallel_for_blocks("accelerate", 1, [&](int64_t) {
      count = functions_.accelerate(bodies, state.box(), state.gravity(), sum_.span(), acceleration, at_walls_.span());
    });
    return {at_walls_.span().data(), count};
  }

  /// After accelerate(): the sums of the pairs' forces [N], in x, y and z.
  Span<const Vec4> sum() const { return sum_.span(); }

  int64_t bytes() const { return sum_.bytes() + at_walls_.bytes(); }

 private:
  OrderedFunctions<V> functions_ = ordered_functions<V>();
  HostBuffer<Vec4> sum_;
  HostBuffer<int> at_walls_;
};

}  // namespace ballpit
