// SPDX-License-Identifier: MIT
// ballpit render: a scene as numbered PNG frames, a film, or both, without a window or a display.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "render/gl_context.h"
#include "render/overlays/overlay.h"
#include "show/demo_renderer.h"
#include "show/film.h"
#include "show/notes.h"
#include "window/panel.h"

namespace ballpit {

namespace {

class RenderCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add_path({"--out", "DIR", "folder for frame_00000.png, frame_00001.png, …"}, out_);
    command.add_path({"--film", "FILE.mp4", "film of the frames, made by ffmpeg; with or without --out"}, film_);
    command.add_number({"--frames", "N", "number of frames"}, frames_, Range{1, 100'000});
    command.add({"--size", "WIDTHxHEIGHT", "picture size in pixels", text_of(size_)},
                [this](const std::string& text) { size_ = parse_size(text); });
    command.add_number({"--fps", "N", "frames a simulated second"}, fps_, Range{1e-3, 1e6});
    command.add_number({"--every", "K", "write only every Kth frame"}, every_, Range{1, 1'000'000});
    command.add_number({"--from", "SECONDS", "simulated time of the first frame"}, from_, Range{0.0, 1e9});
    look_.add_to(command);
    command.add_number({"--supersample", "N", "draw N × N times larger and average, for stills"}, supersample_,
                       Range{1, 4});
    command.add_flag("--panel", has_panel_, "draw the panel beside the scene");
    command.add({"--click", "A,B,…", "items of the panel to click on before the first frame, by name"},
                [this](const std::string& text) { clicks_ = text; });
    command.add_flag("--copy-bodies", copies_bodies_,
                     "copy the spheres through the host even if their processor can write into OpenGL's memory");
    acts_.add_to(command);
    command.add_flag("--resume", resume_, "continue after the last complete frame in the folder");
    command.add_flag("--json", json_, "print a summary as one JSON object");
    arguments_.add_to(command);
  }

  void run() {
    if (out_.empty() && film_.empty()) {
      throw UserError("--out", "nothing", "--out DIR, --film FILE.mp4 or both", "see `ballpit render --help`");
    }
    if (!film_.empty()) check_film();
    if (look_.ui_scale && !has_panel_) throw UserError("--ui-scale", "without --panel", "together with it");
    if (clicks_ && !has_panel_) throw UserError("--click", *clicks_ + " without --panel", "together with it");

    if (resume_ && clicks_ && std::ranges::count(split_list(*clicks_), "cheapest") > 0) {
      throw UserError("--resume", "with --click cheapest", "without it, since a choice depends on measured times");
    }
    look_.check(arguments_, size_);
    const auto [width, height] = size_;
    const std::filesystem::path record = out_.empty() ? "" : std::filesystem::path(out_) / "choice.json";
    std::error_code ignored;
    const bool has_record = resume_ && std::filesystem::exists(record, ignored);
    Demo demo(arguments_.scene, arguments_.given, has_record ? record : "");
    look_.apply(demo, look_.preset);
    warn_of_run(demo.session);
    demo.play(acts_.read(demo.session));
    Session& session = demo.session;
    session.time_stages(json_ || has_panel_);
    if (!out_.empty()) check_output_folder(out_);
    FilmPlan plan{out_, "", 0, frames_, from_, every_ / fps_, has_panel_, film_, size_};
    plan.key = film_key(demo, plan, {size_, supersample_, has_panel_, clicks_.value_or("")});
    first_ = plan.first = frames_to_keep(plan.key);
    GlContext context(session.backend() == "cuda" ? 0 : -1);
    RenderOptions options{.supersample = supersample_};
    DemoRenderer drawing(width, height, options);
    if (copies_bodies_) drawing.copy_bodies();
    std::optional<Panel> panel;
    if (has_panel_) panel.emplace(drawing.renderer().sheet());
    const auto draw = [&](const PanelInput& input) {
      if (panel) options.left = Panel::width_in(width, height, demo.view.ui_scale);
      drawing.draw(demo, options);
      if (panel) panel->draw(demo, input);
    };
    if (clicks_) click(*panel, demo, draw);
    if (!out_.empty()) remove_frames(out_, first_, frames_);
    catch_interrupts();
    const auto start = std::chrono::steady_clock::now();
    Film film(demo, plan);
    if (session.choice() && !has_record && !out_.empty()) {
      write_file(record,
                 json_of(*session.choice(), arguments_.scene, session.scene(), arguments_.given).dump(2) + "\n");
    }
    Progress progress("frames", frames_);
    bool is_complete = false;
    try {
      while (!film.is_done() && !was_interrupted()) {
        advance(film, session);
        if (was_interrupted()) break;
        draw(PanelInput{});
        if (film.next() == first_ && look_.overlays) print_lacks(demo);
        if (panel && film.next() == first_) draw(PanelInput{});  // the panel knows its height from its first frame
        film.push(drawing.renderer().read_pixels());
        progress.show(film.next());
      }
      film.finish();
      is_complete = film.is_done();
    } catch (const Interrupted&) {
      // while ffmpeg was at work
    }
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!is_complete) {
      throw RunError(session.scene().name, fmt::format("interrupted after {} of {} frames", film.next(), frames_),
                     film_.empty() ? "--resume goes on from there" : "no film was written");
    }
    print_summary(demo, context, drawing.path(), plan);
  }

