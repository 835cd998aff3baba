// SPDX-License-Identifier: MIT
// Thousands of keys, clicks, drags, turns of the wheel, letters and sizes at random: whatever hands do, the
// demonstration goes on. The acts are the same each time; how many steps a world makes between them depends on the
// machine, as it does in a window.
#include <algorithm>
#include <array>
#include <ctime>
#include <functional>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "show/hand.h"
#include "show/presenter.h"
#include "tests/support/desk.h"
#include "tests/support/run_program.h"
#include "window/saver.h"

using namespace ballpit;

namespace {

/// Those that are filled within a moment.
constexpr std::array kScenes{"lecture-grid", "lecture-sweep", "two-spheres", "oblique-pair", "bouncing-ball",
                             "cradle",       "stack",         "mass-ratio",  "bullet",       "open-box"};
constexpr std::array kEditing{256, 257, 258, 259, 261, 262, 263, 268, 269};  // Escape, Enter, Tab, Backspace, Delete, …

class Monkey {
 public:
  explicit Monkey(uint64_t seed) : random_(seed) {}

  void act() {
    static constexpr std::array kActions{&Monkey::press, &Monkey::click,  &Monkey::click,  &Monkey::drag,
                                         &Monkey::drag,  &Monkey::type,   &Monkey::scroll, &Monkey::turn,
                                         &Monkey::pick,  &Monkey::resize, &Monkey::scrub,  &Monkey::restage,
                                         &Monkey::play,  &Monkey::play,   &Monkey::touch};
    (this->*kActions[below(kActions.size())])();
    handle_requests();
    desk_.demo.advance(0.01, 0.002);
  }

  Desk& desk() { return desk_; }

 private:
  double uniform() { return random_.uniform(0, 1); }
  size_t below(size_t count) { return std::min(static_cast<size_t>(uniform() * double(count)), count - 1); }
  float part() { return static_cast<float>(uniform()); }
  Vec2 anywhere() {
    return Vec2(1.2f * part() - 0.1f, 1.2f * part() - 0.1f) * Vec2(desk_.renderer.width(), desk_.renderer.height());
  }

  /// An item of the panel, in view; scenes are restage()'s.
  std::optional<ItemRect> any_item() {
    const auto& items = desk_.panel.items();
    if (items.empty()) return std::nullopt;
    const std::string name = std::next(items.begin(), static_cast<std::ptrdiff_t>(below(items.size())))->first;
    if (name.rfind("scene", 0) == 0) return std::nullopt;
    desk_.panel.reveal(name);
    desk_.rest();
    if (!desk_.has(name)) return std::nullopt;
    return desk_.panel.items().at(name);
  }
  Vec2 within(const ItemRect& rect) { return rect.low + Vec2(part(), part()) * (rect.high - rect.low); }

  void move(Vec2 at, bool is_down) { desk_.frame(PanelInput{.mouse = at, .is_down = is_down}); }

  void press() {
    const auto keys = key_table();
    desk_.demo.perform(keys[below(keys.size())]);
    desk_.frame(PanelInput{});
  }
  void click() {
    const auto item = any_item();
    const Vec2 at = item ? within(*item) : anywhere();
    for (const bool is_down : {false, true, false}) move(at, is_down);
  }
  void drag() {
    const auto item = any_item();
    Vec2 at = item ? within(*item) : anywhere();
    move(at, false);
    move(at, true);
    for (size_t k = below(4); k > 0; --k) move(at = item && uniform() < 0.7 ? within(*item) : anywhere(), true);
    move(at, false);
  }
  /// A double click on a slider or a field selects what is in it; letters go wherever the cursor is.
  void type() {
    if (const auto item = any_item()) {
      const Vec2 at = within(*item);
      for (const bool is_down : {false, true, false, true, false}) move(at, is_down);
    }
    static constexpr std::array kTexts{U"1", U"0",     U"-1",   U"1e9", U"nan",
                                       U"",  U"0.001", U"much", U"ü→😀", U"999999999999999999999"};
    for (size_t k = below(4); k > 0; --k) {
      desk_.frame(PanelInput{.typed = kTexts[below(kTexts.size())]});
      const int key = kEditing[below(kEditing.size())];
      for (const bool is_down : {true, false}) desk_.frame(PanelInput{.keys = {{key, is_down}}});
    }
    for (const bool is_down : {true, false}) desk_.frame(PanelInput{.keys = {{257, is_down}}});
  }
  void scroll() {
    desk_.frame(PanelInput{.mouse = anywhere(), .wheel = 20 * part() - 10});
    desk_.demo.view.zoom_by(40 * part() - 20);
    desk_.demo.touch();
  }
  void turn() {
    desk_.demo.view.orbit(8 * part() - 4, 8 * part() - 4);
    desk_.demo.touch();
  }
  void pick() {
    const FrameView view = desk_.demo.frame_view(1.5f);
    desk_.demo.view.selected = body_at(view.camera, view.inspection.bodies, {2 * part() - 1, 2 * part() - 1});
    desk_.demo.touch();
  }
  /// Throws, pushes or drops a sphere, or cancels that.
  void touch() {
    const auto place = [&] { return Vec2(2 * part() - 1, 2 * part() - 1); };
    const auto view = [&] { return desk_.demo.frame_view(1.5f); };
    if (uniform() < 0.2) return hand_.drop(view(), place());
    for (int tries = 0; tries < 20 && !hand_.is_aiming(); ++tries) {
      hand_.grab(view(), place(), uniform() < 0.5 ? ActKind::to_throw : ActKind::push);
    }
    hand_.drag(view(), place());
    desk_.frame(PanelInput{});
    uniform() < 0.9 ? hand_.release() : hand_.cancel();
  }
  void resize() {
    const bool is_tiny = uniform() < 0.2;
    const auto side = [&](int most) { return 16 + static_cast<int>(part() * static_cast<float>(is_tiny ? 30 : most)); };
    const int width = side(700);
    desk_.renderer.resize(width, side(500));
  }
  void scrub() {
    const Timeline& timeline = *desk_.demo.timeline;
    desk_.demo.go_to(timeline.first() + static_cast<int64_t>(1.1 * uniform() * double(timeline.furthest())) - 5);
  }
  void restage() {
    if (uniform() < 0.3) desk_.demo.load(kScenes[below(kScenes.size())]);
  }
  void play() {
    if (uniform() < 0.1) desk_.demo.player.is_running = true;
    desk_.demo.advance(0.05, 0.005);
    desk_.frame(PanelInput{});
  }

