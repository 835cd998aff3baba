// SPDX-License-Identifier: MIT
#include "lecture/real_race.h"

#include "broad_phase/parameters.h"
#include "core/random.h"
#include "exec/cpu_executor.h"
#include "lecture/kernels/linked_cell.h"

namespace ballpit::lecture {

namespace {

constexpr int kSide = 3;  // cells along each axis, as on slide 16

}  // namespace

RealRace race_on_threads(int64_t count) {
  const Box<Vec2> box{Vec2(0), Vec2(kSide), Boundary::walls};
  Random random(1);
  std::vector<Vec2> position;
  for (int64_t i = 0; i < count; ++i) position.emplace_back(random.uniform(0, kSide), random.uniform(0, kSide));
  const float radius = 0.5f;
  BroadPhaseParameters<Vec2> parameters;
  parameters.box = box;
  parameters.count = count;
  std::vector<int> head(kSide * kSide, -1), next(static_cast<size_t>(count), -1);
  const LinkedCell<Vec2, AtomicMemory> kernels{{},
                                               {{position.data(), count}, {&radius, 0}, box},
                                               {},
                                               make_grid(parameters, {radius, count}, Vec2(2 * radius), false),
                                               {head.data(), kSide * kSide},
                                               {next.data(), count},
                                               {}};
  CpuExecutor exec(0);
  exec.parallel_for("slide 16: insert", count, [&](int i) { kernels.insert_racing(i); });
  RealRace result{exec.threads(), count};
  for (int i : head) {
    for (; i >= 0; i = next[static_cast<size_t>(i)]) --result.lost;
  }
  return result;
}

}  // namespace ballpit::lecture
