// SPDX-License-Identifier: MIT
#include "tests/cli/messages_table.h"

namespace ballpit {

namespace {

/// A page with more keys.
Row page(const std::string& site, const std::string& said, const std::string& keys) {
  return {site, said, {"lecture", "a.toml", "--json"}, "[[page]]\nid = 'a'\nscene = 'lecture-grid'\n" + keys};
}

}  // namespace

std::vector<Row> rows_of_lectures() {
  const auto whole = [](const std::string& site, const std::string& said, const std::string& text) {
    return Row{site, said, {"lecture", "a.toml", "--json"}, text};
  };
  return {
      {"cli/command_lecture.cpp: --page", "--page: found 999, allowed 1 to ", {"lecture", "--page", "999", "--json"}},
      {"cli/options.cpp: --lang", "--lang: found fr, allowed en, de", {"lecture", "--lang", "fr", "--json"}},
      interrupted("cli/command_lecture.cpp: interrupted", "lecture: interrupted after ",
                  {"lecture", "--export", "handout", "--size", "3840x2160"}),
      whole("show/lecture.cpp: tables [[page]]", "page: found nothing, allowed tables", "title = 'x'"),
      whole("show/lecture.cpp: a name for the page", "[[page]] id: found nothing", "[[page]]\nscene = 'rain'"),
      whole("show/lecture.cpp: the name of a scene", "[[page]] scene: found nothing", "[[page]]\nid = 'a'"),
      page("show/lecture.cpp: a second time", "[[page]] id: found \"a\" a second time",
           "[[page]]\nid = 'a'\nscene = 'rain'"),
      page("show/lecture.cpp: unknown, join", "[[page]] caption: found {x}, allowed spheres", "caption = \"{x}\""),
      page("show/lecture.cpp: (key, describe(element), allowed", "[[page]] slides: found \"x\", allowed integers",
           "slides = [\"x\"]"),
      page("show/lecture.cpp: an array of texts", "[[page]] overlays: found \"grid\", allowed an array of texts",
           "overlays = \"grid\""),
      page("show/lecture.cpp: texts in quotes", "[[page]] overlays: found 1, allowed texts", "overlays = [1]"),
      page("show/lecture.cpp: (\"overlays\"", "[[page]] overlays: found \"x\", allowed grid", "overlays = [\"x\"]"),
      page("show/lecture.cpp: of elevation", "[[page]] camera: found 99° of elevation", "camera = [0, 99, 1]"),
      page("show/lecture.cpp: of zoom", "[[page]] camera: found 0 of zoom", "camera = [0, 0, 0]"),
      page("show/lecture.cpp: \"stops\"", "[[page]] stops: found \"x\", allowed start",
           "kernel = \"race\"\nstops = [\"x\"]"),
      page("show/lecture.cpp: no kernel", "[[page]] stops: found no kernel", "stops = [\"clear\"]"),
      page("show/lecture.cpp: figures by their names", "[[page]] stored: found 1, allowed figures by their names",
           "stored = 1"),
      page("show/lecture.cpp: (\"stored\", in_quotes(name)", "[[page]] stored: found \"x\", allowed spheres",
           "stored = { x = 1 }"),
      page("show/lecture.cpp: whole numbers or texts", "[[page]] stored: found 1.5, allowed whole numbers or texts",
           "stored = { spheres = 1.5 }"),
      page("show/lecture.cpp: (\"occlusion\"", "[[page]] occlusion: found \"x\", allowed on, off", "occlusion = \"x\""),
      page("show/lecture.cpp: (\"color\"", "[[page]] color: found \"x\", allowed contact", "color = \"x\""),
  };
}

}  // namespace ballpit
