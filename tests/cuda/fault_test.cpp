// SPDX-License-Identifier: MIT
// Every call of the CUDA runtime fails once: each failure is reported, all resources are released, and the next run is right. What a
// step calls is counted as well: one that has its buffers neither allocates nor waits more often than it must.
#include <algorithm>
#include <functional>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/cuda/fault_injection.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

Scene small_scene() { return make_cloud({.count = 40, .low = -0.4, .high = 0.4, .smallest = 0.05, .largest = 0.1}, 2); }

Settings settings_of(const std::string& broadphase, double skin = 0) {
  Settings settings;
  settings.broadphase = named<BroadPhase>(broadphase);
  settings.table = named<CellTable>(skin > 0 ? "hashed" : "auto");
  settings.skin = skin;
  settings.dt = 1.0 / 480;
  return settings;
}

constexpr int kStepsToGraphs = 12;  // until each sequence of launches has come twice

/// Asked for once: what it asks the device is no part of a run.
const Backend& backend() {
  static const Backend cuda = cuda_backend();
  return cuda;
}

/// A world from its making to its report; returns the hash of its state. Stages are timed where they are asked for.
uint64_t run_world(const Scene& scene, const Settings& settings, int steps, std::vector<Stage>* stages = nullptr) {
  const auto world = backend().make_world(scene, settings);
  world->time_stages(stages != nullptr);
  for (int k = 0; k < steps; ++k) world->step();
  const Report report = world->report();
  if (stages != nullptr) *stages = report.stages;
  return report.state_hash;
}

/// A search the same way; returns a hash of its pairs.
uint64_t run_search(const Scene& scene, const Settings& settings, std::vector<Stage>* stages = nullptr) {
  std::vector<Vec3> position(scene.bodies.position.begin(), scene.bodies.position.end());
  std::vector<float> radius(scene.bodies.radius.begin(), scene.bodies.radius.end());
  const auto count = static_cast<int64_t>(radius.size());
  const auto search = backend().make_pair_search(settings);
  search->find({{position.data(), count}, {radius.data(), count}});
  uint64_t hash = search->work_per_thread().size();
  for (const Pair& pair : search->pairs()) hash = hash * 1000003 + static_cast<uint64_t>(pair.i * 1000 + pair.j);
  if (stages != nullptr) *stages = search->report().stages;
  return hash;
}

using Run = std::function<uint64_t(std::vector<Stage>*)>;

/// Whether a message names the call that failed, or the stage that it was made for.
bool names_failure(const std::string& message, const std::string& call, const std::vector<Stage>& stages) {
  if (message.rfind("CUDA: ", 0) != 0) return false;
  return message.find(call + "(") != std::string::npos ||
         std::any_of(stages.begin(), stages.end(),
                     [&](const Stage& stage) { return message.rfind("CUDA: " + stage.name + ": ", 0) == 0; });
}

/// Fails the `call`-th call of a run; false where the run has fewer.
bool survives_failure(const Run& run, int64_t call, const std::vector<Stage>& stages) {
  faults::fail_at(call);
  std::string message;
  try {
    run(nullptr);
  } catch (const RunError& error) {
    message = error.what();
  }
  const std::string failed = faults::failed_call();
  faults::fail_at(0);
  if (failed.empty()) {
    CHECK(message == "");
    return false;
  }
  INFO("call " << call << ", " << failed << ": \"" << message << "\"");
  CHECK(names_failure(message, failed, stages));
  CHECK(faults::held() == faults::Held{});
  return true;
}

/// Each call fails once; then the run is repeated whole.
void fail_everywhere(const Run& run) {
  std::vector<Stage> stages;
  const uint64_t expected = run(&stages);  // CUB asks once for the device, and keeps the answer or the error
  REQUIRE(faults::held() == faults::Held{});
  int64_t call = 1;
  while (survives_failure(run, call, stages)) ++call;
  CHECK(call > 50);
  CHECK(run(nullptr) == expected);
  CHECK(faults::held() == faults::Held{});
}

int64_t calls_of(const std::string& name) {
  const auto found = faults::calls().find(name);
  return found == faults::calls().end() ? 0 : found->second;
}

}  // namespace

TEST_CASE("a failure of any CUDA call in a world is reported, and all resources are released") {
  const std::string broadphase = GENERATE("sorted-grid", "linked-cell", "sort-and-sweep", "brute-force");
  const Scene scene = small_scene();
  const Settings settings = settings_of(broadphase);
  CAPTURE(broadphase);
  fail_everywhere([&](std::vector<Stage>* stages) { return run_world(scene, settings, 2, stages); });
}

