// SPDX-License-Identifier: MIT
// Highway includes this file once for each instruction set, and selects one when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/cell_tests.cpp"
#include "narrow_phase/cell_tests.h"

#include <algorithm>

#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "narrow_phase/range_tester-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ballpit {
namespace HWY_NAMESPACE {

/// Slots, each with a row of cells to be tested: buckets first … last − 1.
struct RowQueue {
  static constexpr int kCapacity = 1024;
  int slot[kCapacity + kSlotPadding], first[kCapacity + kSlotPadding], last[kCapacity + kSlotPadding];
  int count = 0;

  HWY_INLINE void Push(hn::Mask<Ints> mask, hn::Vec<Ints> slots, hn::Vec<Ints> firsts, hn::Vec<Ints> lasts) {
    const Ints d;
    hn::StoreU(Compress(slots, mask), d, slot + count);
    hn::StoreU(Compress(firsts, mask), d, first + count);
    hn::StoreU(Compress(lasts, mask), d, last + count);
    count += static_cast<int>(hn::CountTrue(d, mask));
  }
  bool IsFull() const { return count > kCapacity - kSlotPadding; }
};

/// Grid's functions for a vector of positions, by the same operations.
template <class V>
class GridVectors {
 public:
  explicit GridVectors(const Grid<V>& grid) : grid_(grid) {}

  HWY_INLINE hn::Vec<Floats> Scaled(hn::Vec<Floats> p, int axis) const {
    const Floats f;
    return hn::Mul(hn::Sub(p, hn::Set(f, grid_.origin[axis])), hn::Set(f, grid_.inverse_edge[axis]));
  }

  HWY_INLINE hn::Vec<Ints> Coordinate(hn::Vec<Floats> scaled, int axis) const {
    const Floats f;
    const hn::Vec<Floats> first = hn::Set(f, float(grid_.border));
    const hn::Vec<Floats> last = hn::Set(f, float(grid_.cells[axis] - 1 - grid_.border));
    const hn::Vec<Floats> limited = hn::IfThenElse(hn::Lt(scaled, last), scaled, last);
    return hn::ConvertTo(Ints(), hn::IfThenElse(hn::Gt(limited, first), limited, first));
  }

  HWY_INLINE hn::Vec<Ints> Index(hn::Vec<Ints> x, hn::Vec<Ints> y, hn::Vec<Ints> z) const {
    const Ints d;
    const hn::Vec<Ints> row = hn::Add(hn::Mul(z, hn::Set(d, grid_.cells.y)), y);
    return hn::Add(hn::Mul(row, hn::Set(d, grid_.cells.x)), x);
  }

  int Size() const { return static_cast<int>(grid_.size()); }

  /// How many buckets row (y, z) lies after row (0, 0).
  int Distance(int y, int z) const { return (z * grid_.cells.y + y) * grid_.cells.x; }

 private:
  Grid<V> grid_;
};

/// Tests slots against spheres of class k.
template <bool kEqual, class V>
class CellTester {
  static constexpr int kDims = kDimensions<V>;

 public:
  CellTester(const DenseCells<V>& cells, int k)
      : slots_(cells.slots),
        offsets_(cells.offsets.data()),
        first_bucket_(cells.grids.first_bucket[k]),
        diameter_(cells.grids.diameter[k]),
        largest_(cells.grids.largest[k]),
        guard_(cells.grids.guard),
        grid_(cells.grids.grid[k]),
        tester_(cells.slots, V(0)) {}

  /// Tests slots of class k against what comes after each, as visit_dense_half() does. Returns the number of tests.
  int64_t TestHalf(int first, int last, PairBuffer& found) const {
    const CellTester self = *this;  // a local copy, which no pointer can alias, stays in registers
    Hits memory[HitQueue::kCapacity + 1];
    HitQueue hits{memory};
    RowQueue rows;
    int bucket[kBatch + kSlotPadding];
    int64_t tested = 0;
    for (int begin = first, end; begin < last; begin = end) {
      end = std::min(last, begin + kBatch);
      self.FindHalf(begin, end, bucket, rows);
      for (int s = begin; s < end; ++s) {
        tested += self.Test(s, s + 1, self.offsets_[bucket[s - begin] + 2], hits, found);
      }
      tested += self.TestRows(rows, hits, found);
    }
    self.tester_.Flush(hits, found);
    return tested;
  }

