// SPDX-License-Identifier: MIT
#include "window/saver.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "core/error.h"
#include "export/png.h"
#include "render/painter.h"
#include "scene/spheres_csv.h"
#include "show/film_key.h"

namespace ballpit {

namespace {

constexpr std::chrono::milliseconds kLongestTurn{200};  // the panel waits for it

/// "picture_00000.png", or the first after it that does not exist.
std::string free_name(const std::string& stem, const std::string& ending) {
  for (int k = 0;; ++k) {
    std::string name = std::to_string(k);
    name.insert(0, 5 - std::min<size_t>(name.size(), 5), '0');
    name.insert(0, stem);
    name.append(ending);
    if (!std::filesystem::exists(name)) return name;
  }
}

Image draw(DemoRenderer& drawing, Demo& demo, const RenderOptions& options) {
  drawing.draw(demo, options);
  return drawing.renderer().read_pixels();
}

}  // namespace

/// A disk that is full, or a size that cannot be drawn, ends what was asked for and nothing else.
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
    world_ = demo_.worlds();
  });
}

void Saver::go_on() {
  if (!film_) return;
  if (demo_.worlds() != world_ ||
      film_->is_overtaken()) {  // its time begins anew, or somebody went on without the film
    stop_film();
    return;
  }
  attempt([&] {
    const auto start = std::chrono::steady_clock::now();
    if (!film_->advance([&] { return std::chrono::steady_clock::now() - start > kLongestTurn; })) return;
    film_->push(draw(*drawing_, demo_, {}));
    demo_.say("frame " + std::to_string(film_->next()) + " of " + std::to_string(film_->plan().frames) + " in " +
              film_->plan().folder);
    if (film_->is_done()) stop_film();
  });
}

void Saver::stop_film() {
  if (!film_) return;
  attempt([&] {
    film_->finish();
    const std::string done = counted(film_->next(), "frame") + " in " + film_->plan().folder;
    demo_.say(done);
    film_.reset();
    drawing_.reset();
  });
}

}  // namespace ballpit
