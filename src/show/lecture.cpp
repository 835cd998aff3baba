// SPDX-License-Identifier: MIT
#include "show/lecture.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/file.h"
#include "core/numbers.h"
#include "lecture_text.h"
#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "scene/read_scene.h"
#include "scene/read_sections.h"
#include "show/caption.h"
#include "show/options.h"

namespace ballpit {

namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr int64_t kMaxSlide = 999;
constexpr double kFar = 1 << 20;  // [m] from the origin, where floats are 1/8 m apart

LocalText read_text(const TableReader& reader, std::string_view key) {
  return {reader.text(key).value_or(""), reader.text(std::string(key) + "_de").value_or("")};
}

/// Its placeholders must be known.
LocalText read_caption(const TableReader& reader, const std::string& key) {
  const LocalText caption = read_text(reader, key);
  for (const auto& [place, text] : {std::pair{key, caption.en}, {key + "_de", caption.de}}) {
    if (const std::string unknown = unknown_placeholder(text); !unknown.empty()) {
      throw reader.error(place, unknown, join(names_in(placeholder_table())));
    }
  }
  return caption;
}

/// The integers of an array, or a single one.
std::vector<int> read_integers(const TableReader& reader, std::string_view key, int64_t high) {
  std::vector<int> result;
  const toml::node* node = reader.table().get(key);
  if (node == nullptr) return result;
  const std::string allowed = fmt::format("integers, 0 to {}", high);
  const auto add = [&](const toml::node& element) {
    const std::optional<int64_t> value = whole_number(element);
    if (!value || *value < 0 || *value > high) throw reader.error(key, describe(element), allowed);
    result.push_back(static_cast<int>(*value));
  };
  if (const toml::array* array = node->as_array()) {
    for (const toml::node& element : *array) add(element);
  } else {
    add(*node);
  }
  return result;
}

std::vector<std::string> read_texts(const TableReader& reader, std::string_view key) {
  std::vector<std::string> result;
  const toml::node* node = reader.table().get(key);
  if (node == nullptr) return result;
  const toml::array* array = node->as_array();
  if (array == nullptr) throw reader.error(key, describe(*node), "an array of texts");
  for (const toml::node& element : *array) {
    if (!element.is_string()) throw reader.error(key, describe(element), "texts in quotes");
    result.push_back(element.as_string()->get());
  }
  return result;
}

std::vector<std::string> read_overlays(const TableReader& reader) {
  std::vector<std::string> overlays = read_texts(reader, "overlays");
  const std::vector<std::string> known = names_in(overlay_table());
  for (const std::string& name : overlays) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw reader.error("overlays", in_quotes(name), join(known));
  }
  return overlays;
}

/// Checks each option by applying it, so that an error names the file and line.
std::vector<GivenOption> read_options(const TableReader& reader) {
  std::vector<GivenOption> options;
  for (const DefaultOption& option : read_defaults(reader, "options")) {
    Settings settings;
    apply_setting(settings, option.key, option.value, option.where);
    options.push_back({option.key, option.value});
  }
  return options;
}

/// [azimuth, elevation] in degrees and the zoom.
void read_camera(const TableReader& reader, View& view) {
  const std::optional<Vec3d> camera = reader.vector("camera", 3, {-360, 360});
  if (!camera) return;
  if (std::abs(camera->y) > 90) throw reader.error("camera", number_text(camera->y) + "° of elevation", "−90 to 90");
  if (camera->z < kMinZoom || camera->z > kMaxZoom) {
    throw reader.error("camera", number_text(camera->z) + " of zoom", text_of(Range{kMinZoom, kMaxZoom}));
  }
  view.azimuth = static_cast<float>(camera->x * kRadians);
  view.elevation = static_cast<float>(camera->y * kRadians);
  view.zoom = static_cast<float>(camera->z);
}

/// "insert 6 1": phase, thread, operations.
PageStop read_stop(const TableReader& reader, const std::string& text, lecture::KernelName kernel) {
  const std::vector<std::string> words = split_list(text, ' ');
  PageStop stop{words[0]};
  const std::vector<std::string_view> phases = lecture::phases_of(kernel);
  if (text == kStart) return stop;
  const bool is_phase = std::find(phases.begin(), phases.end(), stop.phase) != phases.end();
  constexpr Range kNumbers{0, std::numeric_limits<int>::max()};
  const std::optional<int> thread = words.size() > 1 ? number_in(kNumbers, words[1]) : -1;
  const std::optional<int> operations = words.size() > 2 ? number_in(kNumbers, words[2]) : -1;
  if (!is_phase || !thread || !operations || words.size() > 3) {
    throw reader.error(
        "stops", in_quotes(text),
        "start, or a phase of the kernel, alone or with the numbers of a thread and of its operations: " +
            join(phases));
  }
  stop.thread = *thread;
  stop.operations = *operations;
  return stop;
}