  /// Small pictures and short films in place of what was wished.
  void handle_requests() {
    PanelRequests& requests = desk_.panel.requests;
    if (requests.picture) saver_.save_picture({64, 48});
    if (requests.state) saver_.save_state();
    if (requests.film) saver_.is_filming() ? saver_.stop_film() : saver_.start_film({64, 48}, 5);
    if (requests.acts) saver_.save_acts();
    requests.picture = requests.state = requests.acts = requests.film = false;
    saver_.advance();
    desk_.panel.is_filming = saver_.is_filming();
  }

  Random random_;
  Desk desk_{"lecture-grid", 480, 270};
  Saver saver_{desk_.demo};
  Hand hand_{desk_.demo};
};

}  // namespace

TEST_CASE("a thousand keys at random end no lecture, and leave pictures") {
  GlContext context;
  Renderer renderer(480, 270);
  Panel panel(renderer.sheet());
  Presenter presenter(built_in_lecture());
  Random random(11);
  const auto below = [&](int count) { return std::min(int(random.uniform(0, count)), count - 1); };
  const std::array<std::function<void()>, 14> acts{
      [&] { presenter.next(); },
      [&] { presenter.next(); },
      [&] { presenter.previous(); },
      [&] { presenter.go_to(below(2 * presenter.count()) - 3); },
      [&] { presenter.step(below(41) - 20); },
      [&] { presenter.step(1); },
      [&] { presenter.skip_phase(below(2) == 0 ? 1 : -1); },
      [&] { presenter.is_blank = !presenter.is_blank; },
      [&] { set_language(language() == Language::german ? Language::english : Language::german); },
      [&] { presenter.demo().player.is_running = !presenter.demo().player.is_running; },
      [&] { presenter.demo().view.selected = below(30) - 1; },
      [&] { presenter.demo().perform(key_table()[size_t(below(int(key_table().size())))]); },
      [&] { presenter.demo().view.orbit(random.uniform(-1, 1), random.uniform(-1, 1)); },
      [&] { panel.is_shown = !panel.is_shown; }};
  for (int k = 0; k < 1000; ++k) {
    CAPTURE(k, presenter.page().id);
    REQUIRE_NOTHROW(acts[size_t(below(int(acts.size())))]());
    REQUIRE((presenter.number() >= 1 && presenter.number() <= presenter.count()));
    presenter.demo().touch();
    presenter.demo().advance(0.02, 0.002);
    if (k % 8 != 0) continue;
    const int left = width_beside(panel, {480, 270}, 1);
    renderer.set_options({.theme = themes().front(), .left = left, .text_scale = presenter.text_scale});
    REQUIRE_NOTHROW(renderer.draw(presenter.frame_view(float(480 - left) / 270)));
    REQUIRE_NOTHROW(panel.draw(presenter.demo(), PanelInput{}));
  }
  presenter.is_blank = false;
  presenter.go_to(1);
  CHECK(presenter.failure().empty());
  CHECK_FALSE(presenter.caption().empty());
  set_language(Language::english);
}

TEST_CASE("two thousand acts at random end no demonstration, and none takes long") {
  constexpr int kActs = 2000;
  constexpr double kLongest = 20;  // [s] of processors for one act, also under sanitizers; a fiftieth is usual
  const Scratch scratch;
  const Within within(scratch.path());
  Monkey monkey(7);
  for (int k = 0; k < kActs; ++k) {
    const std::clock_t start = std::clock();
    CAPTURE(k, monkey.desk().demo.message(), monkey.desk().demo.session.scene().name);
    REQUIRE_NOTHROW(monkey.act());
    REQUIRE(double(std::clock() - start) / CLOCKS_PER_SEC < kLongest);
  }
  Desk& desk = monkey.desk();
  desk.demo.view.ui_scale = 1;
  desk.renderer.resize(Desk::kWidth, Desk::kHeight);
  desk.demo.load("lecture-grid");
  desk.click_at({1200, 700});  // beside whatever list is open
  const bool was_running = desk.demo.player.is_running;
  desk.click("pause");
  CHECK(desk.demo.player.is_running != was_running);
}
