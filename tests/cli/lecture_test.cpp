// SPDX-License-Identifier: MIT
// ballpit lecture without a window: the list of pages and the handout.
#include <fstream>
#include <set>

#include <catch2/catch.hpp>

#include "core/file.h"
#include "export/png.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;

TEST_CASE("lecture --json lists the pages, in the language that is asked for") {
  const Outcome english = run_program({"lecture", "--json"}),
                german = run_program({"lecture", "--json", "--lang", "de"});
  REQUIRE(english.status == 0);
  const auto pages = nlohmann::json::parse(english.out)["pages"], seiten = nlohmann::json::parse(german.out)["pages"];
  REQUIRE(pages.size() >= 28);
  REQUIRE(pages.size() == seiten.size());
  std::set<std::string> ids;
  int number = 0;
  for (const auto& page : pages) {
    CHECK(page["number"] == ++number);
    CHECK(ids.insert(page["id"]).second);
    CHECK(page["steps"] >= 1);
    CHECK(page["slides"].is_array());
    CHECK(page["title"] != seiten[size_t(number) - 1]["title"]);
    CHECK(page["caption"] != seiten[size_t(number) - 1]["caption"]);
  }
}

TEST_CASE("lecture --export writes a picture of each page and a page that holds all, the same each time") {
  const Scratch scratch;
  write_file(scratch / "mine.toml",
             "title = 'Mine & yours'\n[[page]]\nid = 'one'\ntitle = 'One'\ncaption = '{spheres} spheres'\n"
             "scene = 'lecture-sweep'\n[[page]]\nid = 'two'\ntitle = 'Two'\ncaption = '{lost} lost'\n"
             "scene = 'lecture-cells'\nkernel = 'race'\nstops = ['clear', 'insert']\n");
  for (const char* folder : {"a", "b"}) {
    const Outcome outcome =
        run_program({"lecture", scratch / "mine.toml", "--export", scratch / folder, "--size", "640x360"});
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
  }
  for (const char* name : {"page_01.png", "page_02.png", "index.html"}) {
    CHECK(read_file(scratch / (std::string("a/") + name)) == read_file(scratch / (std::string("b/") + name)));
  }
  CHECK(read_png_head(scratch / "a/page_02.png")->width == 640);
  const std::string page = read_file(scratch / "a/index.html");
  CHECK_THAT(page, Contains("<title>Mine &amp; yours</title>"));
  CHECK_THAT(page, Contains("3 spheres"));
  CHECK_THAT(page, Contains("<section id=\"two-2\">"));  // a section for each stop
}

TEST_CASE("a lecture that cannot be given is refused in one line") {
  const Scratch scratch;
  write_file(scratch / "mine.toml", "[[page]]\nid = 'a'\nscene = 'lecture-grid'\ncolor = 'red'\n");
  const Outcome wrong = run_program({"lecture", scratch / "mine.toml", "--json"});
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Contains("mine.toml:4: [[page]] color: found \"red\", allowed contact"));
  const Outcome missing = run_program({"lecture", scratch / "none.toml", "--json"});
  CHECK(missing.status == 2);
  CHECK_THAT(missing.err, Contains("none.toml"));
  CHECK(run_program({"lecture", "--page", "99", "--json"}).status == 2);
  CHECK_THAT(run_program({"lecture", "--lang", "fr", "--json"}).err, Contains("--lang: found fr, allowed en, de"));
  CHECK(run_program({"lecture", "--export", "/dev/null/x"}).status != 0);
}
