// SPDX-License-Identifier: MIT
#include "window/saver.h"

#include <chrono>
#include <filesystem>

#include "core/file.h"
#include "core/numbers.h"
#include "export/png.h"
#include "scene/spheres_csv.h"

namespace ballpit {

namespace {

constexpr std::chrono::milliseconds kMaxTurn{200};  // the panel waits that long

/// "picture_00000.png", or the first after it that does not exist.
std::string free_name(const std::string& stem, const std::string& ending) {
  for (int k = 0;; ++k) {
    const std::string name = fmt::format("{}{:05}{}", stem, k, ending);
    if (!std::filesystem::exists(name)) return name;
  }
}

/// The file of the session's acts.
std::string text_of_acts(const Session& session, const std::string& file) {
  std::string comment = fmt::format("# The acts of a run of `ballpit show`. The same run again:\n#   ballpit show {}",
                                    visible(session.scene_name()));
  for (const GivenOption& option : session.given()) comment += fmt::format(" --{} {}", option.name, option.value);
  comment += fmt::format(" --acts {}\n", file);
  if (const std::optional<double> changed = session.changed_at()) {
    comment += fmt::format("# But settings or physics were changed at t = {} s, which this file does not hold.\n",
                           number_text(*changed));
  }
  return text_of(session.acts().all(), session.scene().domain.dimensions, comment);
}

Image draw(DemoRenderer& drawing, Demo& demo, const RenderOptions& options) {
  drawing.draw(demo, options);
  return drawing.renderer().read_pixels();
}

}  // namespace

/// Runs an action. An error, such as a full disk, ends the film but not the demonstration.
template <class Action>
void Saver::attempt(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    film_.reset();
    drawing_.reset();
    demo_.say(error.what());
  }
  demo_.touch();
}

void Saver::save_picture(PictureSize size) {
  attempt([&] {
    RenderOptions options;
    options.supersample = 2;
    DemoRenderer drawing(size.width, size.height, options);
    const std::string name = free_name("picture_", ".png");
    write_png(name, draw(drawing, demo_, options));
    demo_.say("saved " + name);
  });
}

void Saver::save_state() {
  attempt([&] {
    const std::string name = free_name("state_", ".csv");
    write_spheres_csv(name, demo_.session.world().bodies());
    demo_.say("saved " + name);
  });
}

void Saver::save_acts() {
  attempt([&] {
    const std::string name = free_name("acts_", ".toml");
    write_file(name, text_of_acts(demo_.session, name));
    demo_.say("saved " + name);
  });
}

void Saver::start_film(PictureSize size, int frames) {
  attempt([&] {
    demo_.player.is_running = false;
    drawing_ = std::make_unique<DemoRenderer>(size.width, size.height, RenderOptions{});
    FilmPlan plan;
    plan.folder = free_name("frames_", "");
    plan.frames = frames;
    plan.from = demo_.session.world().time();
    plan.keeps_timeline = true;
    plan.key = film_key(demo_, plan, {size});
    film_ = std::make_unique<Film>(demo_, plan);
    if (!demo_.session.acts().all().empty()) {
      const std::string file = (std::filesystem::path(plan.folder) / "acts.toml").string();
      write_file(file, text_of_acts(demo_.session, file));
    }
    world_ = demo_.worlds();
  });
}

void Saver::advance() {
  if (!film_) return;
  if (demo_.worlds() != world_ || film_->is_overtaken()) {  // the user changed or stepped the world
    stop_film();
    return;
  }
  attempt([&] {
    const auto start = std::chrono::steady_clock::now();
    if (!film_->advance([&] { return std::chrono::steady_clock::now() - start > kMaxTurn; })) return;
    const bool measured = std::exchange(demo_.measures, false);  // films are repeatable
    demo_.touch();
    film_->push(draw(*drawing_, demo_, {}));
    demo_.measures = measured;
    demo_.say(fmt::format("frame {} of {} in {}", film_->next(), film_->plan.frames, film_->plan.folder));
    if (film_->is_done()) stop_film();
  });
}

void Saver::stop_film() {
  if (!film_) return;
  attempt([&] {
    film_->finish();
    const std::string done = counted(film_->next(), "frame") + " in " + film_->plan.folder;
    demo_.say(done);
    film_.reset();
    drawing_.reset();
  });
}

}  // namespace ballpit
