// SPDX-License-Identifier: MIT
#include "show/film.h"

#include <array>
#include <sstream>

#include "core/language.h"
#include "core/numbers.h"
#include "export/png.h"

namespace ballpit {

namespace {

/// Adds a line. A text chunk of a PNG file holds printable ASCII only, so other characters become "?".
void append_line(std::string& key, std::string_view name, std::string_view value) {
  key.append(name) += ' ';
  for (const char c : value) key += c >= ' ' && c <= '~' ? c : '?';
  key += '\n';
}

void append_numbers(std::string& text, const std::vector<double>& values) {
  for (const double value : values) append_number(text += ' ', value);
}

std::string joined(const std::vector<double>& values) {
  std::string text;
  append_numbers(text, values);
  return text.substr(1);
}

void append_vectors(std::string& text, const std::vector<Vec3d>& values) {
  for (const Vec3d& v : values) append_numbers(text, {v.x, v.y, v.z});
}

/// FNV-1a, for what is too long to be written out. Source: Fowler, Noll, Vo, draft-eastlake-fnv.
std::string hash_of(std::string_view text) {
  uint64_t hash = 0xCBF29CE484222325u;
  for (const char c : text) hash = (hash ^ static_cast<uint8_t>(c)) * 0x100000001B3u;
  return fmt::format("{:016x}", hash);
}

/// The hash of domain, physics and spheres.
std::string hash_of_state(Session& session) {
  const Domain& domain = session.scene().domain;
  const Physics& physics = session.scene().physics;
  const Bodies bodies = session.world().bodies();
  std::string text = fmt::format("{} {} {}", domain.dimensions, static_cast<int>(domain.boundary), physics.law);
  append_numbers(text, {physics.restitution, physics.wall_restitution, physics.stiffness, physics.shear});
  append_vectors(text, {domain.min, domain.max, physics.gravity});
  append_vectors(text, bodies.position);
  append_vectors(text, bodies.velocity);
  append_numbers(text, bodies.radius);
  append_numbers(text, bodies.mass);
  return hash_of(text);
}

bool changes_pictures(std::string_view setting) {
  constexpr std::array<std::string_view, 6> kOthers{"backend", "threads", "max-overlap", "max-energy",
                                                    "count",   "seed"};  // the last two are part of the state
  return std::find(kOthers.begin(), kOthers.end(), setting) == kOthers.end();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string name_in(const std::string& line) { return line.substr(0, line.find(' ')); }

/// The line of this name, or "NAME of an unknown value".
std::string line_named(const std::string& name, const std::vector<std::string>& lines) {
  const auto found = std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return name_in(line) == name; });
  return found == lines.end() ? name + " of an unknown value" : *found;
}

}  // namespace

Film::Film(Demo& demo, const FilmPlan& all) : plan(all), demo_(demo), next_(all.first) {
  if (!plan.folder.empty()) frames_.emplace(plan.folder, plan.first, plan.key);
  if (!plan.file.empty()) file_.emplace(plan.file, plan.size.width, plan.size.height, plan.rate());
}

void Film::push(Image frame) {
  if (file_) file_->push(frame);
  if (frames_) frames_->push(std::move(frame));
  ++next_;
}

void Film::finish() {
  if (frames_) frames_->finish();
  if (file_ && is_done()) file_->finish();
}

bool Film::advance(const std::function<bool()>& stop) {
  Session& session = demo_.session;
  const double time = plan.from + next() * plan.interval;
  demo_.follow();  // a ghost begins where the film does
  while (plan.keeps_timeline && session.steps_until(time) > 0 && !stop()) {
    demo_.timeline->step();
    demo_.keep_together();
  }
  demo_.advance_to(time, stop);
  return session.steps_until(time) == 0;
}

bool Film::is_overtaken() const { return demo_.session.steps_until(plan.from + next() * plan.interval) < 0; }

std::string film_key(Demo& demo, const FilmPlan& plan, const FilmLook& look) {
  Session& session = demo.session;
  const View& view = demo.view;
  std::string key;
  append_line(key, "size", text_of(look.size));
  append_line(key, "scene", session.scene().name);
  append_line(key, "state", hash_of_state(session));
  append_line(key, "from", joined({plan.from}));
  append_line(key, "interval", joined({plan.interval}));
  const std::vector<Act>& acts = session.acts().all();
  append_line(key, "acts", acts.empty() ? "none" : hash_of(text_of(acts, session.scene().domain.dimensions, "")));
  append_line(key, "theme", view.theme);
  append_line(key, "color", view.coloring);
  append_line(key, "overlay", view.overlays.empty() ? "none" : join(view.overlays, ","));
  append_line(key, "view", joined({view.azimuth, view.elevation, view.zoom, static_cast<double>(view.selected)}));
  append_line(key, "turn", joined({view.turn}));
  const Domain& domain = session.scene().domain;
  const auto [min, max] = session.scene().view.value_or(Extent{domain.min, domain.max});
  append_line(key, "framed", joined({min.x, min.y, min.z, max.x, max.y, max.z}));
  append_line(key, "text", joined({view.text_scale}) + " " + std::string(name_of(language())));
  append_line(key, "caption", view.has_caption ? "on" : "off");
  append_line(key, "occlusion", view.occlusion ? "on" : "off");
  append_line(key, "compare", demo.is_comparing() ? join(demo.compared_methods(), ",") : "none");
  append_line(key, "supersample", std::to_string(look.supersample));
  append_line(key, "panel", look.has_panel ? joined({view.ui_scale}) + " " + look.clicks : "none");
  for (const SettingInfo& setting : setting_table()) {
    if (changes_pictures(setting.name)) append_line(key, setting.name, setting.get(session.settings()));
  }
  return key;
}

void check_frames(const std::string& folder, int count, const std::string& key) {
  const std::vector<std::string> allowed = lines_of(key);
  for (int index = 0; index < count; ++index) {
    const std::string name = frame_name(index);
    const std::optional<PngHead> head = read_png_head(std::filesystem::path(folder) / name);
    std::vector<std::string> found;
    if (head)
      found = lines_of(head->key.empty() ? "size " + text_of(PictureSize{head->width, head->height}) : head->key);
    const size_t compared =
        head && head->key.empty() ? 1 : allowed.size();  // a frame of an older version has only its size
    for (size_t k = 0; k < compared; ++k) {
      const std::string line = line_named(name_in(allowed[k]), found);
      if (line == allowed[k]) continue;
      throw UserError("--resume", name + " in " + folder + " with " + line, "frames with " + allowed[k],
                      "another --out, or no --resume, begins anew");
    }
  }
}

}  // namespace ballpit
