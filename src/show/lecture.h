// SPDX-License-Identifier: MIT
// A lecture: a table of pages in a TOML file. A page is an absolute state, so nothing toggled earlier changes it.
//
//     [[page]]
//     id = "exchange"
//     slides = [14, 15]
//     title = "Insert by exchanging"
//     caption = "After {operations} operations 2 is before 6"    {names} are figures, counted when the page is shown
//     question = "Which is before, 2 or 6?"                      in the caption's place until the last stop
//     scene = "lecture-grid"
//     kernel = "linked-cell"              the slide's kernel is run and recorded (lecture/recorded_run.h)
//     interleaving = [6, 6, 2, 2]
//     stops = ["clear", "insert 6"]       where its cursor stops: after a phase, after a thread's part of it, or after
//                                         the first operations of that: "insert 6 1"
//     stored = { machine = "…" }          figures that differ from run to run, as a handout shows them
//
// docs/lecture.md lists all keys. A mistake is a UserError with file, line and key.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/language.h"
#include "lecture/recorded_run.h"
#include "methods/choices.h"
#include "scene/input_error.h"
#include "show/caption.h"
#include "show/options.h"
#include "show/view.h"

namespace ballpit {

/// A text in each language. German falls back to English.
struct LocalText {
  std::string en, de;
  const std::string& in(Language language) const { return language == Language::german && !de.empty() ? de : en; }
};

/// A mistake that a page makes on purpose: of its kernel (lecture::Mistakes), or of what the kernel is given.
enum class PageMistake { none, int_for_floor, no_wrap, both_halves, far_from_origin, stale_lists };
template <>
inline constexpr auto kNames<PageMistake> = in_order("none", "int-for-floor", "no-wrap", "both-halves",
                                                     "far-from-origin", "stale-lists");

/// `start`: the spheres at the start of the scene, which stale lists hold.
lecture::RunOptions run_options(PageMistake mistake, const lecture::Interleaving& interleaving,
                                const BodySnapshot& start);

inline constexpr std::string_view kStart = "start";  ///< the stop before the first operation

/// The cursor's place after a phase of the record, or after the operations of one thread in it.
struct PageStop {
  std::string phase;
  int thread = -1;      ///< −1: after the whole phase
  int operations = -1;  ///< of the thread in the phase; −1: all
};

struct Page {
  std::string id;
  std::vector<int> slides;  ///< of the lecture; none if the page goes beyond it
  LocalText title, caption, notes;
  LocalText question;  ///< in the caption's place until the cursor is at the last stop; empty: none
  std::string scene;
  double time = 0;  ///< [s] of the scene
  std::vector<GivenOption> options;
  View view;
  std::optional<lecture::KernelName> kernel;
  lecture::Interleaving interleaving;
  PageMistake mistake = PageMistake::none;
  std::vector<PageStop> stops;
  Figures stored;  ///< by their names, where nothing is measured: in a handout
  Place place;     ///< in the file, for errors
};

struct Lecture {
  LocalText title;
  std::vector<Page> pages;  ///< at least one
};

/// Reads a lecture's text. `file_name` is for errors; scenes in files are relative to `folder`.
Lecture parse_lecture(std::string_view text, std::string_view file_name, const std::filesystem::path& folder = {});

/// Reads the lecture in a file.
Lecture read_lecture(const std::filesystem::path& path);

/// The lecture that is built in: assets/lectures/.
const Lecture& built_in_lecture();

}  // namespace ballpit
