// SPDX-License-Identifier: MIT
#include "show/presenter.h"

#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "render/overlays/overlay.h"

using namespace ballpit;

namespace {

Presenter at_page(const std::string& id, Language language = Language::english) {
  Presenter presenter(built_in_lecture(), language);
  for (int number = 1; number <= presenter.count(); ++number) {
    presenter.go_to(number);
    if (presenter.page().id == id) return presenter;
  }
  FAIL("no page " << id);
  return presenter;
}

std::vector<std::string> captions_at_stops(const std::string& id) {
  Presenter presenter = at_page(id);
  std::vector<std::string> captions;
  for (size_t stop = 0; stop < presenter.stops().size(); ++stop) {
    presenter.go_to_stop(stop);
    captions.push_back(presenter.caption());
  }
  return captions;
}

}  // namespace

TEST_CASE("one key leads from the start through all stops of all pages, and another one back") {
  Presenter presenter(built_in_lecture(), Language::english);
  std::vector<std::pair<int, size_t>> way{{presenter.number(), presenter.cursor()}};
  std::set<int> slides;
  for (int press = 0; press < 1000; ++press) {
    CHECK(presenter.failure().empty());
    slides.insert(presenter.page().slides.begin(), presenter.page().slides.end());
    presenter.next();
    if (way.back() == std::pair{presenter.number(), presenter.cursor()}) break;
    way.emplace_back(presenter.number(), presenter.cursor());
  }
  CHECK(presenter.number() == presenter.count());
  for (int slide = 2; slide <= 17; ++slide) CHECK(slides.contains(slide));
  for (int press = 0; press < 1000 && presenter.number() > 1; ++press) presenter.previous();
  CHECK(presenter.number() == 1);
}

TEST_CASE("every page opens, and its caption has all its figures, in both languages") {
  for (const Language language : {Language::english, Language::german}) {
    Presenter presenter(built_in_lecture(), language);
    for (int number = 1; number <= presenter.count(); ++number) {
      presenter.go_to(number);
      INFO(presenter.page().id);
      CHECK(presenter.failure() == "");
      for (size_t stop = 0; stop < presenter.stops().size(); ++stop) {
        presenter.go_to_stop(stop);
        const std::string caption = presenter.caption();
        CHECK(caption.find('?') == std::string::npos);
        CHECK(caption.find('{') == std::string::npos);
        CHECK(caption.find_first_of("0123456789") != std::string::npos);
      }
    }
  }
}

TEST_CASE("the pages' figures are those of the slides") {
  const std::map<std::string, std::string> last{
      {"project", "3 spheres cast 6 marks"},
      {"sort", "Here 3 stores"},
      {"walk", "1 test in place of 3"},
      {"ends", "Of 6 threads only 3 walk"},
      {"all-pairs", "20 spheres need 190 tests to find 4 contacts"},
      {"grid", "49 of 190 pairs"},
      {"too-small", "miss 4 of 4 contacts"},
      {"bound", "miss 0 of 4 contacts"},
      {"into-cells", "20 spheres are put into 25 cells"},
      {"hash", "= 6, one of 25 cells"},
      {"block", "make 49 tests and find 4 contacts"},
      {"clear", "9 threads store −1"},
      {"race", "1 particle is lost"},
      {"exchange", "0 particles are lost"},
  };
  for (const auto& [id, text] : last) {
    INFO(id);
    CHECK_THAT(captions_at_stops(id).back(), Catch::Contains(text));
  }
}

TEST_CASE("on slide 13 all cells become −1; on 14 and 15 particles 6 and 2 enter cell 4") {
  Presenter clear = at_page("clear");
  CHECK(clear.frame_view(16.0f / 9).inspection.grids.at(0).head == std::vector<int32_t>(9, -1));
  Presenter first = at_page("first-insert");
  first.next();
  const GridInspection& one = first.frame_view(16.0f / 9).inspection.grids.at(0);
  CHECK(one.head[4] == 6);
  CHECK(one.next[6] == -1);
  Presenter second = at_page("second-insert");
  second.next();
  const FrameView view = second.frame_view(16.0f / 9);
  const GridInspection& two = view.inspection.grids.at(0);
  CHECK(two.head[4] == 2);
  CHECK(two.next[2] == 6);
  REQUIRE(view.page != nullptr);
  CHECK(view.page->step == "thread 2 stores next[2] = 6");
  CHECK(view.page->code.at(size_t(view.page->line)).find("memory.store(&next[i], old)") != std::string::npos);
  second.step(-1);
  const FrameView before = second.frame_view(16.0f / 9);
  CHECK(before.page->step == "thread 2: atomicExch(&head[4], 2) returns 6");
  CHECK(before.page->touched_array == "head");
  CHECK(before.page->old_text == "6");
}

