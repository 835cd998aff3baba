// SPDX-License-Identifier: MIT
// Every message of the program has one form: where, what was found, what is allowed; or where, and what happened.
// messages_table.cpp has a row for each place in src/ that makes one; this test reads the sources to find missing rows.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <regex>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/cli/messages_table.h"
#include "tests/support/run_program.h"
#include "window/remembered.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A place in the sources that makes an error: "scene/fill.cpp", and what stands between its parentheses.
struct Site {
  std::string file, code;
  bool is_run_error;
};

/// Paths of the program's sources from the project's root, those in src/ without it.
std::vector<std::string> source_files() {
  const fs::path root = BALLPIT_SOURCE_DIR;
  std::vector<std::string> files;
  for (const fs::path& folder : {root / "src", root / "cuda"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp" && extension != ".cu") continue;
      files.push_back(fs::relative(entry.path(), folder.filename() == "src" ? folder : root).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Without comments, and with single blanks.
std::string code_of(const std::string& file) {
  const std::string folder = file.starts_with("cuda/") ? BALLPIT_SOURCE_DIR "/" : BALLPIT_SOURCE_DIR "/src/";
  const std::string text = read_text(folder + file);
  return std::regex_replace(std::regex_replace(text, std::regex("//[^\n]*"), ""), std::regex("\\s+"), " ");
}

/// Constructors of the two errors and the functions that stand for them, but not their declarations.
std::vector<Site> sites_in(const std::string& file, const std::string& code) {
  static const std::regex made(
      "(UserError )?\\b(?:UserError|RunError|input_error)\\(|\\b(?:(?:reader|root)(?:\\.|->)|throw "
      ")(?:error|missing)\\(");
  std::vector<Site> sites;
  for (std::sregex_iterator match(code.begin(), code.end(), made), end; match != end; ++match) {
    if ((*match)[1].matched) continue;
    const auto start = static_cast<size_t>(match->position());
    sites.push_back({file, code.substr(start, code.find(';', start) - start), match->str().starts_with("RunError")});
  }
  return sites;
}

std::vector<Site> all_sites() {
  std::vector<Site> sites;
  for (const std::string& file : source_files()) {
    if (file.starts_with("core/error.")) continue;
    const std::vector<Site> some = sites_in(file, code_of(file));
    sites.insert(sites.end(), some.begin(), some.end());
  }
  return sites;
}

bool is_named(const Site& site, const std::string& name) {
  const size_t colon = name.find(": ");
  return site.file == name.substr(0, colon) && site.code.find(name.substr(colon + 2)) != std::string::npos;
}

/// The only site of this name.
Site site_named(const std::vector<Site>& sites, const std::string& name) {
  std::vector<Site> found;
  std::copy_if(sites.begin(), sites.end(), std::back_inserter(found), [&](const Site& s) { return is_named(s, name); });
  INFO(name << " names " << found.size() << " sites, allowed one");
  CHECK(found.size() == 1);
  return found.empty() ? Site{} : found.front();
}

/// One line, without what breaks it: WHERE: found FOUND, allowed ALLOWED.
bool has_form_of_user_error(const std::string& line) {
  static const std::regex form(
      "ballpit: [^[:cntrl:]]*[^[:cntrl:] ]: found [^[:cntrl:] ,][^[:cntrl:]]*, allowed [^[:cntrl:] ][^[:cntrl:]]*\n");
  return std::regex_match(line, form);
}

/// One line: WHERE: WHAT HAPPENED.
bool has_form_of_run_error(const std::string& line) {
  static const std::regex form("ballpit: [^[:cntrl:] :][^[:cntrl:]]*: [^[:cntrl:] ][^[:cntrl:]]*\n");
  return std::regex_match(line, form);
}

/// "ballpit: warning: WHERE: WHAT", or a note.
bool has_form_of_note(const std::string& line) {
  static const std::regex form("ballpit: (warning|note): [^[:cntrl:] :][^[:cntrl:]]*: [^[:cntrl:] ][^[:cntrl:]]*\n");
  return std::regex_match(line, form);
}

Outcome outcome_of(const Row& row) {
  std::vector<std::unique_ptr<Variable>> variables;
  for (const auto& [name, value] : row.variables) variables.push_back(std::make_unique<Variable>(name, value));
  Program program(row.arguments, row.circumstances);
  if (row.is_interrupted) {
    REQUIRE(program.wait_until_it_catches(SIGINT));
    program.signal(SIGINT);
  }
  return program.wait();
}

void write_program(const std::string& path, const std::string& text) {
  write_text(path, text);
  fs::permissions(path, fs::perms::owner_all);
}

/// What the rows read, beside a.toml and a.csv.
void write_files(const Scratch& scratch) {
  for (const char* folder : {"no-gl", "no-egl", "no-shell", "broken", "folder.mp4"})
    fs::create_directory(scratch / folder);
  write_text(scratch / "no-gl/libGL.so.1", "");
  write_text(scratch / "no-egl/libEGL.so.1", "");
  write_program(scratch / "no-shell/gnuplot", "#!/nowhere\n");
  for (const char* program : {"broken/gnuplot", "broken/ffmpeg"}) {
    write_program(scratch / program, "#!/bin/sh\necho broken >&2\nexit 1\n");
  }
  for (const char* folder : {"no-choice", "poor-choice"}) fs::create_directory(scratch / folder);
  write_text(scratch / "no-choice/choice.json", "nonsense");
  write_text(scratch / "poor-choice/choice.json", "{\"chosen\": {\"response\": \"penalty\", \"dt\": 0.1}}");
  write_text(scratch / "empty.toml", "[domain]\n");
  write_text(scratch / "b.toml", kBox + kSphere);
  write_text(scratch / "b.csv", "x,y,z,radius\n0,0,0,1\n");
  write_text(scratch / "heavy.csv", "x,y,z,radius\n0,0,0,1e12\n");
  write_text(scratch / "many.toml", "[[fill]]\ncount = 8000000\nradius = 0.002\narrangement = 'lattice'\n");
  std::string heap = "x,y,z,radius\n";
  for (int k = 0; k < 30'000; ++k) heap += "0,0,0,1\n";
  write_text(scratch / "heap.csv", heap);
  Arguments film = kRender;
  film.back() = scratch / "old";
  REQUIRE(run_program(film).status == 0);
  for (const char* theme : {"projector", "dark"}) {
    film.back() = scratch / theme;
    Arguments themed = film;
    themed.insert(themed.end(), {"--theme", theme});
    REQUIRE(run_program(themed).status == 0);
  }
  const std::string picture = scratch / "dark/frame_00000.png";
  REQUIRE(run_program({"compare", picture, picture, "--out", scratch / "large.png"}).status == 0);
  fs::create_directories(scratch / "old/frame_00002.png/x");
}

}  // namespace

TEST_CASE("every message has its form: where, what was found, what is allowed, or where, and what happened") {
  const Scratch scratch;
  write_files(scratch);
  const std::vector<Site> sites = all_sites();
  for (Row row : all_rows()) {
    const bool is_limited = row.circumstances.memory > 0;
    if (is_limited && is_sanitized()) continue;
    row.circumstances.folder = scratch.path().string();
    for (auto& [name, value] : row.variables) {
      if (fs::exists(scratch / value) && !value.empty()) value = scratch / value;
    }
    write_text(scratch / "a.toml", row.text);
    write_text(scratch / "a.csv", row.text);
    const bool is_run_error = site_named(sites, row.site).is_run_error;
    const Outcome outcome = outcome_of(row);
    INFO(row.site << " says\n" << outcome.err);
    CHECK(outcome.status == (is_run_error ? 1 : 2));
    const bool prints = is_run_error && row.arguments.front() == "choose";  // what was tried
    CHECK((prints || outcome.out.empty()));
    std::string line = outcome.err;
    // A long command may say notes before.
    while (line.starts_with("ballpit: note: ") || line.starts_with("ballpit: warning: "))
      line.erase(0, line.find('\n') + 1);
    CHECK((is_run_error ? has_form_of_run_error(line) : has_form_of_user_error(line)));
    CHECK_THAT(line, Contains(row.said));
  }
}

TEST_CASE("each place that makes an error has a row, or a reason why nothing reaches it") {
  const std::vector<Site> sites = all_sites();
  CHECK(sites.size() > 100);
  std::vector<std::string> names;
  for (const Row& row : all_rows()) names.push_back(row.site);
  for (const Unreached& site : unreached()) names.push_back(site.site);
  for (const Unreached& site : unreached_of_choices()) names.push_back(site.site);
  for (const Unreached& site : unreached_of_pictures()) names.push_back(site.site);
  for (const std::string& name : names) site_named(sites, name);
  for (const Site& site : sites) {
    INFO(site.file << ": " << site.code << " is in no row of this file");
    CHECK(std::any_of(names.begin(), names.end(), [&](const std::string& name) { return is_named(site, name); }));
  }
}

TEST_CASE("warnings and notes have one form, on lines of their own") {
  const Scratch scratch;
  write_text(scratch / "bare.toml", "[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = 0.1\n");
  write_text(scratch / "box.toml", kBox + "boundary = 'periodic'\n" + kSphere);
  write_text(scratch / "outside.toml",
             kBox + "boundary = 'periodic'\n[[spheres]]\nposition = [15, 5, 5]\nradius = 1\n");
  write_text(scratch / "columns.csv", "x,y,z,radius,name\n0,0,0,1,a\n");
  write_text(scratch / "far.csv", "x,y,z,radius\n1e7,0,0,1\n");
  write_text(scratch / "apart.csv", "x,y,z,radius\n0,0,0,1\n150,0,0,1\n");
  Arguments film = kRender;
  film[5] = "2";
  const std::vector<std::pair<std::string, Arguments>> rows{
      {"warning: bare.toml: found no [domain]", {"simulate", "bare.toml", "--time", "0"}},
      {"warning: outside.toml: 1 of 1 spheres", {"simulate", "outside.toml", "--time", "0"}},
      {"warning: --cell-size 0.5: below 1, ", {"simulate", "box.toml", "--time", "0", "--cell-size", "0.5"}},
      {"warning: columns.csv:1: ", {"pairs", "columns.csv"}},
      {"warning: far.csv: coordinates as large as 1e+07", {"pairs", "far.csv"}},
      {"warning: apart.csv: 1 of 2 spheres were outside", {"pairs", "apart.csv", "--period", "100,100,100"}},
      {"note: --overlay grid: ", render({"--overlay", "grid", "--broadphase", "brute-force"})},
      {"", film},
      {"note: film: frame_00001.png", kRender},
  };
  for (const auto& [said, arguments] : rows) {
    Circumstances here;
    here.folder = scratch.path().string();
    const Outcome outcome = run_program(arguments, here);
    INFO(said << "\n" << outcome.err);
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.err, Contains(said));
    std::istringstream lines(outcome.err);
    for (std::string line; std::getline(lines, line);) CHECK(has_form_of_note(line + "\n"));
  }
}

TEST_CASE("a mistake in the remembered file is printed as a note, with file and key") {
  const Scratch scratch;
  fs::create_directory(scratch / "ballpit");
  const Variable config("XDG_CONFIG_HOME", scratch.path().string()), display("DISPLAY", ""),
      wayland("WAYLAND_DISPLAY", "");
  const std::string file = remembered_file().string();
  Remembered good;
  good.scene = "rain";
  good.size = {1280, 720};
  write_remembered(file, good);
  const std::string text = read_text(file);
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string changed = text;
    return changed.replace(changed.find(what), what.size(), instead);
  };
  const std::string theme = "\"" + good.view.theme + "\"", coloring = "\"" + good.view.coloring + "\"";
  for (const auto& [changed, said] : std::vector<std::pair<std::string, std::string>>{
           {"{", ": found something else, allowed what `ballpit show --remember` writes"},
           {with("\"version\": 1", "\"version\": 99"), ": version: found 99, allowed 1"},
           {with("\"zoom\": 1.0", "\"zoom\": 1e9"), ": zoom: found 1000000000.0, allowed "},
           {with(theme, "\"pink\""), ": --theme: found pink, allowed "},
           {with(coloring, "\"mood\""), ": --color: found mood, allowed "}}) {
    write_text(file, changed);
    const Outcome outcome = run_program({"show", "--remember"});
    INFO(outcome.err);
    CHECK(outcome.status == 1);  // there is no display
    const std::string line = outcome.err.substr(0, outcome.err.find('\n') + 1);
    CHECK(has_form_of_note(line));
    CHECK_THAT(line, Catch::StartsWith("ballpit: note: --remember: nothing is remembered: " + file + said));
  }
}

TEST_CASE("only main, the notes and the progress bar write to standard error") {
  for (const std::string& file : source_files()) {
    if (file == "cli/main.cpp" || file == "show/notes.h" || file == "cli/progress.cpp") continue;
    INFO(file);
    CHECK_FALSE(std::regex_search(code_of(file), std::regex("\\b(std::cerr|std::clog|stderr)\\b")));
  }
}
