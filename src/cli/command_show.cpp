// SPDX-License-Identifier: MIT
// ballpit show: a window with the panel.
//
//     the loop:   events ──▶ keys, mouse, panel's input
//                 clock ──▶ player: the steps that are due, for half a frame at most
//                 anything new? ──▶ draw picture and panel; else wait for an event
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "cli/options.h"
#include "core/interrupt.h"
#include "show/notes.h"
#include "window/panel.h"
#include "window/remembered.h"
#include "window/saver.h"
#include "window/window.h"

namespace ballpit {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrame = 1.0 / 60;  // [s]
constexpr double kIdle = 0.25;       // [s] to wait for an event while nothing moves
constexpr float kClick = 4;          // [pixel] largest movement of the mouse in a click

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

class Show {
 public:
  Show(Window& window, Demo& demo)
      : window_(window),
        demo_(demo),
        drawing_(window.size().width, window.size().height, options()),
        panel_(drawing_.renderer().sheet()),
        saver_(demo) {}

  void run() {
    auto last = Clock::now();
    while (!window_.is_to_close() && !was_interrupted()) {
      const bool is_idle =
          drawn_ == demo_.version() && !demo_.player.is_running && !is_settling_ && !saver_.is_filming();
      const WindowEvents& events = window_.poll(is_idle ? kIdle : 0);
      const auto now = Clock::now();
      const double elapsed = std::min(seconds_between(last, now), 0.25);
      last = now;
      handle(events);
      saver_.is_filming() ? saver_.advance() : demo_.advance(elapsed, kFrame / 2);
      if (const PictureSize size = window_.size(); size.width < 16 || size.height < 16) {  // minimised
        sleep(kFrame);
        continue;
      }
      if (events.any || drawn_ != demo_.version() || is_settling_) draw(events, static_cast<float>(elapsed));
      update_title(now);
      const double left = kFrame - seconds_between(now, Clock::now());
      if (demo_.player.is_running && left > 0) sleep(left);
    }
  }

 private:
  RenderOptions options() const {
    const auto [width, height] = window_.size();
    return {.left = Panel::width_in(width, height, demo_.view.ui_scale)};
  }

  void handle(const WindowEvents& events) {
    if (!panel_.has_keyboard()) {
      for (const int code : events.pressed) press(code);
    }
    if (events.was_pressed) {
      pressed_at_ = events.mouse;
      is_turning_ = !panel_.has_mouse();
    }
    if (is_turning_ && events.is_mouse_down && events.mouse != mouse_) {
      const Vec2 moved = (events.mouse - mouse_) / static_cast<float>(std::max(window_.size().height, 1));
      demo_.view.orbit(moved.x, moved.y);
      demo_.touch();
    }
    if (events.was_released && is_turning_ && length(events.mouse - pressed_at_) <= kClick) pick(events.mouse);
    if (events.was_released) is_turning_ = false;
    if (events.wheel != 0 && !panel_.has_mouse()) {
      demo_.view.zoom_by(events.wheel);
      demo_.touch();
    }
    mouse_ = events.mouse;
  }

  void press(int code) {
    for (const Key& key : key_table()) {
      if (key.code != code) continue;
      demo_.perform(key);
      if (!key.act) saver_.save_picture(window_.size());
    }
  }

  void pick(Vec2 at) {
    const PictureSize size = window_.size();
    const auto left = static_cast<float>(options().left), height = static_cast<float>(size.height);
    const float width = static_cast<float>(size.width) - left;
    const FrameView view = demo_.frame_view(width / height);  // with the bodies
    demo_.view.selected =
        body_at(view.camera, view.inspection.bodies, {2 * (at.x - left) / width - 1, 1 - 2 * at.y / height});
    demo_.touch();
  }

  void draw(const WindowEvents& events, float elapsed) {
    Renderer& renderer = drawing_.renderer();
    const auto [width, height] = window_.size();
    if (renderer.width() != width || renderer.height() != height) renderer.resize(width, height);
    const Demo::Version version = demo_.version();
    drawing_.draw(demo_, options());
    panel_.density = window_.density();
    panel_.is_filming = saver_.is_filming();
    panel_.draw(demo_, {events.mouse, events.is_mouse_down, events.wheel, events.typed, elapsed, events.keys});
    renderer.copy_to_window();
    window_.show();
    handle(panel_.requests);
    is_settling_ = drawn_ != version || events.any;  // the panel shows the outcome of a click a frame later
    drawn_ = version;
  }