  /// Tests slots of a coarser class against the rows that each reaches, as visit_reach() does.
  int64_t TestReach(int first, int last, PairBuffer& found) const {
    const CellTester self = *this;
    Hits memory[HitQueue::kCapacity + 1];
    HitQueue hits{memory};
    RowQueue rows;
    int64_t tested = 0;
    const int lanes = static_cast<int>(hn::Lanes(Ints()));
    for (int s = first; s < last; s += lanes) self.FindReach(s, last, rows, hits, found, tested);
    tested += self.TestRows(rows, hits, found);
    self.tester_.Flush(hits, found);
    return tested;
  }

 private:
  static constexpr int kBatch = 240;  // slots, so that their rows fit into the queue

  /// Finds each slot's bucket and the rows after its own that it reaches.
  HWY_INLINE void FindHalf(int first, int last, int* bucket, RowQueue& rows) const {
    const Floats f;
    const Ints d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto exceeds = [&](hn::Vec<Floats> a, hn::Vec<Floats> b) { return hn::RebindMask(d, hn::Gt(a, b)); };
    for (int s = first; s < last; s += lanes) {
      const hn::Mask<Ints> inside = hn::FirstN(d, static_cast<size_t>(last - s));
      const hn::Vec<Ints> slot = hn::Iota(d, s);
      const hn::Vec<Floats> scaled_y = Scaled(s, 1);
      const hn::Vec<Ints> x = grid_.Coordinate(Scaled(s, 0), 0), y = grid_.Coordinate(scaled_y, 1);
      const hn::Vec<Floats> in_y = hn::Sub(scaled_y, hn::ConvertTo(f, y));
      const hn::Mask<Ints> up = hn::And(inside, exceeds(in_y, hn::Set(f, 1 - diameter_[1])));
      hn::Vec<Ints> own = Bucket(x, y, hn::Zero(d));
      if constexpr (kDims == 3) {
        const hn::Vec<Floats> scaled_z = Scaled(s, 2);
        const hn::Vec<Ints> z = grid_.Coordinate(scaled_z, 2);
        const hn::Vec<Floats> in_z = hn::Sub(scaled_z, hn::ConvertTo(f, z));
        const hn::Mask<Ints> front = hn::And(inside, exceeds(in_z, hn::Set(f, 1 - diameter_[2])));
        const hn::Mask<Ints> down = exceeds(hn::Set(f, diameter_[1]), in_y);
        own = Bucket(x, y, z);
        PushBlock(hn::And(front, down), slot, own, grid_.Distance(-1, 1), rows);
        PushBlock(front, slot, own, grid_.Distance(0, 1), rows);
        PushBlock(hn::And(front, up), slot, own, grid_.Distance(1, 1), rows);
      }
      PushBlock(up, slot, own, grid_.Distance(1, 0), rows);
      hn::StoreU(own, d, bucket + (s - first));
    }
  }

