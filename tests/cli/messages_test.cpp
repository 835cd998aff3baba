// SPDX-License-Identifier: MIT
// Every message of the program has one form: where, what was found, what is allowed; or where, and what happened. The table
// below has a row for each place in src/ that makes one; the sources are read to see that none is missing.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <regex>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/support/run_program.h"
#include "window/remembered.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

/// A place in the sources that makes an error: "scene/fill.cpp", and what stands between its parentheses.
struct Site {
  std::string file, code;
  bool is_run_error;
};

/// Where the program runs, and what runs it; what it says, and which site says so: "FILE: a part of its code".
struct Row {
  std::string site, said;
  Arguments arguments;
  std::string text = {};  ///< of a.toml and a.csv
  std::vector<std::pair<const char*, std::string>> variables = {};
  Circumstances circumstances = {};
  bool is_interrupted = false;
};

/// A site that no command line reaches, with the reason.
struct Unreached {
  std::string site, reason;
};

const Arguments kRender{"render", "two-spheres", "--size", "64x36", "--frames", "1", "--out", "film"};

Arguments render(const Arguments& more) {
  Arguments arguments = kRender;
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Row scene(const std::string& site, const std::string& said, const std::string& text, const Arguments& more = {}) {
  Arguments arguments{"simulate", "a.toml", "--time", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return {site, said, arguments, text};
}

Row csv(const std::string& site, const std::string& said, const std::string& text) {
  return {site, said, {"pairs", "a.csv"}, text};
}

Row interrupted(const std::string& site, const std::string& said, const Arguments& arguments) {
  Row row{site, said, arguments};
  row.is_interrupted = true;
  return row;
}

const std::string kBox = "[domain]\nmin = [0, 0, 0]\nmax = [10, 10, 10]\n";
const std::string kSphere = "[[spheres]]\nposition = [5, 5, 5]\nradius = 1\n";

std::vector<Row> rows_of_commands() {
  const std::vector<std::pair<const char*, std::string>> no_cuda{{"CUDA_VISIBLE_DEVICES", ""}};
  const std::vector<std::pair<const char*, std::string>> no_display{{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
  return {
      {"cli/command_line.cpp: \"command\"", "command: found nothing, allowed show", {}},
      {"cli/command_line.cpp: found, allowed", "list: found extra, allowed options alone", {"list", "extra"}},
      {"cli/command_line.cpp: unknown option", "list: found unknown option --frob", {"list", "--frob"}},
      {"cli/command_line.cpp: \"a value\"", "--json: found a value, allowed none", {"list", "--json=1"}},
      {"cli/command_line.cpp: values", "--dt: found 2 values", {"simulate", "--dt", "1", "--dt", "2"}},
      {"cli/command_line.cpp: (name, \"nothing\"", "--time: found nothing, allowed SECONDS", {"simulate", "--time"}},
      {"cli/command_line.cpp: get_name(), \"nothing\"", "--out: found nothing, allowed DIR", {"render"}},
      {"show/parse.h: kKind", "--time: found x, allowed a number from", {"simulate", "--time", "x"}},
      {"show/parse.cpp: choices", "--theme: found pink, allowed projector", render({"--theme", "pink"})},
      {"show/parse.cpp: a path", "--out: found nothing, allowed a path", {"simulate", "--out", ""}},
      {"show/parse.cpp: as well",
       "--trajectory: found x, which is --out",
       {"simulate", "--out", "x", "--trajectory", "x"}},
      {"show/parse.cpp: none alone", "--overlay: found mood, allowed none", render({"--overlay", "mood"})},
      {"show/parse.cpp: WIDTHxHEIGHT", "--size: found 8, allowed WIDTH", {"render", "--out", "film", "--size", "8"}},
      {"cli/observe.cpp: --observe", "--observe: found pear, allowed all", {"simulate", "--observe", "pear"}},
      {"show/backends.cpp: --backend", "--backend: found cuda, which", {"simulate", "--backend", "cuda"}, "", no_cuda},
      {"cli/command_bench.cpp: --backends",
       "--backends: found cuda, which",
       {"bench", "--backends", "cuda"},
       "",
       no_cuda},
      {"cli/command_simulate.cpp: --every", "--every: found 2 without --trajectory", {"simulate", "--every", "2"}},
      {"cli/command_render.cpp: --ui-scale", "--ui-scale: found without --panel", render({"--ui-scale", "2"})},
      {"cli/command_render.cpp: clicks_ +", "--click: found pause without --panel", render({"--click", "pause"})},
      {"cli/command_render.cpp: the panel shows", "--click: found x, allowed what",
       render({"--panel", "--click", "x"})},
      {"show/film_key.cpp: --resume",
       "--resume: found frame_00000.png in old with ",
       {"render", "two-spheres", "--size", "64x48", "--frames", "1", "--out", "old", "--resume"}},
      {"show/given_options.cpp: \"--\"",
       "--precision: found float",
       {"simulate", "--response", "event-driven", "--precision", "float"}},
      {"cli/pair_input.cpp: along", "--period: found 1 along x with radius 1", {"pairs", "b.csv", "--period", "1,1,1"}},
      {"cli/pair_input.cpp: X,Y,Z", "--period: found 1, allowed X,Y,Z", {"pairs", "b.csv", "--period", "1"}},
      {"cli/pair_input.cpp: with the scene",
       "--period: found with the scene b.toml",
       {"pairs", "b.toml", "--period", "1,1,1"}},
      {"show/session.cpp: --dt", "--dt: found 1e-12, which makes", {"simulate", "--time", "1e9", "--dt", "1e-12"}},
      {"window/remembered.cpp: neither",
       "--remember: found neither",
       {"show", "--remember"},
       "",
       {{"HOME", ""}, {"XDG_CONFIG_HOME", ""}}},
      {"window/window.cpp: glfw_reason()", "show: no window: ", {"show"}, "", no_display},
      {"window/window.cpp: trouble)",
       "show: no window: cannot load libGL.so.1",
       {"show"},
       "",
       {{"LD_LIBRARY_PATH", "no-gl"}}},
      {"cli/main.cpp: standard output", "standard output: cannot write: ", {"list"}, "", {}, {0, "/dev/full"}},
      {"cli/main.cpp: out of memory",
       "simulate: out of memory; fewer",
       {"simulate", "many.toml"},
       "",
       {},
       {200'000'000}},
      {"cli/command_pairs.cpp: out of memory",
       "heap.csv: out of memory; ",
       {"pairs", "heap.csv", "--threads", "2"},
       "",
       {},
       {1'000'000'000}},
      interrupted("cli/command_bench.cpp: interrupted", "bench: interrupted after ",
                  {"bench", "--counts", "100", "--repeat", "1000", "--limit", "1000"}),
      interrupted("cli/command_simulate.cpp: interrupted", "rain: interrupted after ",
                  {"simulate", "rain", "--time", "1e6"}),
      interrupted("cli/command_render.cpp: interrupted", "rain: interrupted after ",
                  {"render", "rain", "--size", "64x36", "--frames", "100000", "--out", "rain"}),
      interrupted("lab/measure/lab.cpp: interrupted", "cell-size: interrupted after ",
                  {"lab", "cell-size", "--quick", "--out", "lab"}),
      {"core/file.cpp: cannot write",
       "no/x.csv: cannot write: No such file",
       {"simulate", "--time", "0", "--out", "no/x.csv"}},
      {"core/file.cpp: cannot make the folder",
       "b.csv/film: cannot make the folder: Not a",
       {"render", "--out", "b.csv/film"}},
      {"core/file.cpp: no readable file", "no.toml: found no readable file (No such file", {"simulate", "no.toml"}},
      {"core/file.cpp: a folder", "./: found a folder, allowed a file", {"simulate", "./"}},
      {"core/file.cpp: no readable file", "no.csv: found no readable file (No such file", {"pairs", "no.csv"}},
      {"scene/line_reader.cpp: a folder", "old: found a folder, allowed a file", {"pairs", "old"}},
      {"export/frame_sequence.cpp: cannot remove",
       "old/frame_00002.png: cannot remove: ",
       {"render", "two-spheres", "--size", "64x36", "--frames", "4", "--out", "old"}},
      {"lab/experiments/experiment.cpp: EXPERIMENT",
       "EXPERIMENT: found nonsense, allowed all, ",
       {"lab", "nonsense", "--out", "lab"}},
      {"lab/charts/gnuplot.cpp: cannot start",
       "divergence: ",
       {"lab", "divergence", "--quick", "--out", "lab"},
       "",
       {{"PATH", "no-shell"}}},
      {"lab/charts/gnuplot.cpp: failed on chart",
       "failed on chart ",
       {"lab", "divergence", "--quick", "--out", "lab"},
       "",
       {{"PATH", "broken"}}},
      {"render/gl_context.cpp: + trouble",
       "OpenGL: no OpenGL 4.5 context: cannot load libEGL.so.1",
       kRender,
       "",
       {{"LD_LIBRARY_PATH", "no-egl"}}},
      {"render/gl_context.cpp: without a display",
       "OpenGL: no OpenGL 4.5 context without a display: ",
       kRender,
       "",
       {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"}}},
      {"render/render_target.cpp: --size",
       "--size: found 65536x",
       {"render", "two-spheres", "--size", "16384x16", "--supersample", "4", "--frames", "1", "--out", "film"}},
  };
}

std::vector<Row> rows_of_scenes() {
  const std::string fill = "[[fill]]\ncount = 10\nradius = 1\n";
  return {
      {"scene/catalog.cpp: SCENE", "SCENE: found \"nosuch\", allowed ", {"simulate", "nosuch"}},
      scene("scene/table_reader.cpp: a syntax error", "a.toml:1: found a syntax error: ", "[domain"),
      scene("scene/table_reader.cpp: an unknown key", "a.toml:1: titel: found an unknown key", "titel = 'x'"),
      scene("scene/table_reader.cpp: line_of(node.source())", "[physics] restitution: found 2, allowed",
            "[physics]\nrestitution = 2"),
      scene("scene/table_reader.cpp: an integer", "[domain] dimensions: found 4, allowed an integer",
            "[domain]\ndimensions = 4"),
      scene("scene/table_reader.cpp: a text in quotes", "title: found 3, allowed a text", "title = 3"),
      scene("scene/table_reader.cpp: join(names)", "[domain] boundary: found \"x\", allowed walls",
            "[domain]\nboundary = 'x'"),
      scene("scene/table_reader.cpp: an array of 3 numbers", "[domain] min: found 1, allowed an array",
            "[domain]\nmin = 1"),
      scene("scene/table_reader.cpp: low and high", "radius: found an array of 3 values",
            "[[fill]]\ncount = 1\nradius = [1, 2, 3]"),
      scene("scene/table_reader.cpp: before", "radius: found 2 before 1", "[[fill]]\ncount = 1\nradius = [2, 1]"),
      scene("scene/table_reader.cpp: (key, describe(*node), allowed", "fill: found 3, allowed tables", "fill = 3"),
      scene("scene/table_reader.cpp: line_of(element.source())", "fill: found 3, allowed tables", "fill = [3]"),
      scene("scene/table_reader.cpp: a table \" + label", "domain: found 3, allowed a table [domain]", "domain = 3"),
      scene("scene/table_reader.h: full_key(key)", "titel: found an unknown key", "titel = 'x'"),
      scene("scene/input_error.cpp: which makes a mass", "radius: found 1e+12, which makes a mass of",
            kBox + "[[spheres]]\nposition = [5, 5, 5]\nradius = 1e12"),
      scene("scene/read_sections.cpp: at least", "[[fill]] min: found -1 at [0], allowed at least 0",
            kBox + fill + "min = [-1, 0, 0]"),
      scene("scene/read_sections.cpp: at most", "[[fill]] max: found 20 at [0], allowed at most 10",
            kBox + fill + "max = [20, 1, 1]"),
      scene("scene/read_sections.cpp: min below max", "[[fill]] max: found 5 to 5",
            kBox + fill + "min = [5, 0, 0]\nmax = [5, 9, 9]"),
      scene("scene/read_sections.cpp: min below max", "[domain] max: found 0 to 0",
            "[domain]\nmax = [0, 1, 1]"),
      scene("scene/read_sections.cpp: true or false", "[defaults] dt: found an array of 1", "[defaults]\ndt = [1]"),
      scene("scene/read_sections.cpp: \"position\"", "[[spheres]] position: found nothing", "[[spheres]]\nradius = 1"),
      scene("scene/read_sections.cpp: limits_text(kPositive)", "[[spheres]] radius: found nothing",
            "[[spheres]]\nposition = [0, 0, 0]"),
      scene("scene/read_sections.cpp: \"count\"", "[[fill]] count: found nothing", "[[fill]]\nradius = 1"),
      scene("scene/read_sections.cpp: low and high", "[[fill]] radius: found nothing", "[[fill]]\ncount = 1"),
      scene("scene/read_sections.cpp: both speed", "[[fill]] speed: found both",
            kBox + fill + "speed = 1\nvelocity = [0, 0, 0]"),
      scene("scene/read_scene.cpp: no such file", "spheres: found \"no.csv\", but no such file", "spheres = 'no.csv'"),
      scene("scene/read_scene.cpp: tables [[spheres]]", "spheres: found 3, allowed tables", "spheres = 3"),
      scene("scene/table_reader.cpp: an integer", "[defaults] count: found -1", kBox + fill + "[defaults]\ncount = -1"),
      scene("scene/read_scene.cpp: only in a scene", "[defaults] count: found 5, allowed only",
            kSphere + "[defaults]\ncount = 5"),
      scene("scene/read_scene.cpp: altogether", "found 120000000 spheres altogether",
            kBox + "[[fill]]\ncount = 60000000\nradius = 1\n[[fill]]\ncount = 60000000\nradius = 1"),
      scene("scene/check_spheres.cpp: reaching from", "found sphere 0 reaching from",
            kBox + "[[spheres]]\nposition = [0, 5, 5]\nradius = 1"),
      scene("scene/check_spheres.cpp: overlapping by", "overlapping by 2 m", kBox + kSphere + kSphere),
      scene("scene/check_spheres.cpp: an edge of", "[domain] max: found an edge of 10",
            kBox + "boundary = 'periodic'\n[[spheres]]\nposition = [5, 5, 5]\nradius = 3"),
      scene("scene/fill_room.cpp: \"[[fill]] radius\"", "[[fill]] radius: found 6",
            kBox + "[[fill]]\ncount = 1\nradius = 6"),
      scene("scene/fill.cpp: random placement", "[[fill]] count: found 1000 spheres",
            kBox + "[[fill]]\ncount = 1000\nradius = 1"),
      scene("scene/fill.cpp: no more fit", "[[fill]] count: found 1000, allowed at most",
            kBox + "[[fill]]\ncount = 1000\nradius = 1\narrangement = 'lattice'"),
      csv("scene/csv_header.cpp: twice", "a.csv:1: header: found \"x\" twice", "x,y,z,x,radius\n"),
      csv("scene/csv_header.cpp: UTF-16", "a.csv:1: header: found text in UTF-16",
          "\xFF\xFE"
          "x,y"),
      csv("scene/csv_header.cpp: header\", found", "a.csv:1: header: found \"a\", no column", "a\n1\n"),
      csv("scene/csv_rows.cpp: an empty file", "a.csv:1: header: found an empty file", ""),
      csv("scene/csv_rows.cpp: quotes around", "a.csv:2: x: found a quote", "x,y,z,radius\n\"1,2,3,4\n"),
      csv("scene/csv_rows.cpp: quoted(field)", "a.csv:2: x: found \"1,234\"", "x,y,z,radius\n\"1,234\",2,3,4\n"),
      csv("scene/csv_rows.cpp: quoted(field)", "a.csv:3: x: found \"1,5\"", "x;y;z;radius\n1.5;2;3;4\n1,5;2;3;4\n"),
      csv("scene/csv_rows.cpp: quoted(field)", "a.csv:2: x: found \"one\", allowed a number",
          "x,y,z,radius\none,2,3,4\n"),
      csv("scene/csv_rows.cpp: {} field", "a.csv:2: row: found 2 fields", "x,y,z,radius\n1,2\n"),
      csv("scene/line_reader.cpp: kBufferSize", "a.csv:2: line: found more than 1048576 bytes",
          "x,y,z,radius\n" + std::string(1'100'000, '1')),
      scene("scene/input_error.cpp: which makes a mass", "radius: found 1e+12, which makes", "spheres = 'heavy.csv'"),
      scene("show/given_options.cpp: option.where", "a.toml:2: [defaults] precision: found float",
            "[defaults]\nprecision = 'float'\nresponse = 'event-driven'"),
      scene("methods/settings.cpp: no option of this name", "[defaults] frob: found no option", "[defaults]\nfrob = 1"),
      {"methods/settings.cpp: info->allowed", "--dt: found x, allowed 1e-12 to 10", {"simulate", "--dt", "x"}},
      scene("broad_phase/grid.cpp: --cell-size", "--cell-size: found 1, which needs",
            "[domain]\nmax = [1e6, 1e6, 1e6]\n" + kSphere,
            {"--broadphase", "linked-cell", "--table", "dense", "--cell-size", "1"}),
      scene("broad_phase/choose_broad_phase.cpp: --axis", "--axis: found z, allowed auto, x, y",
            "[domain]\ndimensions = 2\n", {"--broadphase", "sort-and-sweep", "--axis", "z"}),
      scene("world/swept.h: --swept", "--swept: a sphere and its way",
            kBox + "boundary = 'periodic'\n" + kSphere + "velocity = [1000, 0, 0]", {"--swept", "on", "--dt", "0.1"}),
      scene("event_driven/event_driven.cpp: where.str()", "sphere 0: it left the domain: ",
            kBox + kSphere + "velocity = [1e15, 0, 0]", {"--response", "event-driven"}),
      scene("world/guard.h: where.str()", "left the domain: ", kBox + kSphere + "velocity = [1e9, 0, 0]",
            {"--dt", "0.1"}),
  };
}

const std::vector<Unreached>& unreached() {
  const std::string driver = "a fault of the graphics driver";
  const std::string itself = "a fault of the program, not of its input";
  const std::string before = "the command line refuses the value before";
  const std::string device = "needs a graphics device";
  const std::string remembered = "show tells it as a note, see below";
  static const std::vector<Unreached> table{
      {"cli/command_line.cpp: what cannot be parsed", "a kind of failure of CLI11 that no option of ours has"},
      {"cli/main.cpp: (command, error.what())", "a failure of the standard library that no input is known for"},
      {"window/remembered.cpp: text_of(range)", remembered},
      {"window/remembered.cpp: \"version\"", remembered},
      {"window/remembered.cpp: something else", remembered},
      {"cuda/backend_cuda.cu: --backend", device},
      {"cuda/cuda_error.h: expression", device},
      {"cuda/gl_interop.cu: another device", device},
      {"window/window.cpp: --size", "needs a display"},
      {"window/window.cpp: with OpenGL 4.5", "needs a display without OpenGL 4.5"},
      {"export/frame_sequence.cpp: cannot look", "the folder was looked at just before"},
      {"export/png.cpp: cannot encode", "an encoder without memory"},
      {"lab/charts/gnuplot.cpp: cannot pass", "the system without memory for files"},
      {"lab/measure/lab.cpp: holds a timing", "a cache that was changed by hand"},
      {"render/body_buffer.cpp: cannot map", driver},
      {"render/gl_debug.cpp: is lost", driver},
      {"render/gl_debug.cpp: OpenGL reports", driver},
      {"render/render_target.cpp: framebuffer status", driver},
      {"render/renderer.cpp: --supersample", before},
      {"render/shader.cpp: no shader", itself},
      {"render/shader.cpp: does not compile", driver},
      {"render/shader.cpp: do not link", driver},
      {"render/shader.cpp: no uniform", itself},
      {"render/sheet.cpp: cannot draw", driver},
      {"render/sheet.cpp: letters", driver},
      {"render/sheet.cpp: is gone", driver},
      {"scene/read_scene.cpp: 0 to {}", before},
      {"scene/spheres_csv.cpp: one sphere too many", "needs a file of 100 million rows"},
      {"methods/choices.h: \"name\"", before},
      {"narrow_phase/contact_rows.h: too many", "needs 2 147 483 648 contacts"},
  };
  return table;
}

std::vector<Row> all_rows() {
  std::vector<Row> rows = rows_of_commands();
  const std::vector<Row> scenes = rows_of_scenes();
  rows.insert(rows.end(), scenes.begin(), scenes.end());
  return rows;
}

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
      "(UserError )?\\b(?:UserError|RunError|input_error)\\(|\\b(?:(?:reader|root)(?:\\.|->)|throw )(?:error|missing)\\(");
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
  for (const char* folder : {"no-gl", "no-egl", "no-shell", "broken"}) fs::create_directory(scratch / folder);
  write_text(scratch / "no-gl/libGL.so.1", "");
  write_text(scratch / "no-egl/libEGL.so.1", "");
  write_program(scratch / "no-shell/gnuplot", "#!/nowhere\n");
  write_program(scratch / "broken/gnuplot", "#!/bin/sh\necho broken >&2\nexit 1\n");
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
  fs::create_directories(scratch / "old/frame_00002.png/x");
}

}  // namespace

TEST_CASE("every message has its form: where, what was found, what is allowed; or where, and what happened") {
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
    CHECK(outcome.out.empty());
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

TEST_CASE("what is remembered wrongly is told in a note, with the place in its file") {
  const Scratch scratch;
  fs::create_directory(scratch / "ballpit");
  const Variable config("XDG_CONFIG_HOME", scratch.path().string()), display("DISPLAY", ""),
      wayland("WAYLAND_DISPLAY", "");
  const std::string file = remembered_file().string();
  Remembered good;
  good.scene = "rain";
  good.size = "1280x720";
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
    if (file == "cli/main.cpp" || file == "show/notes.cpp" || file == "cli/progress.cpp") continue;
    INFO(file);
    CHECK_FALSE(std::regex_search(code_of(file), std::regex("\\b(std::cerr|std::clog|stderr)\\b")));
  }
}
