// SPDX-License-Identifier: MIT
// ballpit compare: whether two pictures show the same. For the screenshot tests of a course: 0 for yes, 1 for no.
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/summary.h"
#include "core/error.h"
#include "core/file.h"
#include "export/picture_compare.h"
#include "export/png.h"

namespace ballpit {

namespace {

using Json = nlohmann::ordered_json;

std::string size_of(const Image& image) { return text_of(PictureSize{image.width, image.height}); }

/// What both show, or where they differ. Without a comparison they have other sizes.
struct Verdict {
  Image a, b;
  std::optional<Comparison> comparison{};

  bool is_same() const { return comparison && comparison->is_same(); }
  size_t pixels() const { return a.pixels.size() / 4; }
};

Verdict judge(Image a, Image b) {
  Verdict verdict{std::move(a), std::move(b)};
  if (size_of(verdict.a) == size_of(verdict.b)) verdict.comparison = comparison_of(verdict.a, verdict.b);
  return verdict;
}

/// "12 of 57600 pixels differ; …"
std::string what_differs(const Verdict& verdict) {
  const Comparison& found = *verdict.comparison;
  std::string text = fmt::format("{} of {} pixels differ", found.differing, verdict.pixels());
  if (found.differing > 0) {
    text += fmt::format(", {} of them in the block of {} x {} at ({}, {}), where {} may", found.worst_block,
                        kCompareBlock, kCompareBlock, found.left, found.top, kMaxDifferingInBlock);
  }
  return text + fmt::format("; the largest difference of a colour is {} of 255", found.largest);
}

Json json_of(const Verdict& verdict) {
  Json json{{"same", verdict.is_same()}, {"size_a", size_of(verdict.a)}, {"size_b", size_of(verdict.b)}};
  if (!verdict.comparison) return json;
  const Comparison& found = *verdict.comparison;
  json["pixels"] = verdict.pixels();
  json["differing"] = found.differing;
  json["largest_difference"] = found.largest;
  json["worst_block"] = {{"left", found.left}, {"top", found.top}, {"differing", found.worst_block}};
  return json;
}

class CompareCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add_path({.name = "A", .type = "PNG", .help = "a picture", .is_required = true}, a_);
    command.add_path({.name = "B", .type = "PNG", .help = "the picture to compare with it", .is_required = true}, b_);
    command.add_path({"--out", "FILE.png", "write both side by side, and what differs, as a PNG file"}, out_);
    command.add_flag("--json", json_, "print the result as one JSON object");
  }

  void run() {
    reject_same_file("--out", out_, "A", a_);
    reject_same_file("--out", out_, "B", b_);
    if (!out_.empty()) check_output(out_);
    const Verdict verdict = judge(read_png(a_), read_png(b_));
    if (!out_.empty()) write_png(out_, comparison_picture(verdict.a, verdict.b));
    if (verdict.is_same()) {
      print(json_, json_with_files(verdict),
            fmt::format("{} shows what {} shows: {}\n", b_, a_, what_differs(verdict)));
      return;
    }
    if (json_) print(true, json_with_files(verdict), "");
    const std::string see = out_.empty() ? "" : "see " + out_;
    if (!verdict.comparison) {
      throw RunError(b_, fmt::format("has {} pixels, and {} has {}", size_of(verdict.b), a_, size_of(verdict.a)), see);
    }
    throw RunError(b_, fmt::format("differs from {}: {}", a_, what_differs(verdict)), see);
  }

 private:
  Json json_with_files(const Verdict& verdict) const {
    Json json{{"a", a_}, {"b", b_}};
    json.update(json_of(verdict));
    json["out"] = out_.empty() ? Json() : Json(out_);
    return json;
  }

  std::string a_, b_, out_;
  bool json_ = false;
};

}  // namespace

std::function<void()> make_compare_command(CommandOptions& options) { return make_command<CompareCommand>(options); }

}  // namespace ballpit