void read_kernel(const TableReader& reader, Page& page) {
  if (const auto kernel = reader.choice("kernel", kNames<lecture::KernelName>)) {
    page.kernel = static_cast<lecture::KernelName>(*kernel);
  }
  for (const char* const key : {"interleaving", "mistake", "stops"}) {
    if (reader.has(key) && !page.kernel) throw reader.error(key, "no kernel", "only with a kernel");
  }
  page.interleaving = read_integers(reader, "interleaving", lecture::kMaxRecorded - 1);
  if (const auto mistake = reader.choice("mistake", kNames<PageMistake>))
    page.mistake = static_cast<PageMistake>(*mistake);
  for (const std::string& text : read_texts(reader, "stops"))
    page.stops.push_back(read_stop(reader, text, *page.kernel));
}

/// Numbers or texts, by the names of placeholders.
Figures read_stored(const TableReader& reader) {
  Figures figures;
  const toml::node* node = reader.table().get("stored");
  if (node == nullptr) return figures;
  if (!node->is_table()) throw reader.error("stored", describe(*node), "figures by their names");
  for (const auto& [key, value] : *node->as_table()) {
    const std::vector<std::string> known = names_in(placeholder_table());
    const std::string name(key.str());
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw reader.error("stored", in_quotes(name), join(known));
    if (const std::optional<int64_t> number = whole_number(value)) {
      figures[name] = grouped(*number);
    } else if (value.is_string()) {
      figures[name] = value.as_string()->get();
    } else {
      throw reader.error("stored", describe(value), "whole numbers or texts");
    }
  }
  return figures;
}

/// A scene's path is relative to the lecture's file.
std::string read_scene_name(const TableReader& reader, const std::filesystem::path& folder) {
  const std::optional<std::string> scene = reader.text("scene");
  if (!scene) throw reader.missing("scene", "the name of a scene, or the path of one");
  return is_scene_file(*scene) ? (folder / *scene).string() : *scene;
}

Page read_page(const TableReader& reader, const std::filesystem::path& folder) {
  Page page;
  page.place = reader.place("id");
  const std::optional<std::string> id = reader.text("id");
  if (!id || id->empty()) throw reader.missing("id", "a name for the page");
  page.id = *id;
  page.slides = read_integers(reader, "slides", kMaxSlide);
  page.title = read_text(reader, "title");
  page.caption = read_caption(reader, "caption");
  page.question = read_caption(reader, "question");
  page.notes = read_text(reader, "notes");
  page.scene = read_scene_name(reader, folder);
  page.time = reader.number("time", kNotNegative).value_or(0);
  page.options = read_options(reader);
  page.view.overlays = read_overlays(reader);
  if (const std::optional<std::string> color = reader.text("color")) {
    const std::vector<std::string> known = names_in(coloring_table());
    if (std::find(known.begin(), known.end(), *color) == known.end())
      throw reader.error("color", in_quotes(*color), join(known));
    page.view.coloring = *color;
  }
  if (const std::optional<std::string> occlusion = reader.text("occlusion")) {
    if (*occlusion != "on" && *occlusion != "off") throw reader.error("occlusion", in_quotes(*occlusion), "on, off");
    page.view.occlusion = *occlusion == "on";
  }
  page.view.selected = reader.integer("select", 0, kLargestCount).value_or(-1);
  read_camera(reader, page.view);
  read_kernel(reader, page);
  page.stored = read_stored(reader);
  return page;
}

}  // namespace

lecture::RunOptions run_options(PageMistake mistake, const lecture::Interleaving& interleaving,
                                const BodySnapshot& start) {
  return {.interleaving = interleaving,
          .mistakes = {.truncates = mistake == PageMistake::int_for_floor,
                       .forgets_wrap = mistake == PageMistake::no_wrap,
                       .tests_twice = mistake == PageMistake::both_halves},
          .distance = mistake == PageMistake::far_from_origin ? kFar : 0,
          .inserted = mistake == PageMistake::stale_lists ? &start : nullptr};
}

Lecture parse_lecture(std::string_view text, std::string_view file_name, const std::filesystem::path& folder) {
  const toml::table table = parse_toml(text, file_name);
  const TableReader root(table, std::string(file_name), "", {"title", "title_de", "page"});
  Lecture lecture;
  lecture.title = read_text(root, "title");
  for (const toml::table* page : root.tables("page")) {
    const TableReader reader =
        root.nested(*page, "[[page]]", {"id",    "slides",   "title",    "title_de",    "caption",      "caption_de",
                                        "notes", "notes_de", "scene",    "time",        "options",      "overlays",
                                        "color", "select",   "camera",   "kernel",      "interleaving", "mistake",
                                        "stops", "stored",   "question", "question_de", "occlusion"});
    lecture.pages.push_back(read_page(reader, folder));
    const auto is_same = [&](const Page& other) { return other.id == lecture.pages.back().id; };
    if (std::count_if(lecture.pages.begin(), lecture.pages.end(), is_same) > 1) {
      throw reader.error("id", in_quotes(lecture.pages.back().id) + " a second time", "a name for each page");
    }
  }
  if (lecture.pages.empty()) throw root.missing("page", "tables [[page]]");
  return lecture;
}

Lecture read_lecture(const std::filesystem::path& path) {
  return parse_lecture(read_file(path), path.string(), path.parent_path());
}

const Lecture& built_in_lecture() {
  static const Lecture lecture = parse_lecture(lecture_text().front().text, lecture_text().front().name);
  return lecture;
}

}  // namespace ballpit
