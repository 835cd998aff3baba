// SPDX-License-Identifier: MIT
// ballpit render: a scene as numbered PNG frames, without a window or a display.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/error.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "render/gl_context.h"
#include "render/overlays/overlay.h"
#include "show/demo_renderer.h"
#include "show/film.h"
#include "show/film_key.h"
#include "show/notes.h"
#include "window/panel.h"

namespace ballpit {

namespace {

class RenderCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override {
    command.add_option("--out", out_, "folder for frame_00000.png, frame_00001.png, …")->type_name("DIR")->required();
    command.add_option("--frames", frames_, "number of frames")->type_name("N")->shows_default();
    command.add_option("--size", size_, "picture size in pixels")->type_name("WIDTHxHEIGHT")->shows_default();
    command.add_option("--fps", fps_, "frames a simulated second")->type_name("N")->shows_default();
    command.add_option("--every", every_, "write only every Kth frame")->type_name("K")->shows_default();
    command.add_option("--from", from_, "simulated time of the first frame")->type_name("SECONDS")->shows_default();
    look_.add_to(command);
    command.add_option("--supersample", supersample_, "draw N × N times larger and average, for stills: 1 to 4")
        ->type_name("N")
        ->shows_default();
    command.add_flag("--panel", has_panel_, "draw the panel beside the scene");
    click_option_ =
        command.add_option("--click", clicks_, "items of the panel to click on before the first frame, by name")
            ->type_name("A,B,…");
    command.add_flag(
        "--copy-bodies", copies_bodies_,
        "copy the spheres through the host, also where their processor can write into OpenGL's memory; to compare");
    command.add_flag("--resume", resume_, "go on after the last whole frame in the folder");
    command.add_flag("--json", json_, "print a summary as one JSON object");
    arguments_.add_to(command);
  }

  void run() override {
    const auto [width, height] = parse_size(size_);
    const int frames = static_cast<int>(parse_integer("--frames", frames_, 1, 100000));
    const double interval =
        double(parse_integer("--every", every_, 1, 1000000)) / parse_number("--fps", fps_, 1e-3, 1e6);
    const double from = parse_number("--from", from_, 0, 1e9);
    const View look = look_.view();
    if (look_.scales_panel() && !has_panel_) throw UserError("--ui-scale", "without --panel", "together with it");
    const int supersample = static_cast<int>(parse_integer("--supersample", supersample_, 1, 4));
    if (click_option_->is_given() && !has_panel_) {
      throw UserError("--click", clicks_ + " without --panel", "together with it");
    }

    parse_path("--out", out_);
    Demo demo(arguments_.scene(), arguments_.given());
    demo.view = look;
    demo.touch();
    Session& session = demo.session;
    check_output_folder(out_);
    FilmPlan plan{out_, "", 0, frames, from, interval, has_panel_};
    plan.key = film_key(demo, plan, {{width, height}, supersample, has_panel_, clicks_});
    first_ = plan.first = frames_to_keep(plan.key);
    GlContext context(session.backend() == "cuda" ? 0 : -1);
    RenderOptions options{theme_named(look.theme), supersample,
                          has_panel_ ? Panel::width_in(width, height, look.ui_scale) : 0};
    DemoRenderer drawing(width, height, options);
    if (copies_bodies_) drawing.copy_bodies();
    std::optional<Panel> panel;
    if (has_panel_) panel.emplace(drawing.renderer().sheet());
    const auto draw = [&](const PanelInput& input) {
      if (panel) options.left = Panel::width_in(width, height, demo.view.ui_scale);
      drawing.draw(demo, options);
      if (panel) panel->draw(demo, input);
    };
    if (click_option_->is_given()) click(*panel, draw);
    remove_frames(out_, first_, frames);
    catch_interrupts();
    const auto start = std::chrono::steady_clock::now();
    Film film(demo, plan);
    Progress progress("frames", frames);
    while (!film.is_done() && !was_interrupted()) {
      advance(film, session);
      if (was_interrupted()) break;
      draw(PanelInput{});
      if (film.next() == first_ && look_.asks_for_overlays()) tell_lacks(demo);
      if (panel && film.next() == first_) draw(PanelInput{});  // the panel knows its height from its first frame
      film.push(drawing.renderer().read_pixels());
      progress.show(film.next());
    }
    film.finish();
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (was_interrupted() && film.next() < frames) {
      throw RunError(session.scene().name,
                     "interrupted after " + std::to_string(film.next()) + " of " + std::to_string(frames) + " frames",
                     "--resume goes on from there");
    }
    tell(session, context, drawing.path(), frames);
  }

