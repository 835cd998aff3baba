// SPDX-License-Identifier: MIT
// The panel beside the picture, by Dear ImGui. Scene and time are always in view; below them are three tabs:
//
//     Scene      what is drawn, how it looks, export
//     Method     the cheapest settings that are good enough; broad phase, response, and their settings, of which those
//                that the method does not use are grey
//     Numbers    cost, accuracy, and the chart of one against the other
//
// Over the scene it shows the picked sphere as a card, and a hint that fades. Its choices come from the same tables as
// those of the command line. The panel is drawn into the framebuffer that is bound, in a window or headless. It records
// the rectangle of each item by name, so that tests can click on items.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "methods/methods.h"
#include "render/ghost_chart.h"
#include "render/sheet.h"
#include "show/demo.h"

namespace ballpit {

struct ItemRect {
  Vec2 low, high;  ///< [pixel] from the upper left corner
  bool is_enabled = true;
  Vec2 middle() const { return (low + high) / 2.0f; }
};

/// Input between two frames of the panel.
struct PanelInput {
  Vec2 mouse{-1e6f};  ///< [pixel] from the upper left corner
  bool is_down = false;
  float wheel = 0;
  std::u32string typed{};      ///< characters
  float elapsed = 1 / 60.0f;   ///< [s] since the frame before
  std::map<int, bool> keys{};  ///< by GLFW's code: those that changed, and whether they are down
};

/// A value on a slider with a name.
struct SliderMark {
  float at;
  std::string name;
};

struct SliderLook {
  float low, high;
  bool is_log = false, is_integer = false;
  bool is_late = false;             ///< acts when it is let go, since it moves the panel itself
  std::string shown;                ///< the value as people write it
  std::vector<float> snaps{};       ///< values at which it stops
  std::vector<SliderMark> marks{};  ///< below it
};

/// Requests of the user that the caller of the panel must handle.
struct PanelRequests {
  bool picture = false, state = false, acts = false, film = false;
  std::string film_size = "1280x720";
  int film_frames = 300;
};

/// A key, as F1 lists it. One with an action is a button of the panel too, for those who have only a mouse.
struct PanelKey {
  std::string name, help;
  std::function<void()> act{};
};

/// The pages of a lecture, for those who have no digits to type.
struct PanelPages {
  std::vector<std::string> titles;
  int number = 0;  ///< of the page shown, from 1
  std::function<void(int)> go_to;
};

enum class PanelTab { scene, method, numbers };
inline constexpr PanelTab kPanelTabs[] = {PanelTab::scene, PanelTab::method, PanelTab::numbers};

class Panel {
 public:
  /// `sheet` must outlive the panel and be prepared for the picture that the panel is drawn on.
  explicit Panel(Sheet& sheet);

  /// The panel's width in a picture [pixel]: at most a third of it, or half for a scale above 1.
  static int width_in(int picture_width, int picture_height, float scale = 1);

  void draw(Demo& demo, const PanelInput& input);

  /// Whether the panel uses the mouse or the keyboard.
  bool has_mouse() const;
  bool has_keyboard() const;

  /// Opens a tab in the next frame.
  void open(PanelTab tab) { wanted_tab_ = tab; }

  /// Scrolls to an item of the open tab in the next frame.
  void reveal(const std::string& name) { revealed_ = name; }

  bool is_shown = true;                 ///< else there is only a button that shows it again, while the pointer moves
  float density = 1;                    ///< set by the caller: pixels for one of an ordinary display
  bool is_filming = false;              ///< set by the caller
  PanelRequests requests;               ///< for the caller to handle and to clear
  std::vector<PanelKey> keys;           ///< set by the caller
  std::vector<std::string> gestures{};  ///< set by the caller: more of the mouse, below the keys
  PanelPages pages;                     ///< set by the caller; none outside lectures
  bool shows_card = true;               ///< set by the caller, of the picked sphere
  float top = 0;                        ///< set by the caller: part of the height that the scene's title takes

