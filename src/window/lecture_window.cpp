// SPDX-License-Identifier: MIT
#include "window/lecture_window.h"

#include <algorithm>
#include <array>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "core/language.h"

namespace ballpit {

std::span<const PresenterKey> presenter_keys() {
  static constexpr std::array kKeys{
      PresenterKey{GLFW_KEY_PAGE_DOWN, "PageDown", "next stop, then the next page",
                   [](LectureWindow& s) { s.presenter.next(); }},
      PresenterKey{GLFW_KEY_SPACE, "Space", "the same", [](LectureWindow& s) { s.presenter.next(); }},
      PresenterKey{GLFW_KEY_PAGE_UP, "PageUp", "page before", [](LectureWindow& s) { s.presenter.previous(); }},
      PresenterKey{GLFW_KEY_RIGHT, "→", "next operation, with Shift the next phase",
                   [](LectureWindow& s) { s.move_cursor(1); }},
      PresenterKey{GLFW_KEY_LEFT, "←", "operation or phase before", [](LectureWindow& s) { s.move_cursor(-1); }},
      PresenterKey{GLFW_KEY_HOME, "Home", "first page", [](LectureWindow& s) { s.presenter.go_to(1); }},
      PresenterKey{GLFW_KEY_END, "End", "last page", [](LectureWindow& s) { s.presenter.go_to(s.presenter.count()); }},
      PresenterKey{GLFW_KEY_ENTER, "digits, Enter", "page of this number",
                   [](LectureWindow& s) { s.go_to_typed_page(); }},
      PresenterKey{GLFW_KEY_B, "B", "blank screen", [](LectureWindow& s) { s.presenter.is_blank ^= true; }},
      PresenterKey{GLFW_KEY_PERIOD, ".", "the same", [](LectureWindow& s) { s.presenter.is_blank ^= true; }},
      PresenterKey{GLFW_KEY_F11, "F11", "full screen", [](LectureWindow& s) { s.toggle_full_screen(); }},
      PresenterKey{GLFW_KEY_F5, "F5", "the same", [](LectureWindow& s) { s.toggle_full_screen(); }},
      PresenterKey{GLFW_KEY_F, "F", "the same", [](LectureWindow& s) { s.toggle_full_screen(); }},
      PresenterKey{GLFW_KEY_TAB, "Tab", "panel", [](LectureWindow& s) { s.toggle_panel(); }},
      PresenterKey{GLFW_KEY_F1, "F1", "these keys", [](LectureWindow& s) { s.show_keys(); }},
      PresenterKey{GLFW_KEY_D, "D", "German or English", [](LectureWindow& s) { s.change_language(); }},
      PresenterKey{GLFW_KEY_P, "P", "play the scene, or pause",
                   [](LectureWindow& s) { s.presenter.demo().player.is_running ^= true; }},
      PresenterKey{GLFW_KEY_R, "R", "the page as it was",
                   [](LectureWindow& s) { s.presenter.go_to(s.presenter.number()); }},
      PresenterKey{GLFW_KEY_ESCAPE, "Esc", "leave full screen, then the lecture", [](LectureWindow& s) { s.leave(); }},
  };
  return kKeys;
}

LectureWindow::LectureWindow(Window& its_window, Presenter& its_presenter)
    : SceneWindow(its_window),
      presenter(its_presenter),
      renderer_(window.size().width, window.size().height),
      panel_(renderer_.sheet()) {
  constexpr double kPatience = 0.1;  // [s] a page shows its first picture soon
  presenter.patience = kPatience;
  panel_.is_shown = false;
  for (const PresenterKey& key : presenter_keys()) {
    std::function<void()> act;  // a button each, but one only for keys that do the same
    const bool needs_button = key.help != "the same" && key.code != GLFW_KEY_ENTER && key.code != GLFW_KEY_F1;
    if (needs_button) act = [this, &key] { key.act(*this); };
    panel_.keys.push_back({std::string(key.name), std::string(key.help), act});
  }
  panel_.hint(translated("PageDown: on     B: blank     F11: full screen     right click: panel     F1: all keys"));
}

void LectureWindow::show_keys() {
  Demo& demo = presenter.demo();
  demo.shows_keys = !(demo.shows_keys && panel_.is_shown);
  panel_.is_shown = demo.shows_keys;
}

void LectureWindow::change_language() {
  set_language(language() == Language::german ? Language::english : Language::german);
}

void LectureWindow::move_cursor(int direction) {
  is_shift_down() ? presenter.skip_phase(direction) : presenter.step(direction);
}

void LectureWindow::go_to_typed_page() {
  if (typed_ > 0) presenter.go_to(typed_);
  typed_ = 0;
}

void LectureWindow::leave() { window.is_full_screen() ? window.set_full_screen(false) : stop(); }

void LectureWindow::press(int code) {
  panel_.end_hint();
  if (code >= GLFW_KEY_0 && code <= GLFW_KEY_9) return type_digit(code - GLFW_KEY_0);
  if (code >= GLFW_KEY_KP_0 && code <= GLFW_KEY_KP_9) return type_digit(code - GLFW_KEY_KP_0);
  if (code == GLFW_KEY_KP_ENTER) code = GLFW_KEY_ENTER;
  for (const PresenterKey& key : presenter_keys()) {
    if (key.code == code) key.act(*this);
  }
  if (code != GLFW_KEY_ENTER) typed_ = 0;
  presenter.demo().touch();
}

void LectureWindow::advance(double elapsed) {
  if (presenter.is_ready()) return SceneWindow::advance(elapsed);
  presenter.prepare();
  presenter.demo().touch();
}

void LectureWindow::draw(const WindowEvents& events, float elapsed) {
  if (!presenter.is_ready() && still_ == presenter.number()) return;
  still_ = presenter.is_ready() ? 0 : presenter.number();
  const auto [width, height] = window.size();
  if (renderer_.width() != width || renderer_.height() != height) renderer_.resize(width, height);
  renderer_.set_options(
      {.theme = theme_named(presenter.demo().view.theme), .left = left(), .text_scale = presenter.text_scale});
  renderer_.draw(presenter.frame_view(static_cast<float>(width - left()) / static_cast<float>(height)));
  panel_.density = window.density();
  panel_.top = room_of(PageView{}, presenter.text_scale, 1).above;
  panel_.shows_card = presenter.demo().view.selected != presenter.page().view.selected;  // picked by a click
  if (events.was_released) panel_.end_hint();
  panel_.pages = {presenter.titles(), presenter.number(), [this](int number) { presenter.go_to(number); }};
  panel_.draw(presenter.demo(), events.for_panel(elapsed));
  presenter.text_scale = presenter.demo().view.text_scale;  // the panel's, for the next pages too
  renderer_.copy_to_window();
  window.show();
}

std::string LectureWindow::title() { return fmt::format("Ballpit: {}", presenter.title()); }

}  // namespace ballpit
