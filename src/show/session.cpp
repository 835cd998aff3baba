// SPDX-License-Identifier: MIT
#include "show/session.h"

#include <array>
#include <cmath>
#include <utility>

#include "measure/search_costs.h"
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

Session::Session(std::string_view scene, const std::vector<GivenOption>& given, bool keeps_tally,
                 const std::filesystem::path& kept)
    : keeps_tally_(keeps_tally) {
  start(std::string(scene), given, kept);
}

void Session::start(std::string name, std::vector<GivenOption> given, const std::filesystem::path& kept) {
  Settings overrides;
  apply_given(overrides, given);
  Scene scene = load_scene(name, {overrides.count, overrides.seed, overrides.mass_ratio});
  choice_.reset();
  watch_.reset();
  if (!kept.empty()) choice_ = read_choice(kept, scene, given);
  const Settings settings = resolve(scene, given);
  const std::vector<std::string> notes = std::exchange(scene.notes, {});
  const Scene whole = choice_ ? scene : Scene{};
  use(std::move(scene), settings);
  if (name != scene_name_) print_warnings(notes);  // not again when the scene is filled again
  scene_name_ = std::move(name);
  given_ = std::move(given);
  acts_ = Acts(scene_.domain);
  acts_.steps_by(settings.dt);
  script_.clear();
  changed_at_.reset();
  start_time_ = 0;
  steps_before_ = 0;
  seconds_before_ = 0;
  steps_up_.clear();
  if (choice_) watch_.emplace(whole, *choice_, *world_);
}

void Session::play(std::vector<Act> acts) {
  script_ = acts;
  acts_ = Acts(scene_.domain, std::move(acts));
  acts_.steps_by(settings_.dt);
  report_.reset();
  if (acts_.begin(*world_)) end_watch();
}

void Session::acted() {
  report_.reset();
  end_watch();
}

/// The needs of a scene are those of its own motion.
void Session::end_watch() {
  if (!watch_) return;
  watch_.reset();
  note(fmt::format("--response {}", name_of(Response::automatic)),
       fmt::format("an act at t = {:g} s ends the watch of what the scene needs", time()));
}

void Session::take(std::vector<GivenOption> given, const Physics& physics) {
  Scene scene = scene_;
  const bool is_other_run = time() > 0 || physics != scene.physics;
  scene.physics = physics;
  scene.bodies = world_->bodies();
  const Settings settings = resolve(scene, given);
  go_on_with(std::move(scene), settings, time());
  acts_.steps_by(settings.dt);
  if (is_other_run) changed_at_ = time();
  steps_before_ = 0;
  seconds_before_ = 0;
  given_ = std::move(given);
  watch_.reset();  // of a run whose settings a person changes
}

/// The settings in use: those of the choice where the response is automatic.
Settings Session::resolve(const Scene& scene, const std::vector<GivenOption>& given) {
  Settings settings = combine(scene.defaults, given);
  if (settings.response == Response::automatic) {
    if (!choice_) choice_ = choose({scene, given});
    if (!choice_->chosen) throw RunError(scene.name, choice_->reason);
    settings = choice_->chosen->settings;
    for (const GivenOption& option : given) {
      if (option.name != "response") apply_setting(settings, option.name, option.value, "--" + option.name);
    }
    check_given(settings, given);
    return settings;
  }
  choice_.reset();
  if (settings.broadphase == BroadPhase::automatic) {
    const Backend backend = select_backend(settings.backend, settings.response);
    settings.costs = search_costs(backend, precision_of(settings));
  }
  return settings;
}

void Session::use(Scene scene, const Settings& settings) {
  const Backend backend = select_backend(settings.backend, settings.response);
  Settings own = settings;
  own.keeps_tally = keeps_tally_;
  std::unique_ptr<World> world = backend.make_world(scene, own);
  std::optional<Report> report;
  if (world_) report = world->report();  // now: if memory is too small for its contacts, the old world stays
  world_ = std::move(world);
  world_->time_stages(times_stages_);
  report_ = std::move(report);
  reported_ = 0;
  settings_ = own;
  backend_ = backend.name;
  scene_ = std::move(scene);
  scene_.bodies = {};  // the world has them now
}

