// SPDX-License-Identifier: MIT
#include "tests/cli/messages_table.h"

namespace ballpit {

Arguments render(const Arguments& more) { return with(kRender, more); }

Row interrupted(const std::string& site, const std::string& said, const Arguments& arguments) {
  Row row{site, said, arguments};
  row.is_interrupted = true;
  return row;
}

namespace {

Row scene(const std::string& site, const std::string& said, const std::string& text, const Arguments& more = {}) {
  return {site, said, with({"simulate", "a.toml", "--time", "1"}, more), text};
}

Row csv(const std::string& site, const std::string& said, const std::string& text) {
  return {site, said, {"pairs", "a.csv"}, text};
}

std::vector<Row> rows_of_commands() {
  const std::vector<std::pair<const char*, std::string>> no_cuda{{"CUDA_VISIBLE_DEVICES", ""}};
  const std::vector<std::pair<const char*, std::string>> no_display{{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
  return {
      {"cli/command_line.cpp: \"command\"", "command: found nothing, allowed show", {}},
      {"cli/command_line.cpp: found, allowed", "list: found extra, allowed options alone", {"list", "extra"}},
      {"cli/command_line.cpp: unknown option", "list: found unknown option --frob", {"list", "--frob"}},
      {"cli/command_line.cpp: \"a value\"", "--json: found a value, allowed none", {"list", "--json=1"}},
      {"cli/command_line.cpp: values", "--dt: found 2 values", {"simulate", "--dt", "1", "--dt", "2"}},
      {"cli/command_line.cpp: (name, \"nothing\", allowed_by",
       "--time: found nothing, allowed SECONDS",
       {"simulate", "--time"}},
      {"cli/command_line.cpp: get_name(), \"nothing\"", "FILE: found nothing, allowed CSV", {"pairs"}},
      {"show/options.h: kKind", "--time: found x, allowed a number from", {"simulate", "--time", "x"}},
      {"show/options.cpp: choices", "--theme: found pink, allowed projector", render({"--theme", "pink"})},
      {"cli/command_line.cpp: a path", "--out: found nothing, allowed a path", {"simulate", "--out", ""}},
      {"show/options.cpp: as well",
       "--trajectory: found x, which is --out",
       {"simulate", "--out", "x", "--trajectory", "x"}},
      {"show/options.cpp: alone, or", "--overlay: found mood, allowed none", render({"--overlay", "mood"})},
      {"show/options.cpp: WIDTHxHEIGHT", "--size: found 8, allowed WIDTH", {"render", "--out", "film", "--size", "8"}},
      {"show/options.cpp: alone, or", "--observe: found pear, allowed all", {"simulate", "--observe", "pear"}},
      {"show/session.cpp: --backend", "--backend: found cuda, which", {"simulate", "--backend", "cuda"}, "", no_cuda},
      {"cli/command_bench.cpp: --backends",
       "--backends: found cuda, which",
       {"bench", "--backends", "cuda"},
       "",
       no_cuda},
      {"cli/command_simulate.cpp: without --observe",
       "--observe-from: found 2 without --observe, allowed together with it",
       {"simulate", "--observe-from", "2"}},
      {"cli/command_simulate.cpp: the end",
       "--observe-from: found 2, allowed less than 1 s, the end",
       {"simulate", "rain", "--time", "1", "--observe", "pressure", "--observe-from", "2"}},
      {"cli/command_simulate.cpp: --every", "--every: found 2 without --trajectory", {"simulate", "--every", "2"}},
      {"cli/command_render.cpp: --ui-scale", "--ui-scale: found without --panel", render({"--ui-scale", "2"})},
      {"cli/command_render.cpp: clicks_ +", "--click: found pause without --panel", render({"--click", "pause"})},
      {"cli/command_render.cpp: the panel shows", "--click: found x, allowed what",
       render({"--panel", "--click", "x"})},
      {"show/film.cpp: --resume",
       "--resume: found frame_00000.png in old with ",
       {"render", "two-spheres", "--size", "64x48", "--frames", "1", "--out", "old", "--resume"}},
      {"show/options.cpp: \"--\"",
       "--precision: found float",
       {"simulate", "--response", "event-driven", "--precision", "float"}},
      {"cli/pair_files.cpp: along", "--period: found 1 along x with radius 1", {"pairs", "b.csv", "--period", "1,1,1"}},
      {"cli/pair_files.cpp: X,Y,Z", "--period: found 1, allowed X,Y,Z", {"pairs", "b.csv", "--period", "1"}},
      {"cli/pair_files.cpp: with the scene",
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
      {"core/program.cpp: cannot start",
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
      {"render/renderer.cpp: --size",
       "--size: found 65536x",
       {"render", "two-spheres", "--size", "16384x16", "--supersample", "4", "--frames", "1", "--out", "film"}},
  };
}

std::vector<Row> rows_of_scenes() {
  const std::string fill = "[[fill]]\ncount = 10\nradius = 1\n";
  return {
      {"scene/read_scene.cpp: SCENE", "SCENE: found \"nosuch\", allowed ", {"simulate", "nosuch"}},
      scene("scene/table_reader.cpp: a syntax error", "a.toml:1: found a syntax error: ", "[domain"),
      scene("scene/table_reader.cpp: an unknown key", "a.toml:1: titel: found an unknown key", "titel = 'x'"),
      scene("scene/table_reader.cpp: line_of(node.source())", "[physics] restitution: found 2, allowed",
            "[physics]\nrestitution = 2"),
      scene("scene/table_reader.cpp: an integer", "[domain] dimensions: found 4, allowed an integer",
            "[domain]\ndimensions = 4"),
      scene("scene/table_reader.cpp: a text in quotes", "title: found 3, allowed a text", "title = 3"),
      scene("scene/table_reader.cpp: (*node), join(names)", "[domain] boundary: found \"x\", allowed walls",
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
      scene("scene/read_sections.cpp: min below max", "[domain] max: found 0 to 0", "[domain]\nmax = [0, 1, 1]"),
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
      scene("scene/read_scene.cpp: reaching from", "found sphere 0 reaching from",
            kBox + "[[spheres]]\nposition = [0, 5, 5]\nradius = 1"),
      scene("scene/read_scene.cpp: overlapping by", "overlapping by 2 m", kBox + kSphere + kSphere),
      scene("scene/read_scene.cpp: an edge of", "[domain] max: found an edge of 10",
            kBox + "boundary = 'periodic'\n[[spheres]]\nposition = [5, 5, 5]\nradius = 3"),
      scene("scene/fill.cpp: \"[[fill]] radius\"", "[[fill]] radius: found 6",
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
      csv("scene/spheres_csv.cpp: an empty file", "a.csv:1: header: found an empty file", ""),
      csv("scene/spheres_csv.cpp: quotes around", "a.csv:2: x: found a quote", "x,y,z,radius\n\"1,2,3,4\n"),
      csv("scene/spheres_csv.cpp: in_quotes(field)", "a.csv:2: x: found \"1,234\"", "x,y,z,radius\n\"1,234\",2,3,4\n"),
      csv("scene/spheres_csv.cpp: in_quotes(f", "a.csv:3: x: found \"1,5\"", "x;y;z;radius\n1.5;2;3;4\n1,5;2;3;4\n"),
      csv("scene/spheres_csv.cpp: in_quotes(field)", "a.csv:2: x: found \"one\", allowed a number",
          "x,y,z,radius\none,2,3,4\n"),
      csv("scene/spheres_csv.cpp: {} field", "a.csv:2: row: found 2 fields", "x,y,z,radius\n1,2\n"),
      csv("scene/line_reader.cpp: kBufferSize", "a.csv:2: line: found more than 1048576 bytes",
          "x,y,z,radius\n" + std::string(1'100'000, '1')),
      scene("scene/input_error.cpp: which makes a mass", "radius: found 1e+12, which makes", "spheres = 'heavy.csv'"),
      scene("show/options.cpp: option.where", "a.toml:2: [defaults] precision: found float",
            "[defaults]\nprecision = 'float'\nresponse = 'event-driven'"),
      scene("methods/settings.cpp: no option of this name", "[defaults] frob: found no option", "[defaults]\nfrob = 1"),
      {"methods/settings.cpp: info->allowed", "--dt: found x, allowed 1e-12 to 10", {"simulate", "--dt", "x"}},
      scene("broad_phase/grid.cpp: --cell-size", "--cell-size: found 1, which needs",
            "[domain]\nmax = [1e6, 1e6, 1e6]\n" + kSphere,
            {"--broadphase", "linked-cell", "--table", "dense", "--cell-size", "1"}),
      scene("broad_phase/parameters.cpp: --axis", "--axis: found z, allowed auto, x, y", "[domain]\ndimensions = 2\n",
            {"--broadphase", "sort-and-sweep", "--axis", "z"}),
      scene("world/swept.h: --swept", "--swept: a sphere and its way",
            kBox + "boundary = 'periodic'\n" + kSphere + "velocity = [1000, 0, 0]", {"--swept", "on", "--dt", "0.1"}),
      scene("event_driven/event_driven.cpp: where, what, more", "sphere 0: it left the domain: ",
            kBox + kSphere + "velocity = [1e15, 0, 0]", {"--response", "event-driven"}),
      scene("world/guard.h: \"step \"", "left the domain: ", kBox + kSphere + "velocity = [1e9, 0, 0]",
            {"--dt", "0.1"}),
  };
}

}  // namespace

const std::vector<Unreached>& unreached() {
  const std::string driver = "a fault of the graphics driver";
  const std::string itself = "a fault of the program, not of its input";
  const std::string before = "the command line refuses the value before";
  const std::string device = "needs a graphics device";
  const std::string remembered = "show prints it as a note, see below";
  const std::string on_page = "the page shows it, and the lecture goes on: tests/show";
  static const std::vector<Unreached> table{
      {"cli/command_line.cpp: what cannot be parsed", "a kind of failure of CLI11 that no option of ours has"},
      {"cli/main.cpp: (command, error.what())", "a failure of the standard library that no input is known for"},
      {"window/remembered.cpp: text_of(range)", remembered},
      {"window/remembered.cpp: \"version\"", remembered},
      {"window/remembered.cpp: something else", remembered},
      {"lecture/record.cpp: interleaving", on_page},
      {"lecture/recorded_run.cpp: kernel", on_page},
      {"show/presenter.cpp: stops", on_page},
      {"cuda/backend_cuda.cu: --backend", device},
      {"cuda/cuda_error.h: expression", device},
      {"cuda/gl_interop.cu: another device", device},
      {"window/window.cpp: --size", "needs a display"},
      {"window/window.cpp: with OpenGL 4.5", "needs a display without OpenGL 4.5"},
      {"export/frame_sequence.cpp: cannot look", "the folder was looked at just before"},
      {"export/png.cpp: cannot encode", "an encoder without memory"},
      {"core/program.cpp: cannot hold the input", "the system without memory for files"},
      {"lab/measure/lab.cpp: holds a timing", "a cache that was changed by hand"},
      {"render/body_buffer.cpp: cannot map", driver},
      {"render/gl_context.cpp: is lost", driver},
      {"render/gl_context.cpp: OpenGL reports", driver},
      {"render/renderer.cpp: framebuffer status", driver},
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
  for (const auto& of : {rows_of_scenes, rows_of_lectures, rows_of_masses, rows_of_choices, rows_of_acts, rows_of_views,
                         rows_of_pictures})
    for (const Row& row : of()) rows.push_back(row);
  return rows;
}

}  // namespace ballpit
