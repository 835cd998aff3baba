// SPDX-License-Identifier: MIT
#include "show/session.h"

#include <array>
#include <cmath>
#include <utility>

#include "methods/methods.h"
#include "scene/read_scene.h"
#include "scene/spheres_csv.h"
#include "show/notes.h"

namespace ballpit {

namespace {

/// Options that change how contacts are found but not the motion.
bool is_of_detection(std::string_view option) {
  constexpr std::array<std::string_view, 5> kNames{"broadphase", "cell-size", "table", "axis", "skin"};
  return std::find(kNames.begin(), kNames.end(), option) != kNames.end();
}

/// Options that change what the scene consists of.
bool is_of_scene(std::string_view option) { return option == "count" || option == "seed" || option == "mass-ratio"; }

}  // namespace

Backend select_backend(BackendName name, Response response) {
  const bool is_cpu_only = !goes_with(response, "backend", "cuda");
  if (name == BackendName::cpu || (name == BackendName::automatic && is_cpu_only)) return cpu_backend();
  Backend cuda = cuda_backend();
  if (cuda.unavailable_reason.empty()) return cuda;
  if (name == BackendName::automatic) return cpu_backend();
  throw UserError("--backend", "cuda, which cannot serve here: " + cuda.unavailable_reason, "auto, cpu");
}

Session::Session(std::string_view scene, const std::vector<GivenOption>& given, bool keeps_tally)
    : keeps_tally_(keeps_tally) {
  start(std::string(scene), given);
}

void Session::start(std::string name, std::vector<GivenOption> given) {
  Settings overrides;
  apply_given(overrides, given);
  Scene scene = load_scene(name, {overrides.count, overrides.seed, overrides.mass_ratio});
  const Settings settings = combine(scene.defaults, given);
  const std::vector<std::string> notes = std::exchange(scene.notes, {});
  use(std::move(scene), settings);
  if (name != scene_name_) print_warnings(notes);  // not again when the scene is filled again
  scene_name_ = std::move(name);
  given_ = std::move(given);
  time_before_ = 0;
}

void Session::take(std::vector<GivenOption> given, const Physics& physics) {
  const Settings settings = combine(scene_.defaults, given);
  Scene scene = scene_;
  scene.physics = physics;
  scene.bodies = world_->bodies();
  const double now = time();
  use(std::move(scene), settings);
  given_ = std::move(given);
  time_before_ = now;
}

void Session::use(Scene scene, const Settings& settings) {
  const Backend backend = select_backend(settings.backend, settings.response);
  Settings own = settings;
  own.keeps_tally = keeps_tally_;
  std::unique_ptr<World> world = backend.make_world(scene, own);
  std::optional<Report> report;
  if (world_) report = world->report();  // now: if memory is too small for its contacts, the old world stays
  world_ = std::move(world);
  report_ = std::move(report);
  settings_ = own;
  backend_ = backend.name;
  scene_ = std::move(scene);
  scene_.bodies = {};  // the world has them now
}

/// Changes the detection of the present world. Returns false if a new world is needed.
bool Session::detect_by(const std::vector<GivenOption>& given) {
  Settings settings = combine(scene_.defaults, given);
  settings.keeps_tally = keeps_tally_;
  if (!world_->detect_by(settings)) return false;
  settings_ = settings;
  report_.reset();
  return true;
}

const Report& Session::report() {
  if (!report_ || report_->steps != world_->steps()) report_ = world_->report();
  return *report_;
}

void Session::set(const std::string& name, const std::string& value) {
  std::vector<GivenOption> given;
  for (const GivenOption& option : given_) {
    const bool fits =
        name != "response" || value.empty() || goes_with(named<Response>(value), option.name, option.value);
    if (option.name != name && fits) given.push_back(option);
  }
  if (!value.empty()) given.push_back({name, value});
  if (is_of_scene(name)) {
    start(scene_name_, given);
  } else if (is_of_detection(name) && detect_by(given)) {
    given_ = std::move(given);
  } else {
    take(given, scene_.physics);
  }
}

void Session::load(const std::string& scene) {
  std::vector<GivenOption> given = given_;
  if (scene != scene_name_) {
    // Options chosen for one scene seldom fit another one.
    std::erase_if(given,
                  [](const GivenOption& option) { return option.name != "backend" && option.name != "threads"; });
  }
  start(scene, given);
}

int64_t Session::steps_until(double time) const {
  constexpr double kMaxSteps = 1e15;  // more would never end, and could not be counted exactly
  const double steps = time / settings_.dt;
  if (!(steps <= kMaxSteps)) {
    throw UserError("--dt", fmt::format("{:g}, which makes {:g} steps of {:g} s", settings_.dt, steps, time),
                    fmt::format("{:g} steps", kMaxSteps));
  }
  return static_cast<int64_t>(std::llround(steps)) - world_->steps();
}

std::string rescue(Session& session, const std::string& path) {
  std::string text;
  try {
    text = fmt::format("the last good state, of t = {:g} s, ", session.world().last_good_time());
    write_spheres_csv(path, session.world().last_good());
    return text + "is in " + path;
  } catch (const std::exception& error) {
    return text + "is lost: " + error.what();
  }
}

}  // namespace ballpit
