// SPDX-License-Identifier: MIT
// ballpit lecture: gives a lecture page by page; writes its handout, or lists its pages.
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "export/png.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "show/handout.h"
#include "show/presenter.h"
#include "window/lecture_window.h"

namespace ballpit {

namespace {

class LectureCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add({"FILE", "FILE", "the lecture's file; without one, the built-in lecture"},
                [this](const std::string& text) { file_ = text; });
    add_language(command);
    add_text_scale(command, text_scale_, Presenter::kTextScale);
    command.add_number({"--page", "N", "the page to begin with"}, page_, Range{1, 9999});
    command.add({"--size", "WIDTHxHEIGHT", "size of window or pictures in pixels", text_of(size_)},
                [this](const std::string& text) { size_ = parse_size(text); });
    command.add_path(
        {.name = "--export", .type = "DIR", .help = "write a handout into this folder: pictures and index.html"},
        export_);
    command.add_flag("--json", json_, "list the pages as one JSON object");
  }

  void run() {
    std::optional<Lecture> own;
    if (!file_.empty()) own = read_lecture(file_);
    const Lecture& lecture = own ? *own : built_in_lecture();
    if (page_ > static_cast<int>(lecture.pages.size())) {
      throw UserError("--page", std::to_string(page_), fmt::format("1 to {}", lecture.pages.size()));
    }
    Presenter presenter(lecture);
    presenter.text_scale = text_scale_.value_or(presenter.text_scale);
    if (!export_.empty()) return write_handout(lecture, presenter);
    if (json_) return print_pages(presenter);
    presenter.measures = true;
    catch_interrupts();
    Window window(size_, "Ballpit");
    try {
      presenter.go_to(page_);
      LectureWindow(window, presenter).run();
    } catch (const Interrupted&) {
      // within a long step
    }
  }

 private:
  static std::string picture_name(int page) { return fmt::format("page_{:02}.png", page); }

  void write_handout(const Lecture& lecture, Presenter& presenter) {
    check_output_folder(export_);
    const std::filesystem::path folder(export_);
    make_folder(folder);
    catch_interrupts();
    GlContext context(-1);
    Renderer renderer(size_.width, size_.height, {.theme = themes().front(), .text_scale = presenter.text_scale});
    const float aspect = static_cast<float>(size_.width) / static_cast<float>(size_.height);
    Progress progress("pages", presenter.count());
    std::vector<HandoutPicture> pictures;
    for (int number = 1; number <= presenter.count(); ++number) {
      if (was_interrupted()) throw RunError("lecture", fmt::format("interrupted after {} pages", number - 1));
      presenter.go_to(number);
      for (size_t stop = 0; stop < presenter.stops().size(); ++stop) {
        presenter.go_to_stop(stop);
        renderer.draw(presenter.frame_view(aspect));
        const std::string id =
            presenter.stops().size() == 1 ? presenter.page().id : fmt::format("{}-{}", presenter.page().id, stop + 1);
        pictures.push_back({id, presenter.title(), presenter.caption(), presenter.page().notes.in(language()),
                            encode_png(renderer.read_pixels(), {}, true)});
      }
      write_file(folder / picture_name(number), pictures.back().png);
      progress.show(number);
    }
    write_file(folder / "index.html", handout_page(lecture.title.in(language()), pictures));
  }

  void print_pages(Presenter& presenter) {
    nlohmann::ordered_json pages = nlohmann::ordered_json::array();
    for (int number = 1; number <= presenter.count(); ++number) {
      presenter.go_to(number);
      presenter.go_to_stop(presenter.stops().size() - 1);
      pages.push_back({{"number", number},
                       {"id", presenter.page().id},
                       {"slides", presenter.page().slides},
                       {"title", presenter.title()},
                       {"caption", presenter.caption()},
                       {"steps", presenter.stops().size()}});
    }
    const nlohmann::ordered_json json{{"pages", pages}};
    print(true, json, "");
  }

  std::string file_, export_;
  std::optional<float> text_scale_;
  int page_ = 1;
  PictureSize size_{1920, 1080};
  bool json_ = false;
};

}  // namespace

std::function<void()> make_lecture_command(CommandOptions& options) { return make_command<LectureCommand>(options); }

}  // namespace ballpit