/// A new world goes on from `time` [s] with the tally of the present one.
void Session::go_on_with(Scene scene, const Settings& settings, double time) {
  const Tally tally = keeps_tally_ ? world_->report().tally : Tally{};
  use(std::move(scene), settings);
  world_->go_on_from(time, tally);
  start_time_ = time;
  report_.reset();
}

void Session::advance_to(double end, const std::function<bool()>& stop, const std::function<void()>& went_back) {
  if (watch_) watch_->accept(*world_);
  while (steps_until(end) > 0 && !stop()) {
    std::string breach;
    try {
      if (acts_.step(*world_)) end_watch();
      const bool is_seen = watch_ && (watch_->is_due(*world_) || steps_until(end) <= 0);
      if (is_seen) breach = watch_->breach(*world_, settings_);
      if (is_seen && breach.empty()) watch_->accept(*world_);
      if (steps_until(end) <= 0) world_->wait();
    } catch (const RunError& error) {
      if (!watch_) throw;
      breach = error.what();
    }
    if (breach.empty()) continue;
    step_up(breach);
    if (went_back) went_back();
  }
}

/// Goes back to the last good state, and on with dearer settings.
void Session::step_up(const std::string& breach) {
  const std::string when = fmt::format("t = {:g} s: {}", time(), breach);
  watch_->go_back(*world_);
  const std::optional<Settings> next = watch_->next();
  if (!next) throw RunError(scene_.name, when, "no dearer settings are left that were found to hold");
  Scene scene = scene_;
  scene.bodies = world_->bodies();
  const double now = time();
  steps_before_ += world_->steps();
  seconds_before_ += world_->report().seconds;
  note(fmt::format("--response {}", name_of(Response::automatic)),
       fmt::format("{}; goes on from t = {:g} s with {}", when, now, typed(options_of(*next, scene.defaults))));
  steps_up_.push_back({now, when, *next});
  go_on_with(std::move(scene), *next, now);
  acts_.steps_by(next->dt);
  watch_->accept(*world_);
}

/// Changes the detection of the present world. Returns false if a new world is needed.
bool Session::detect_by(const std::vector<GivenOption>& given) {
  Settings settings = resolve(scene_, given);
  settings.keeps_tally = keeps_tally_;
  if (!world_->detect_by(settings)) return false;
  settings_ = settings;
  report_.reset();
  return true;
}

const Report& Session::report() {
  if (report_ && reported_ == world_->steps()) return *report_;
  reported_ = world_->steps();
  report_ = world_->report();
  report_->steps += steps_before_;
  report_->seconds += seconds_before_;
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
  const std::optional<Choice> choice = choice_;
  try {
    if (name == "response") choice_.reset();  // it is made again if it is wanted
    if (is_of_scene(name)) {
      start(scene_name_, given);
    } else if (is_of_detection(name) && detect_by(given)) {
      given_ = std::move(given);
    } else {
      take(given, scene_.physics);
    }
  } catch (...) {
    choice_ = choice;
    throw;
  }
}

void Session::load(const std::string& scene) {
  std::vector<GivenOption> given = given_;
  if (scene != scene_name_) {
    // Options chosen for one scene seldom fit another one.
    std::erase_if(given,
                  [](const GivenOption& option) { return option.name != "backend" && option.name != "threads"; });
  }
  const std::vector<Act> script = scene == scene_name_ ? script_ : std::vector<Act>{};
  start(scene, given);
  if (!script.empty()) play(script);
}

int64_t Session::steps_until(double time) const {
  constexpr double kMaxSteps = 1e15;  // more would never end, and could not be counted exactly
  const double steps = (time - start_time_) / settings_.dt;
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