 private:
  /// Refuses what no film can be made of, before anything is drawn.
  void check_film() const {
    if (resume_) throw UserError("--resume", "with --film", "without it, since a film is made whole");
    if (size_.width % 2 != 0 || size_.height % 2 != 0) {
      throw UserError("--size", text_of(size_) + " with --film", "even sides");
    }
    if (fps_ / every_ < 1) {
      throw UserError("--film", fmt::format("{:g} frames a second (--fps by --every)", fps_ / every_), "1 or more");
    }
    check_film_file("--film", film_);
  }

  /// Of an earlier run with the same pictures.
  int frames_to_keep(const std::string& key) const {
    if (!resume_) return 0;
    const int count = next_frame_index(out_);
    check_frames(out_, count, key);
    return count;
  }

  static void print_lacks(Demo& demo) {
    for (const OverlayEntry& overlay : overlay_table()) {
      const std::string lack = demo.lack_of(overlay);
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

  /// Clicks as a user does: over the item, down, up; a frame for each. The next click comes when a choice is made.
  void click(Panel& panel, Demo& demo, const std::function<void(const PanelInput&)>& draw) const {
    const auto rest = [&] { draw(PanelInput{}); };
    rest();
    rest();
    for (const std::string& name : split_list(*clicks_)) {
      if (!bring_into_view(panel, name, rest)) {
        throw UserError("--click", name, "what the panel shows then: " + join(items_of_all_tabs(panel, rest)));
      }
      const Vec2 at = panel.items().at(name).middle();
      for (const bool is_down : {false, true, false, false}) draw(PanelInput{.mouse = at, .is_down = is_down});
      demo.finish_choosing();
    }
    panel.reveal("scene");
    rest();
  }

  /// What each method of a comparison has tested.
  static nlohmann::ordered_json comparison_of(Demo& demo) {
    nlohmann::ordered_json methods = nlohmann::ordered_json::array();
    for (size_t k = 0; k < demo.view_count(); ++k) {
      Demo& shown = demo.view_at(k);
      const Report& report = shown.report();
      methods.push_back({{"broadphase", report.broadphase},
                         {"tests", report.candidates},
                         {"tests_so_far", shown.tests_so_far()},
                         {"contacts", report.contacts}});
    }
    return methods;
  }

  void print_summary(Demo& demo, const GlContext& context, const std::string& path, const FilmPlan& plan) {
    Session& session = demo.session;
    if (!out_.empty()) warn_of_other_frames();
    const int made = std::max(frames_ - first_, 0);
    const double rate = made > 0 ? made / seconds_ : 0.0;
    const Report& report = session.report();
    double simulated = 0;  // [s] of computing, for all views
    for (size_t k = 0; k < demo.view_count(); ++k) simulated += demo.view_at(k).report().seconds;
    nlohmann::ordered_json json{{"scene", session.scene().name},
                                {"count", report.count},
                                {"out", out_.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(out_)},
                                {"film", json_of_film(plan)},
                                {"frames", frames_},
                                {"rendered", made},
                                {"size", text_of(size_)},
                                {"time", session.world().time()},
                                {"seconds", seconds_},
                                {"frames_per_second", rate},
                                {"simulation_seconds", simulated},
                                {"backend", session.backend()},
                                {"bodies", path},
                                {"renderer", context.info().renderer}};
    std::string compared;
    if (demo.is_comparing()) {
      json["compare"] = comparison_of(demo);
      for (const auto& method : json["compare"]) {
        compared += fmt::format("{}: {} tests so far, {} contacts\n", method["broadphase"].get<std::string>(),
                                method["tests_so_far"].get<int64_t>(), method["contacts"].get<int64_t>());
      }
    }
    print(json_, json,
          fmt::format(
              "{} frames of {} ({} spheres, {}) in {}\n{}{:g} frames a second: {:g} s, of which simulation ({}) {:g} "
              "s\ndrawn by {}, bodies {}\n{}",
              made, session.scene().name, report.count, text_of(size_), out_.empty() ? film_ : out_, text_of_film(plan),
              rate, seconds_, session.backend(), simulated, context.info().renderer, path, compared));
  }

  /// null if there is none.
  nlohmann::ordered_json json_of_film(const FilmPlan& plan) const {
    if (film_.empty()) return {};
    return {{"file", film_},
            {"frames_per_second", plan.rate()},
            {"seconds", frames_ / plan.rate()},
            {"speed", plan.rate() * plan.interval}};
  }

  std::string text_of_film(const FilmPlan& plan) const {
    if (film_.empty()) return "";
    const double speed = plan.rate() * plan.interval;
    return fmt::format("film of {:g} s, {}, in {}\n", frames_ / plan.rate(),
                       speed == 1 ? "in real time" : fmt::format("{:g} times slower than real time", 1 / speed), film_);
  }

  /// Frames of an earlier, longer run are not removed, but they could be taken for frames of this run.
  void warn_of_other_frames() const {
    const int found = next_frame_index(out_);
    if (found > frames_) note(out_, frame_name(frames_) + " to " + frame_name(found - 1) + " are from an earlier run");
  }

  SceneArguments arguments_;
  ActsArgument acts_;
  LookArguments look_;
  std::string out_, film_;
  int frames_ = 300, every_ = 1, supersample_ = 1;
  PictureSize size_{1280, 720};
  double fps_ = 60, from_ = 0;  // from [s]
  std::optional<std::string> clicks_;
  bool resume_ = false, json_ = false, has_panel_ = false, copies_bodies_ = false;
  int first_ = 0;       // frame that this run makes
  double seconds_ = 0;  // [s] for all frames
};

}  // namespace

std::function<void()> make_render_command(CommandOptions& options) { return make_command<RenderCommand>(options); }

}  // namespace ballpit
