// SPDX-License-Identifier: MIT
#include "show/lecture.h"

#include <set>

#include <catch2/catch.hpp>

#include "core/error.h"

using namespace ballpit;

namespace {

constexpr const char* kPage = "[[page]]\nid = 'a'\nscene = 'lecture-grid'\n";

Lecture parse(const std::string& text) { return parse_lecture(text, "mine.toml", "folder"); }

}  // namespace

TEST_CASE("a page of a lecture holds what its file says") {
  const Lecture lecture = parse(R"(title = "T"
title_de = "D"
[[page]]
id = "cells"
slides = [8, 9]
title = "Cells"
caption = "{spheres} spheres"
caption_de = "{spheres} Kugeln"
notes = "N"
scene = "lecture-cells"
time = 0.5
options = { broadphase = "linked-cell", cell-size = 2 }
overlays = ["grid", "lists"]
color = "cell"
select = 3
camera = [90, 45, 2]
kernel = "linked-cell"
interleaving = [6, 6, 2, 2]
mistake = "no-wrap"
stored = { lost_by_threads = 1234, machine = "an abacus" }
stops = ["start", "clear", "insert 6"]
)");
  CHECK(lecture.title.in(Language::german) == "D");
  REQUIRE(lecture.pages.size() == 1);
  const Page& page = lecture.pages[0];
  CHECK(page.id == "cells");
  CHECK(page.slides == std::vector<int>{8, 9});
  CHECK(page.title.in(Language::german) == "Cells");  // without a German text, the English one
  CHECK(page.caption.in(Language::german) == "{spheres} Kugeln");
  CHECK(page.notes.en == "N");
  CHECK(page.scene == "lecture-cells");
  CHECK(page.time == 0.5);
  REQUIRE(page.options.size() == 2);
  CHECK(page.view.overlays == std::vector<std::string>{"grid", "lists"});
  CHECK(page.view.coloring == "cell");
  CHECK(page.view.selected == 3);
  CHECK(page.view.azimuth == Approx(3.14159265 / 2));
  CHECK(page.view.zoom == 2);
  CHECK(page.kernel == lecture::KernelName::linked_cell);
  CHECK(page.interleaving == std::vector<int>{6, 6, 2, 2});
  CHECK(page.mistake == PageMistake::no_wrap);
  CHECK(page.stored.at("lost_by_threads") == "1\u2009234");
  CHECK(page.stored.at("machine") == "an abacus");
  REQUIRE(page.stops.size() == 3);
  CHECK(page.stops[2].phase == "insert");
  CHECK(page.stops[2].thread == 6);
}

TEST_CASE("a mistake in a lecture is reported with file, line, key, what was found and what is allowed") {
  struct Row {
    std::string text, message;
  };
  const std::string page = kPage;
  const Row row = GENERATE_COPY(values<Row>({
      {"title = 'T'\n", "mine.toml:1: page: found nothing, allowed tables [[page]]"},
      {"[[page]]\nscene = 'rain'\n", "mine.toml:1: [[page]] id: found nothing, allowed a name for the page"},
      {"[[page]]\nid = 'a'\n", "[[page]] scene: found nothing, allowed the name of a scene"},
      {page + page, "mine.toml:5: [[page]] id: found \"a\" a second time"},
      {page + "slide = 3\n", "mine.toml:4: [[page]] slide: found an unknown key, allowed id, slides"},
      {page + "slides = [1.5]\n", "mine.toml:4: [[page]] slides: found 1.5, allowed integers, 0 to 999"},
      {page + "caption = 'so {many} spheres'\n", "mine.toml:4: [[page]] caption: found {many}, allowed spheres, pairs"},
      {page + "caption_de = 'so {viele'\n", "mine.toml:4: [[page]] caption_de: found {viele, allowed spheres"},
      {page + "time = -1\n", "mine.toml:4: [[page]] time: found -1, allowed 0 to"},
      {page + "options = { cell-size = -1 }\n", "mine.toml:4: [options] cell-size: found -1, allowed "},
      {page + "options = { size = 9 }\n", "mine.toml:4: [options] size: found no option of this name"},
      {page + "overlays = ['grids']\n", "mine.toml:4: [[page]] overlays: found \"grids\", allowed grid, pairs"},
      {page + "overlays = 'grid'\n", "mine.toml:4: [[page]] overlays: found \"grid\", allowed an array of texts"},
      {page + "color = 'red'\n", "mine.toml:4: [[page]] color: found \"red\", allowed contact"},
      {page + "occlusion = 'no'\n", "mine.toml:4: [[page]] occlusion: found \"no\", allowed on, off"},
      {page + "select = -1\n", "mine.toml:4: [[page]] select: found -1"},
      {page + "camera = [0, 100, 1]\n", "mine.toml:4: [[page]] camera: found 100° of elevation"},
      {page + "camera = [0, 10, 0]\n", "mine.toml:4: [[page]] camera: found 0 of zoom, allowed 0.25 to 50"},
      {page + "kernel = 'grid'\n", "mine.toml:4: [[page]] kernel: found \"grid\", allowed brute-force, sort-and-sweep"},
      {page + "stops = ['clear']\n", "mine.toml:4: [[page]] stops: found no kernel, allowed only with a kernel"},
      {page + "kernel = 'race'\nstops = ['sort']\n",
       "mine.toml:5: [[page]] stops: found \"sort\", allowed start, or a phase"},
      {page + "kernel = 'race'\nstops = ['insert x']\n", "mine.toml:5: [[page]] stops: found \"insert x\""},
      {page + "kernel = 'race'\ninterleaving = [500]\n",
       "mine.toml:5: [[page]] interleaving: found 500, allowed integers, 0 to 499"},
      {page + "kernel = 'race'\nmistake = 'none at all'\n",
       "mine.toml:5: [[page]] mistake: found \"none at all\", allowed none, int-for-floor"},
      {page + "stored = 3\n", "mine.toml:4: [[page]] stored: found 3, allowed figures by their names"},
      {page + "stored = { many = 3 }\n", "mine.toml:4: [[page]] stored: found \"many\", allowed spheres, pairs"},
      {page + "stored = { lost = [] }\n",
       "mine.toml:4: [[page]] stored: found an array of 0 values, allowed whole numbers or texts"},
      {page + "title = \n", "mine.toml:4: found a syntax error"},
  }));
  INFO(row.text);
  std::string message;
  try {
    parse(row.text);
  } catch (const UserError& error) {
    message = error.what();
  }
  CHECK_THAT(message, Catch::Contains(row.message));
}

TEST_CASE("a scene in a file lies beside the lecture") {
  CHECK(parse("[[page]]\nid = 'a'\nscene = 'mine.toml'\n").pages[0].scene == "folder/mine.toml");
}

TEST_CASE("the built-in lecture covers slides 2 to 17 in their order, in both languages") {
  CHECK(built_in_lecture().pages.size() >= 32);
  CHECK(built_in_lecture().pages.size() <= 44);
  std::set<int> slides;
  int latest = 0;
  for (const Page& page : built_in_lecture().pages) {
    INFO(page.id);
    slides.insert(page.slides.begin(), page.slides.end());
    if (!page.slides.empty()) {
      CHECK(page.slides.back() >= latest);
      latest = page.slides.back();
    }
    for (const LocalText& text : {page.title, page.caption, page.notes}) {
      CHECK_FALSE(text.en.empty());
      CHECK_FALSE(text.de.empty());
    }
  }
  for (int slide = 2; slide <= 17; ++slide) CHECK(slides.contains(slide));
}