 private:
  /// Of an earlier run with the same pictures.
  int frames_to_keep(const std::string& key) const {
    if (!resume_) return 0;
    const int count = next_frame_index(out_);
    check_frames(out_, count, key);
    return count;
  }

  static void tell_lacks(Demo& demo) {
    for (const OverlayEntry& overlay : overlay_table()) {
      const std::string lack = demo.view.shows(overlay.name) ? overlay.lack(demo.inspection()) : "";
      if (!lack.empty()) note("--overlay " + std::string(overlay.name), lack);
    }
  }

  static void advance(Film& film, Session& session) {
    try {
      film.advance(was_interrupted);
    } catch (const Interrupted&) {
      // within a long step
    } catch (const RunError& error) {
      throw error.with(rescue(session, session.scene().name + "-last-good.csv"));
    }
  }

  /// As a hand would: over the item, down, up; a frame for each.
  template <class Draw>
  void click(Panel& panel, const Draw& draw) const {
    draw(PanelInput{});
    draw(PanelInput{});
    for (const std::string& name : split_list(clicks_)) {
      const auto item = panel.items().find(name);
      if (item == panel.items().end()) {
        std::vector<std::string> names;
        for (const auto& known : panel.items()) names.push_back(known.first);
        throw UserError("--click", name, "what the panel shows then: " + join(names));
      }
      panel.reveal(name);
      draw(PanelInput{});
      draw(PanelInput{});
      const Vec2 at = panel.items().at(name).middle();
      for (const bool is_down : {false, true, false, false}) draw(PanelInput{.mouse = at, .is_down = is_down});
    }
    panel.reveal("scene");
    draw(PanelInput{});
  }

  void tell(Session& session, const GlContext& context, const std::string& path, int frames) {
    const int made = std::max(frames - first_, 0);
    warn_of_other_frames(frames);
    const nlohmann::ordered_json summary{{"scene", session.scene().name},
                                         {"count", session.world().report().count},
                                         {"out", out_},
                                         {"frames", frames},
                                         {"rendered", made},
                                         {"size", size_},
                                         {"time", session.world().time()},
                                         {"seconds", seconds_},
                                         {"frames_per_second", made > 0 ? made / seconds_ : 0.0},
                                         {"simulation_seconds", session.world().report().seconds},
                                         {"backend", session.backend()},
                                         {"bodies", path},
                                         {"renderer", context.info().renderer}};
    if (json_) {
      print_json(summary);
      return;
    }
    std::cout << made << " frames of " << session.scene().name << " (" << summary["count"] << " spheres, " << size_
              << ") in " << out_ << "\n"
              << summary["frames_per_second"].get<double>() << " frames a second: " << seconds_
              << " s, of which simulation (" << session.backend() << ") " << summary["simulation_seconds"].get<double>()
              << " s\n"
              << "drawn by " << context.info().renderer << ", bodies " << path << "\n";
  }

  /// Frames of an earlier, longer run are not this run's to remove; but they would be taken for its own.
  void warn_of_other_frames(int frames) const {
    const int found = next_frame_index(out_);
    if (found > frames) note(out_, frame_name(frames) + " to " + frame_name(found - 1) + " are from an earlier run");
  }

  SceneArguments arguments_;
  std::string out_, frames_ = "300", size_ = "1280x720", fps_ = "60", every_ = "1", from_ = "0";
  LookArguments look_;
  std::string supersample_ = "1";
  std::string clicks_;
  CommandOption* click_option_ = nullptr;
  bool resume_ = false, json_ = false, has_panel_ = false, copies_bodies_ = false;
  int first_ = 0;
  double seconds_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_render_command() { return std::make_unique<RenderCommand>(); }

}  // namespace ballpit
