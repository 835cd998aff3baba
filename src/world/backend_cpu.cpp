// SPDX-License-Identifier: MIT
// Worlds and pair searches on the CPU.
#include "world/instances_cpu.h"
#include "world/make_world.h"
#include "world/pair_search_on.h"

namespace ballpit {

Backend cpu_backend() {
  return {"cpu", "", std::to_string(CpuExecutor(0).threads()) + " threads",
          [](const Scene& scene, const Settings& settings) {
            if (settings.response == Response::event_driven) return make_event_driven_world(scene, settings);
            return make_world_on(std::make_unique<CpuExecutor>(settings.threads), scene, settings);
          },
          [](const Settings& settings) -> std::unique_ptr<PairSearch> {
            return std::make_unique<PairSearchOn<CpuExecutor>>(std::make_unique<CpuExecutor>(settings.threads),
                                                               settings);
          }};
}

}  // namespace ballpit