  void handle(PanelRequests& requests) {
    if (requests.picture) saver_.save_picture(window_.size());
    if (requests.state) saver_.save_state();
    if (requests.film && saver_.is_filming()) {
      saver_.stop_film();
    } else if (requests.film) {
      saver_.start_film(parse_size(requests.film_size), requests.film_frames);
    }
    requests.picture = requests.state = requests.film = false;
  }

  /// Once a second, as the exercise sheet asks: spheres, method, milliseconds a step.
  void update_title(Clock::time_point now) {
    if (seconds_between(titled_, now) < 1) return;
    titled_ = now;
    const Report& report = demo_.report();
    window_.set_title(fmt::format("Ballpit: {} spheres, {}, {} ms a step", grouped(report.count), report.broadphase,
                                  three_digits(demo_.player.mean_step_time())));
  }

  Window& window_;
  Demo& demo_;
  DemoRenderer drawing_;
  Panel panel_;
  Saver saver_;
  Vec2 mouse_{0.0f}, pressed_at_{0.0f};
  bool is_turning_ = false, is_settling_ = true;
  Demo::Version drawn_;
  Clock::time_point titled_{};
};

class ShowCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add({"--size", "WIDTHxHEIGHT", "the window's size in pixels", text_of(kSize)},
                [this](const std::string& text) { size_ = parse_size(text); });
    look_.add_to(command);
    command.add_flag("--remember", remembers_,
                     "start with scene, options and view of the last `show --remember`, and store them at the end");
    arguments_.add_to(command);
  }

  void run() {
    const std::filesystem::path file = remembers_ ? remembered_file() : "";
    if (remembers_) check_remembered(file);
    const std::unique_ptr<Demo> demo = start(recall(file));
    catch_interrupts();
    Window window(*size_, "Ballpit");
    try {
      Show(window, *demo).run();
    } catch (const Interrupted&) {
      // within a long step
    }
    if (!remembers_) return;
    const Session& session = demo->session;
    write_remembered(file, {lasting_name(session.scene_name()), session.given(), demo->view, size_of(window)});
  }

 private:
  /// An unreadable file is reported and ignored.
  static std::optional<Remembered> recall(const std::filesystem::path& file) {
    if (file.empty()) return std::nullopt;
    try {
      return read_remembered(file);
    } catch (const UserError& error) {
      note_ignored(error);
      return std::nullopt;
    }
  }

  /// The name of a built-in scene, or the absolute path of a scene's file.
  static std::string lasting_name(const std::string& scene) {
    return is_scene_file(scene) ? std::filesystem::absolute(scene).string() : scene;
  }

  static void note_ignored(const UserError& error) {
    note("--remember", std::string("nothing is remembered: ") + error.what());
  }

  /// The command line overrides what is remembered. Remembered options belong to the remembered scene.
  std::unique_ptr<Demo> start(const std::optional<Remembered>& last) {
    const bool is_same_scene = last && (!arguments_.is_scene_given || lasting_name(arguments_.scene) == last->scene);
    std::unique_ptr<Demo> demo;
    if (is_same_scene) {
      std::vector<GivenOption> given = last->given;
      for (const GivenOption& option : arguments_.given) {
        std::erase_if(given, [&](const GivenOption& old) { return old.name == option.name; });
        given.push_back(option);
      }
      try {
        demo = std::make_unique<Demo>(last->scene, given);
      } catch (const UserError& error) {  // the file is missing, or an option does not fit
        note_ignored(error);
      }
    }
    if (!demo) demo = std::make_unique<Demo>(arguments_.scene, arguments_.given);
    warn_of_small_cells(demo->session.settings());
    demo->view = look_.view(last ? last->view : View{});
    demo->touch();
    if (!size_) size_ = last ? last->size : kSize;
    return demo;
  }

  /// As --size gives it: on a HiDPI display the window has more pixels.
  static PictureSize size_of(const Window& window) {
    const auto side = [&](int pixels) {
      return std::clamp(static_cast<int>(std::lround(static_cast<float>(pixels) / window.density())), 16, 16384);
    };
    return {side(window.size().width), side(window.size().height)};
  }

  SceneArguments arguments_;
  LookArguments look_;
  static constexpr PictureSize kSize{1600, 900};
  std::optional<PictureSize> size_;
  bool remembers_ = false;
};

}  // namespace

std::function<void()> make_show_command(CommandOptions& options) { return make_command<ShowCommand>(options); }

}  // namespace ballpit