TEST_CASE("the race on slide 16 loses sphere 5 and its contact with 3, every time; with the exchange neither") {
  for (int repeat = 0; repeat < 3; ++repeat) {
    Presenter race = at_page("race");
    race.go_to_stop(race.stops().size() - 1);
    CHECK(race.frame_view(1.5f).inspection.missed == std::vector<Pair>{{3, 5}});
    Presenter exchange = at_page("exchange");
    exchange.go_to_stop(exchange.stops().size() - 1);
    const Inspection& seen = exchange.frame_view(1.5f).inspection;
    CHECK(seen.missed.empty());
    CHECK(seen.contacts == std::vector<Pair>{{3, 5}});
  }
}

TEST_CASE("a page is in the state of its file, whatever was changed before") {
  Presenter presenter = at_page("grid");
  const std::string caption = presenter.caption();
  presenter.demo().set("broadphase", "brute-force");
  presenter.demo().view.toggle("grid");
  presenter.demo().step();
  CHECK(presenter.caption() != caption);
  presenter.next();
  presenter.previous();
  CHECK(presenter.caption() == caption);
  CHECK(presenter.demo().view.shows("grid"));
}

TEST_CASE("the cursor stays within the record, however far it is moved") {
  Presenter presenter = at_page("race");
  presenter.step(-100000);
  CHECK(presenter.cursor() == 0);
  presenter.frame_view(1);
  presenter.step(1000000);
  CHECK(presenter.cursor() == presenter.run()->record.operations.size());
  presenter.skip_phase(1);
  presenter.skip_phase(-1);
  CHECK(presenter.cursor() == presenter.run()->phases[1].last);
  presenter.skip_phase(-1);
  presenter.skip_phase(-1);
  CHECK(presenter.cursor() == 0);
}

TEST_CASE("thousands of random keys neither crash nor leave the lecture") {
  Presenter presenter(built_in_lecture(), Language::english);
  Random random(5);
  for (int press = 0; press < 3000; ++press) {
    switch (static_cast<int>(random.uniform(0, 8))) {
      case 0:
        presenter.next();
        break;
      case 1:
        presenter.previous();
        break;
      case 2:
        presenter.step(static_cast<int>(random.uniform(-20, 20)));
        break;
      case 3:
        presenter.skip_phase(random.uniform() < 0.5 ? 1 : -1);
        break;
      case 4:
        presenter.go_to(static_cast<int>(random.uniform(-3, 60)));
        break;
      case 5:
        presenter.language = random.uniform() < 0.5 ? Language::german : Language::english;
        break;
      case 6:
        presenter.demo().view.toggle(overlay_table()[static_cast<size_t>(random.uniform(0, 6.99))].name);
        break;
      default:
        presenter.frame_view(1.6f);
    }
    REQUIRE(presenter.number() >= 1);
    REQUIRE(presenter.number() <= presenter.count());
  }
}

TEST_CASE("a page whose scene is missing says why, and the other pages still work") {
  const Lecture lecture = parse_lecture(
      "[[page]]\nid = 'a'\nscene = 'nowhere.toml'\n[[page]]\nid = 'b'\nscene = 'lecture-grid'\ncaption = '{spheres}'\n",
      "mine.toml");
  Presenter presenter(lecture, Language::english);
  CHECK_THAT(presenter.failure(), Catch::Contains("nowhere.toml"));
  CHECK_THAT(presenter.caption(), Catch::Contains("nowhere.toml"));
  CHECK(presenter.frame_view(1.5f).page->has_no_scene);
  presenter.next();
  CHECK(presenter.failure().empty());
  CHECK(presenter.caption() == "20");
}
