// SPDX-License-Identifier: MIT
// ballpit show: a window with the panel.
//
//     each turn of the loop:   events ──▶ keys, mouse, panel's input
//                              clock ──▶ player: as many steps as time asks for, for half a frame at most
//                              anything new? ──▶ draw picture and panel; else wait for an event
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "app/commands.h"
#include "app/demo.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/panel.h"
#include "app/window.h"
#include "core/error.h"
#include "core/numbers.h"
#include "export/png.h"
#include "render/painter.h"
#include "render/renderer.h"

namespace ballpit {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrame = 1.0 / 60;  // [s]
constexpr double kIdle = 0.25;       // [s] to wait for an event where nothing moves
constexpr float kClick = 4;          // [pixel] that the mouse may move in a click

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// picture_00000.png, or the first after it that does not exist.
std::string free_picture_name() {
  for (int k = 0;; ++k) {
    std::string number = std::to_string(k);
    number.insert(0, 5 - std::min<size_t>(number.size(), 5), '0');
    const std::string name = "picture_" + number + ".png";
    if (!std::filesystem::exists(name)) return name;
  }
}

class Show {
 public:
  Show(Window& window, Demo& demo)
      : window_(window),
        demo_(demo),
        renderer_(window.width(), window.height(), options()),
        panel_(renderer_.sheet()) {}

  void run() {
    auto last = Clock::now();
    while (!window_.is_to_close() && !was_interrupted()) {
      const bool is_idle = drawn_ == demo_.version() && !demo_.player.is_running && !is_settling_;
      const WindowEvents& events = window_.poll(is_idle ? kIdle : 0);
      const auto now = Clock::now();
      const double elapsed = std::min(seconds_between(last, now), 0.25);
      last = now;
      take(events);
      demo_.advance(elapsed, kFrame / 2);
      if (window_.width() < 16 || window_.height() < 16) {  // minimised
        sleep(kFrame);
        continue;
      }
      if (events.any || drawn_ != demo_.version() || is_settling_) draw(events, static_cast<float>(elapsed));
      tell_title(now);
      const double left = kFrame - seconds_between(now, Clock::now());
      if (demo_.player.is_running && left > 0) sleep(left);
    }
  }

 private:
  RenderOptions options() const {
    RenderOptions options{theme_named(demo_.view.theme), 1};
    options.left = Panel::width_in(window_.width(), window_.height());
    return options;
  }

  void take(const WindowEvents& events) {
    if (!panel_.has_keyboard()) {
      for (const int code : events.pressed) press(code);
    }
    if (events.was_pressed) {
      pressed_at_ = events.mouse;
      is_turning_ = !panel_.has_mouse();
    }
    const float height = static_cast<float>(std::max(window_.height(), 1));
    if (is_turning_ && events.is_mouse_down && events.mouse != mouse_) {
      const Vec2 way = (events.mouse - mouse_) / height;
      demo_.view.orbit(way.x, way.y);
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
      if (key.action == Action::save_picture) save();
    }
  }

  void pick(Vec2 at) {
    const float left = static_cast<float>(options().left), width = static_cast<float>(window_.width()) - left,
                height = static_cast<float>(window_.height());
    const FrameView view = demo_.frame_view(width / height);
    demo_.view.selected =
        body_at(view.camera, view.inspection.bodies, {2 * (at.x - left) / width - 1, 1 - 2 * at.y / height});
    demo_.touch();
  }

  void draw(const WindowEvents& events, float elapsed) {
    if (renderer_.width() != window_.width() || renderer_.height() != window_.height()) {
      renderer_.resize(window_.width(), window_.height());
    }
    const RenderOptions options = this->options();
    renderer_.set_options(options);
    const auto width = static_cast<float>(window_.width() - options.left),
               height = static_cast<float>(window_.height());
    const int64_t version = demo_.version();
    renderer_.draw(demo_.frame_view(width / height));
    panel_.draw(demo_, {events.mouse, events.is_mouse_down, events.wheel, events.typed, elapsed, events.keys});
    if (panel_.wants_picture) save();
    panel_.wants_picture = false;
    renderer_.copy_to_window();
    window_.show();
    is_settling_ = drawn_ != version || events.any;  // the panel shows the outcome of a click a frame later
    drawn_ = version;
  }

  void save() {
    const std::string name = free_picture_name();
    const float aspect = static_cast<float>(window_.width()) / static_cast<float>(window_.height());
    RenderOptions still{theme_named(demo_.view.theme), 2};
    renderer_.set_options(still);
    renderer_.draw(demo_.frame_view(aspect));
    try {
      write_png(name, renderer_.read_pixels());
      demo_.say("saved " + name);
    } catch (const RunError& error) {
      demo_.say(error.what());
    }
    demo_.touch();
  }

  /// About once a second, as the exercise sheet asks: spheres, method, milliseconds a step.
  void tell_title(Clock::time_point now) {
    if (seconds_between(told_, now) < 1) return;
    told_ = now;
    const Report& report = demo_.report();
    window_.set_title("Ballpit: " + grouped(report.count) + " spheres, " + report.broadphase + ", " +
                      three_digits(demo_.player.mean_step_time()) + " ms a step");
  }

  Window& window_;
  Demo& demo_;
  Renderer renderer_;
  Panel panel_;
  Vec2 mouse_{0.0f}, pressed_at_{0.0f};
  bool is_turning_ = false, is_settling_ = true;
  int64_t drawn_ = -1;  // version
  Clock::time_point told_{};
};

class ShowCommand final : public Command {
 public:
  void add_options(CLI::App& command) override {
    command.add_option("--size", size_, "the window's size in pixels")
        ->type_name("WIDTHxHEIGHT")
        ->capture_default_str();
    look_.add_to(command);
    arguments_.add_to(command);
  }

  void run() override {
    const auto [width, height] = parse_size(size_);
    Demo demo(arguments_.scene(), arguments_.given());
    demo.view = look_.view();
    demo.touch();
    catch_interrupts();
    Window window(width, height, "Ballpit");
    Show(window, demo).run();
  }

 private:
  SceneArguments arguments_;
  LookArguments look_;
  std::string size_ = "1600x900";
};

}  // namespace

std::unique_ptr<Command> make_show_command() { return std::make_unique<ShowCommand>(); }

}  // namespace ballpit