  /// Finds the rows that a vector of slots reaches: row (0, 0) of all, row (1, 0) of those that reach so many, …
  HWY_INLINE void FindReach(int first, int last, RowQueue& rows, HitQueue& hits, PairBuffer& found,
                            int64_t& tested) const {
    const Floats f;
    const Ints d;
    const hn::Vec<Floats> radii = hn::Add(hn::LoadU(f, slots_.radius.data() + first), hn::Set(f, largest_));
    const hn::Vec<Floats> reach = hn::Add(hn::Mul(radii, hn::Set(f, 1.000001f)), hn::Set(f, guard_));
    hn::Vec<Ints> low[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    hn::Vec<Ints> high[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    for (int axis = 0; axis < kDims; ++axis) {
      const hn::Vec<Floats> p = hn::LoadU(f, slots_.coordinate[axis].data() + first);
      low[axis] = grid_.Coordinate(grid_.Scaled(hn::Sub(p, reach), axis), axis);
      high[axis] = grid_.Coordinate(grid_.Scaled(hn::Add(p, reach), axis), axis);
    }
    const hn::Vec<Ints> slot = hn::Iota(d, first), one = hn::Set(d, 1);
    const hn::Vec<Ints> height = hn::Sub(high[1], low[1]), depth = hn::Sub(high[2], low[2]);
    const hn::Mask<Ints> inside = hn::FirstN(d, static_cast<size_t>(last - first));
    // Where a sphere reaches more rows than the class has spheres, testing all of them is faster.
    const int end_bucket = first_bucket_ + grid_.Size();
    const hn::Vec<Ints> spheres = hn::Set(d, offsets_[end_bucket] - offsets_[first_bucket_]);
    const hn::Vec<Ints> lookups = hn::Mul(hn::Add(height, one), hn::Add(depth, one));
    const hn::Mask<Ints> takes_all = hn::And(inside, hn::Gt(lookups, spheres));
    rows.Push(takes_all, slot, hn::Set(d, first_bucket_), hn::Set(d, end_bucket));
    const auto reaches = [&](hn::Vec<Ints> size, int at) { return hn::Gt(size, hn::Set(d, at - 1)); };
    hn::Mask<Ints> in_z = hn::AndNot(takes_all, inside);
    for (int z = 0; !hn::AllFalse(d, in_z); ++z, in_z = hn::And(in_z, reaches(depth, z))) {
      hn::Mask<Ints> in_y = in_z;
      for (int y = 0; !hn::AllFalse(d, in_y); ++y, in_y = hn::And(in_y, reaches(height, y))) {
        const hn::Vec<Ints> row_y = hn::Add(low[1], hn::Set(d, y)), row_z = hn::Add(low[2], hn::Set(d, z));
        const hn::Vec<Ints> start = Bucket(hn::Zero(d), row_y, row_z);
        rows.Push(in_y, slot, hn::Add(start, low[0]), hn::Add(hn::Add(start, high[0]), one));
        if (rows.IsFull()) tested += TestRows(rows, hits, found);
      }
    }
  }

  /// One coordinate of the slots from `slot` on, in cells.
  HWY_INLINE hn::Vec<Floats> Scaled(int slot, int axis) const {
    return grid_.Scaled(hn::LoadU(Floats(), slots_.coordinate[axis].data() + slot), axis);
  }

  HWY_INLINE hn::Vec<Ints> Bucket(hn::Vec<Ints> x, hn::Vec<Ints> y, hn::Vec<Ints> z) const {
    return hn::Add(grid_.Index(x, y, z), hn::Set(Ints(), first_bucket_));
  }

  /// Pushes three cells of the row `distance` buckets after the spheres' own.
  HWY_INLINE void PushBlock(hn::Mask<Ints> mask, hn::Vec<Ints> slot, hn::Vec<Ints> own, int distance,
                            RowQueue& rows) const {
    const Ints d;
    rows.Push(mask, slot, hn::Add(own, hn::Set(d, distance - 1)), hn::Add(own, hn::Set(d, distance + 2)));
  }

  /// Empties the queue.
  HWY_INLINE int64_t TestRows(RowQueue& rows, HitQueue& hits, PairBuffer& found) const {
    int64_t tested = 0;
    for (int r = 0; r < rows.count; ++r) {
      tested += Test(rows.slot[r], offsets_[rows.first[r]], offsets_[rows.last[r]], hits, found);
    }
    rows.count = 0;
    return tested;
  }

  HWY_INLINE int Test(int slot, int first, int last, HitQueue& hits, PairBuffer& found) const {
    tester_.Test(slot, {first, last}, hits, found);
    return last - first;
  }

  SlotsView<V> slots_;
  const int* offsets_;
  int first_bucket_;
  V diameter_;
  float largest_, guard_;
  GridVectors<V> grid_;
  RangeTester<false, kEqual, false, kDims> tester_;
};

template <class V>
int64_t Test(const DenseCells<V>& cells, int own, int k, int first, int last, PairBuffer& found) {
  if (cells.slots.radius.is_uniform()) return CellTester<true, V>(cells, k).TestHalf(first, last, found);
  const CellTester<false, V> tester(cells, k);
  return k == own ? tester.TestHalf(first, last, found) : tester.TestReach(first, last, found);
}

TestCells<Vec2> CellTests2() { return Test<Vec2>; }
TestCells<Vec3> CellTests3() { return Test<Vec3>; }

}  // namespace HWY_NAMESPACE
}  // namespace ballpit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ballpit {

HWY_EXPORT(CellTests2);
HWY_EXPORT(CellTests3);

template <>
TestCells<Vec2> cell_tests() {
  return HWY_DYNAMIC_DISPATCH(CellTests2)();
}
template <>
TestCells<Vec3> cell_tests() {
  return HWY_DYNAMIC_DISPATCH(CellTests3)();
}

}  // namespace ballpit
#endif