TEST_CASE("a failure of any CUDA call is reported also where steps are graphs, and where stages are timed") {
  const Scene scene = small_scene();
  Settings settings = settings_of("sorted-grid");
  settings.response = GENERATE(Response::impulse, Response::position_based);
  fail_everywhere([&](std::vector<Stage>* stages) { return run_world(scene, settings, kStepsToGraphs, stages); });
  fail_everywhere([&](std::vector<Stage>* stages) {
    std::vector<Stage> own;
    const uint64_t hash = run_world(scene, settings, 2, &own);
    if (stages != nullptr) *stages = own;
    return hash;
  });
}

TEST_CASE("a failure of any CUDA call in a world with a candidate list is reported, and all resources are released") {
  const Scene scene = small_scene();
  const Settings settings = settings_of("sorted-grid", 0.2);
  fail_everywhere([&](std::vector<Stage>* stages) { return run_world(scene, settings, 2, stages); });
}

TEST_CASE("a failure of any CUDA call in a pair search is reported, and all resources are released") {
  const std::string broadphase = GENERATE("sorted-grid", "linked-cell", "sort-and-sweep", "brute-force");
  const Scene scene = small_scene();
  const Settings settings = settings_of(broadphase);
  CAPTURE(broadphase);
  fail_everywhere([&](std::vector<Stage>* stages) { return run_search(scene, settings, stages); });
}

TEST_CASE("a world on CUDA holds one stream, and gives back what it holds") {
  for (const bool is_timed : {false, true}) {
    faults::Held held;
    {
      const auto world = backend().make_world(small_scene(), settings_of("sorted-grid"));
      world->time_stages(is_timed);
      for (int k = 0; k < kStepsToGraphs; ++k) world->step();
      held = faults::held();
    }
    CHECK(held.allocations > 20);
    CHECK(held.streams == 1);
    CHECK((held.events > 20) == is_timed);
    CHECK((held.graphs > 0) == !is_timed);
    CHECK(faults::held() == faults::Held{});
  }
}

TEST_CASE("a step that has its buffers allocates nothing, and waits for a few numbers alone") {
  struct Expected {
    std::string broadphase;
    double skin;
    int64_t waits;  // the sweep: its axis; the list: whether it is valid
  };
  const auto expected =
      GENERATE(Expected{"sorted-grid", 0, 0}, Expected{"linked-cell", 0, 0}, Expected{"brute-force", 0, 0},
               Expected{"sort-and-sweep", 0, 1}, Expected{"sorted-grid", 1, 1});
  CAPTURE(expected.broadphase, expected.skin);
  Scene scene = small_scene();
  // As many contacts in every step; what overlaps is pushed apart by less than the skin.
  for (Vec3d& velocity : scene.bodies.velocity) velocity = Vec3d(0.0);
  const auto world = cuda_backend().make_world(scene, settings_of(expected.broadphase, expected.skin));
  world->step();
  world->step();
  faults::fail_at(0);
  world->step();
  CHECK(calls_of("__cudaLaunchKernel") > 10);
  CHECK(calls_of("cudaMalloc") == 0);
  CHECK(calls_of("cudaStreamSynchronize") == expected.waits);
}

TEST_CASE("a step that nobody looks at is one call, but for those that the guard checks and the ones after these") {
  const auto [response, solver] = GENERATE(table<std::string, std::string>({{"impulse", "jacobi"},
                                                                            {"impulse", "gauss-seidel"},
                                                                            {"kinematic", "jacobi"},
                                                                            {"penalty", "jacobi"},
                                                                            {"position-based", "jacobi"}}));
  CAPTURE(response, solver);
  Settings settings = settings_of("sorted-grid");
  settings.response = named<Response>(response);
  settings.solver = named<Solver>(solver);
  const auto world = cuda_backend().make_world(small_scene(), settings);
  for (int k = 0; k < 64; ++k) world->step();
  int64_t waits = 0;
  for (int k = 65; k <= 80; ++k) {
    faults::fail_at(0);
    world->step();
    waits += calls_of("cudaStreamSynchronize");
    if (k % 16 <= 1) continue;  // the check; and the step that takes the contacts found for it
    int64_t calls = 0;
    std::string names;
    for (const auto& [name, count] : faults::calls()) {
      calls += count;
      names += name + " ";
    }
    CAPTURE(k, names);
    CHECK(calls == 1);
    CHECK(calls_of("cudaGraphLaunch") == 1);
  }
  CHECK(waits > 0);  // in the 80th step
}

TEST_CASE("a device that cannot be asked is one that is not there") {
  faults::fail_at(1);
  CHECK(cuda_backend().unavailable_reason == "unknown error");
  CHECK(faults::failed_call() == "cudaGetDeviceCount");
  faults::fail_at(2);
  CHECK_THROWS_WITH(cuda_backend(), Catch::Contains("cudaGetDeviceProperties"));
  faults::fail_at(0);
  CHECK(cuda_backend().unavailable_reason.empty());
}
