// SPDX-License-Identifier: MIT
// The panel beside the picture, by Dear ImGui: scene and time, detection, overlays, the picked sphere, cost, accuracy,
// response, export. Its choices come from the same tables as those of the command line; settings that a method does not
// use are not shown. The panel is drawn into the framebuffer that is bound, in a window or headless. It records the
// rectangle of each item by name, so that tests can click on items.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "render/sheet.h"
#include "show/demo.h"

namespace ballpit {

struct ItemRect {
  Vec2 low, high;  ///< [pixel] from the upper left corner
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
  bool is_log;
  const char* format;
  std::vector<SliderMark> marks{};
};

/// Requests of the user that the caller of the panel must handle.
struct PanelRequests {
  bool picture = false, state = false, film = false;
  std::string film_size = "1280x720";
  int film_frames = 300;
};

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

  /// Scrolls to an item in the next frame.
  void reveal(const std::string& name) { revealed_ = name; }

  float density = 1;        ///< set by the caller: pixels for one of an ordinary display
  bool is_filming = false;  ///< set by the caller
  PanelRequests requests;   ///< for the caller to handle and to clear

  /// All items of the last frame by name: "pause", "broadphase linked-cell", "overlay grid", …
  const std::map<std::string, ItemRect>& items() const { return items_; }

 private:
  void note(const std::string& name);
  bool section(const char* title);
  bool button(const std::string& name, const std::string& label);
  void combo(const std::string& name, const std::string& label, const std::string& current,
             const std::function<void()>& entries);
  bool entry(const std::string& name, const std::string& label, bool is_current);
  template <class Table>
  void choose(Demo& demo, const char* name, const char* label, const Table& table, std::string& current);
  void setting(Demo& demo, const SettingInfo& info);
  void number_setting(Demo& demo, const SettingInfo& info);
  bool slider(const std::string& name, const std::string& label, float& value, const SliderLook& look);
  void draw_marks(const SliderLook& look, float width);
  void row(const char* what, const std::string& value);
  void plot(const char* name, const float* values, size_t count, int stride, float from);

  void draw_time(Demo& demo);
  void draw_detection(Demo& demo);
  void draw_response(Demo& demo);
  void draw_view(Demo& demo);
  void draw_picked(Demo& demo);
  void draw_places(const Inspection& inspection, int32_t body);
  void draw_cost(Demo& demo);
  void draw_accuracy(Demo& demo);
  void draw_trade_off(Demo& demo);
  void draw_export();
  void draw_keys(Demo& demo);

  Sheet& sheet_;
  std::map<std::string, ItemRect> items_;
  std::string revealed_;
  std::map<std::string, float> edited_;  // sliders that are being dragged
  std::map<std::string, std::string> typed_;
  size_t charted_error_ = 0;  // of played_errors()
};

}  // namespace ballpit
