// SPDX-License-Identifier: MIT
// ballpit render: a scene as numbered PNG frames, without a window or a display.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/progress.h"
#include "app/session.h"
#include "app/summary.h"
#include "core/error.h"
#include "export/frame_sequence.h"
#include "render/gl_context.h"
#include "render/overlays/overlay.h"
#include "render/renderer.h"

namespace ballpit {

namespace {

std::vector<std::string> theme_names() {
  std::vector<std::string> names;
  for (const Theme& theme : themes()) names.emplace_back(theme.name);
  return names;
}

std::vector<std::string> overlay_names() {
  std::vector<std::string> names;
  for (const OverlayEntry& overlay : overlay_table()) names.emplace_back(overlay.name);
  return names;
}

std::vector<std::string> parse_overlay_names(const std::string& text) {
  std::vector<std::string> result;
  if (text == "none") return result;
  const std::vector<std::string> known = overlay_names();
  for (const std::string& name : split_list(text)) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UserError("--overlay: found " + (name.empty() ? "nothing" : name) + ", allowed none alone, or some of " +
                      join(known) + ", with commas between");
    }
    result.push_back(name);
  }
  return result;
}

class RenderCommand final : public Command {
 public:
  void add_options(CLI::App& command) override {
    command.add_option("--out", out_, "folder for frame_00000.png, frame_00001.png, …")->type_name("DIR")->required();
    command.add_option("--frames", frames_, "number of frames")->type_name("N")->capture_default_str();
    command.add_option("--size", size_, "picture size in pixels")->type_name("WIDTHxHEIGHT")->capture_default_str();
    command.add_option("--fps", fps_, "frames a simulated second")->type_name("N")->capture_default_str();
    command.add_option("--every", every_, "write only every Kth frame")->type_name("K")->capture_default_str();
    command.add_option("--from", from_, "simulated time of the first frame")
        ->type_name("SECONDS")
        ->capture_default_str();
    command
        .add_option("--overlay", overlays_, "what to draw over the spheres: none, or some of " + join(overlay_names()))
        ->type_name("A,B,…")
        ->capture_default_str();
    command.add_option("--theme", theme_, join(theme_names()))->type_name("NAME")->capture_default_str();
    command.add_option("--supersample", supersample_, "draw N × N times larger and average, for stills: 1 to 4")
        ->type_name("N")
        ->capture_default_str();
    command.add_flag("--resume", resume_, "go on after the last whole frame in the folder")->disable_flag_override();
    command.add_flag("--json", json_, "print a summary as one JSON object")->disable_flag_override();
    arguments_.add_to(command);
  }

  void run() override {
    parse_path("--out", out_);
    const auto [width, height] = parse_size(size_);
    const int frames = static_cast<int>(parse_integer("--frames", frames_, 1, 100000));
    const double interval =
        double(parse_integer("--every", every_, 1, 1000000)) / parse_number("--fps", fps_, 1e-3, 1e6);
    const double from = parse_number("--from", from_, 0, 1e9);
    const std::vector<std::string> overlays = parse_overlay_names(overlays_);
    const RenderOptions options{theme_named(parse_choice("--theme", theme_, theme_names())),
                                static_cast<int>(parse_integer("--supersample", supersample_, 1, 4))};

    Session session(arguments_.scene(), arguments_.given());
    GlContext context;
    Renderer renderer(width, height, options);
    first_ = resume_ ? next_frame_index(out_) : 0;
    remove_frames(out_, first_, frames);
    catch_interrupts();
    const auto start = std::chrono::steady_clock::now();
    FrameSequence sequence(out_, first_);
    Progress progress("frames", frames);
    for (int k = first_; k < frames && !was_interrupted(); ++k) {
      session.advance_to(from + k * interval, was_interrupted);
      if (was_interrupted()) break;
      const Inspection inspection = session.world().inspect();
      renderer.draw(session.view_of(inspection, float(width) / float(height), overlays));
      sequence.push(renderer.read_pixels());
      progress.show(k + 1);
    }
    sequence.finish();
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (was_interrupted() && sequence.next_index() < frames) {
      throw RunError("interrupted after " + std::to_string(sequence.next_index()) + " of " + std::to_string(frames) +
                     " frames; --resume goes on from there");
    }
    tell(session, context, frames);
  }

 private:
  void tell(Session& session, const GlContext& context, int frames) {
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
              << "drawn by " << context.info().renderer << "\n";
  }

  /// Frames of an earlier, longer run are not this run's to remove; but they would be taken for its own.
  void warn_of_other_frames(int frames) const {
    const int found = next_frame_index(out_);
    if (found > frames) {
      std::cerr << "ballpit: note: " << frame_name(frames) << " to " << frame_name(found - 1) << " in " << out_
                << " are from an earlier run\n";
    }
  }

  SceneArguments arguments_;
  std::string out_, frames_ = "300", size_ = "1280x720", fps_ = "60", every_ = "1", from_ = "0", overlays_ = "grid";
  std::string theme_{themes().front().name}, supersample_ = "1";
  bool resume_ = false, json_ = false;
  int first_ = 0;
  double seconds_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_render_command() { return std::make_unique<RenderCommand>(); }

}  // namespace ballpit