  /// A line at the lower edge of the scene, which fades after some seconds.
  void hint(const std::string& text);
  void end_hint() { hint_left_ = std::min(hint_left_, kFade); }

  /// Whether a hint, or the button of a hidden panel, is shown for some more time.
  bool is_fading() const { return hint_left_ > 0 || (!is_shown && handle_left_ > 0); }

  /// All items of the last frame by name: "pause", "broadphase linked-cell", "overlay grid", …
  const std::map<std::string, ItemRect>& items() const { return items_; }

 private:
  static constexpr float kFade = 1, kHintTime = 12, kHandleTime = 3;  // [s]

  void note(const std::string& name);
  /// Leaves room for the label of the next item at its right, or writes it above where it is too long. Returns the
  /// item's title for ImGui.
  static std::string place_label(const std::string& name, const std::string& label);
  void heading(const char* title);
  bool button(const std::string& name, const std::string& label);
  void combo(const std::string& name, const std::string& label, const std::string& current,
             const std::function<void()>& entries);
  bool entry(const std::string& name, const std::string& label, bool is_current);
  template <class Table>
  void choose(Demo& demo, const char* name, const char* label, const Table& table, std::string& current);
  void setting(Demo& demo, const SettingInfo& info);
  void number_setting(Demo& demo, const SettingInfo& info);
  void settings(Demo& demo, SettingGroup group, const Method& method);
  bool slider(const std::string& name, const std::string& label, float& value, const SliderLook& look);
  void draw_marks(const SliderLook& look, float width);
  void paragraph(const std::string& name, const std::string& text);
  void row(const char* what, const std::string& value);
  void plot(const char* name, const float* values, size_t count, int stride, float from);

  void draw_panel(Demo& demo);
  void draw_tabs(Demo& demo);
  void draw_time(Demo& demo);
  void draw_scene(Demo& demo);
  void draw_occlusion(Demo& demo);
  void draw_export(Demo& demo);
  void draw_method(Demo& demo);
  void draw_choice(Demo& demo);
  void draw_reasons(const Choice& choice);
  void draw_broad_phases(Demo& demo);
  void draw_physics(Demo& demo);
  void draw_numbers(Demo& demo);
  void draw_trade_off(Demo& demo);
  void draw_prediction(Vec2 at, Vec2 legend);
  void draw_ghost(Demo& demo);
  void draw_ghost_chart(const GhostChart& chart, const std::string& theme_name);
  void draw_keys(Demo& demo);
  void draw_pages();
  void draw_handle(const PanelInput& input);
  void draw_hint(float elapsed);

  void draw_card(Demo& demo);
  void draw_places(const Inspection& inspection, int32_t body);

  Sheet& sheet_;
  std::map<std::string, ItemRect> items_;
  std::string revealed_;
  std::optional<PanelTab> wanted_tab_;
  std::map<std::string, float> edited_;  // numbers that are being typed on sliders
  std::map<std::string, std::string> typed_;
  size_t charted_error_ = 0;      // of played_errors()
  std::function<void()> chosen_;  // a key or page; acts after the frame, since it may replace the demonstration
  std::string hint_;
  float hint_left_ = 0, handle_left_ = 0;  // [s]
  Vec2 pointer_{-1e6f};
};

/// A setting's value as people write it: "4.17 ms".
std::string shown_value(const SettingInfo& setting, double value, const BodyShape& bodies);

/// Opens the tab that has an item, and scrolls to it. `draw` draws a frame. False if no tab has it.
bool bring_into_view(Panel& panel, const std::string& name, const std::function<void()>& draw);

/// The names of the items of all tabs.
std::vector<std::string> items_of_all_tabs(Panel& panel, const std::function<void()>& draw);

/// The width of the panel in use [pixel]: 0 while it is hidden.
int width_beside(const Panel& panel, PictureSize size, float scale);

}  // namespace ballpit
