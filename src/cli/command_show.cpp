// SPDX-License-Identifier: MIT
// ballpit show: a window with the panel.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "cli/options.h"
#include "core/interrupt.h"
#include "show/notes.h"
#include "window/remembered.h"
#include "window/show_window.h"

namespace ballpit {

namespace {

class ShowCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add({"--size", "WIDTHxHEIGHT", "the window's size in pixels", text_of(kSize)},
                [this](const std::string& text) { size_ = parse_size(text); });
    look_.add_to(command);
    command.add_flag("--remember", remembers_,
                     "start with scene, options and view of the last `show --remember`, and store them at the end");
    acts_.add_to(command);
    arguments_.add_to(command);
  }

  void run() {
    look_.check(arguments_, size_.value_or(kSize));
    const std::filesystem::path file = remembers_ ? remembered_file() : "";
    if (remembers_) check_remembered(file);
    const std::unique_ptr<Demo> demo = start(recall(file));
    catch_interrupts();
    Window window(*size_, "Ballpit");
    try {
      ShowWindow(window, *demo).run();
    } catch (const Interrupted&) {
      // within a long step
    }
    if (!remembers_) return;
    const Session& session = demo->session;
    std::vector<GivenOption> given = session.given();
    if (demo->is_comparing()) std::erase_if(given, [](const auto& option) { return option.name == "broadphase"; });
    write_remembered(file, {lasting_name(session.scene_name()), given, demo->view, size_of(window)});
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
    View base = last ? last->view : look_.preset;
    if (!last && !arguments_.is_scene_given) base.turn = look_.turn_of_default;
    look_.apply(*demo, base);
    warn_of_run(demo->session);
    demo->play(acts_.read(demo->session));
    demo->measures = true;
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
  ActsArgument acts_;
  LookArguments look_{.preset = {.has_caption = true}, .turn_of_default = kSlowTurn};
  static constexpr PictureSize kSize{1600, 900};
  std::optional<PictureSize> size_;
  bool remembers_ = false;
};

}  // namespace

std::function<void()> make_show_command(CommandOptions& options) { return make_command<ShowCommand>(options); }

}  // namespace ballpit
