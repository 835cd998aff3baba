// SPDX-License-Identifier: MIT
#include "show/presenter.h"

#include <functional>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "render/overlays/overlay.h"
#include "tests/support/in_german.h"

using namespace ballpit;

namespace {

Presenter at_page(const std::string& id) {
  Presenter presenter(built_in_lecture());
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
  Presenter presenter(built_in_lecture());
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
  for (const bool is_german : {false, true}) {
    std::optional<InGerman> in_german;
    if (is_german) in_german.emplace();
    Presenter presenter(built_in_lecture());
    for (int number = 1; number <= presenter.count(); ++number) {
      presenter.go_to(number);
      INFO(presenter.page().id);
      CHECK(presenter.failure() == "");
      for (size_t stop = 0; stop < presenter.stops().size(); ++stop) {
        presenter.go_to_stop(stop);
        const std::string caption = presenter.caption();
        CHECK(caption.find('{') == std::string::npos);
        if (caption == presenter.page().question.in(language())) continue;
        CHECK(caption.find('?') == std::string::npos);
        CHECK(caption.find_first_of("0123456789") != std::string::npos);
      }
    }
  }
}

namespace {

/// What the captions of the last stops say, on slides and beyond.
const std::map<std::string, std::string>& expected_figures() {
  static const std::map<std::string, std::string> figures{
      {"poster", "2\u2009000 balls: 11\u2009072 tests in place of 1\u2009999\u2009000"},
      {"unlit", "1\u2009000 spheres in one light"},
      {"lit", "each of 1\u2009000 spheres"},
      {"project", "3 spheres cast 6 marks"},
      {"store", "6 entries"},
      {"sort", "Here 3 stores"},
      {"walk", "1 test in place of 3"},
      {"ends", "Of 6 threads only 3 walk"},
      {"sweep-crowd", "34 tests in place of 190"},
      {"all-pairs", "20 spheres need 190 tests to find 4 contacts"},
      {"grid", "49 of 190 pairs"},
      {"too-large", "190 of 190 tests"},
      {"too-small", "miss 4 of 4 contacts"},
      {"bound", "miss 0 of 4 contacts"},
      {"into-cells", "20 spheres are put into 25 cells"},
      {"hash", "= 6, one of 25 cells"},
      {"insert-all", "85 operations for 20 spheres and 25 cells"},
      {"block", "make 49 tests and find 4 contacts"},
      {"chains", "9 spheres, 9 lists"},
      {"two-arrays", "9 entries in head, 9 in next"},
      {"clear", "9 threads store −1"},
      {"first-insert", "head[4] = 6, next[6] = −1"},
      {"second-insert", "head[4] = 2, next[2] = 6"},
      {"race", "1 particle is lost"},
      {"race-on-threads", "of 1\u2009000\u2009000 particles are lost"},
      {"exchange", "0 particles are lost"},
      {"sorted-grid", "25 cells is a range of one sorted array, with the same 49 candidates"},
      {"warps-sweep", "47.8 % of the lanes"},
      {"warps-shuffled", "61.2 % of the lanes"},
      {"warps-sorted", "71.4 % of the lanes"},
      {"int-for-floor", "2 of 3 contacts are missed"},
      {"no-wrap", "3 contacts are missed"},
      {"with-wrap", "0 contacts are missed and 4 found"},
      {"both-halves", "98 tests and 8 contacts"},
      {"far-from-origin", "1 of 4 contacts is missed, and 1 pair that is apart is found"},
      {"stale-lists", "miss the contact: 1 of 1"},
      {"bullet", "flies 4.17 diameters"},
      {"swept", "0.021 s"},
      {"unstable", "% of its energy after 0.500 s"},
      {"stable", "% after 0.500 s, and comes to rest"},
      {"fast", "60 searches for contacts per second: spheres overlap by up to 32.8 % of a radius"},
      {"accurate", "480 searches per second cost eight times as much and leave 1.57 %"},
  };
  return figures;
}

/// The number before " %".
double percent_in(const std::string& caption) {
  const size_t end = caption.find(" %"), begin = caption.rfind(' ', end - 1);
  return std::stod(caption.substr(begin + 1, end - begin - 1));
}

/// The built-in lecture with another kernel or mistake on one page.
Lecture with_page(const std::string& id, const std::function<void(Page&)>& change) {
  Lecture lecture;
  for (const Page& page : built_in_lecture().pages) {
    if (page.id == id) lecture.pages.push_back(page);
  }
  change(lecture.pages.at(0));
  return lecture;
}

bool has_expected_figures(const Lecture& lecture) {
  Presenter presenter(lecture);
  presenter.go_to_stop(presenter.stops().size() - 1);
  return presenter.caption().find(expected_figures().at(presenter.page().id)) != std::string::npos;
}

}  // namespace

TEST_CASE("each page has the figures of its slide, or of what goes beyond") {
  for (const Page& page : built_in_lecture().pages) {
    INFO(page.id);
    REQUIRE(expected_figures().contains(page.id));
    CHECK_THAT(captions_at_stops(page.id).back(), Catch::Contains(expected_figures().at(page.id)));
  }
}

TEST_CASE("a kernel that is broken on purpose changes the figures of its pages") {
  struct Row {
    const char* id;
    PageMistake mistake;
  };
  for (const Row& row : {Row{"block", PageMistake::both_halves}, Row{"block", PageMistake::stale_lists},
                         Row{"block", PageMistake::far_from_origin}, Row{"with-wrap", PageMistake::no_wrap},
                         Row{"int-for-floor", PageMistake::none}}) {
    INFO(row.id << ", " << name_of(row.mistake));
    CHECK(has_expected_figures(with_page(row.id, [](Page&) {})));
    const bool moves = row.mistake == PageMistake::stale_lists;
    CHECK_FALSE(has_expected_figures(with_page(row.id, [&](Page& page) {
      page.mistake = row.mistake;
      if (moves) page.time = 2.4;
    })));
  }
  const auto race = [](Page& page) {
    page.kernel = lecture::KernelName::race;
    page.interleaving = {6, 6, 6, 2, 2, 2, 3, 5, 5, 3, 3, 5};
  };
  CHECK_FALSE(has_expected_figures(with_page("exchange", race)));
}

TEST_CASE("too long a step adds energy to springs that should lose it, half the step does not") {
  CHECK(percent_in(captions_at_stops("unstable").back()) > 150);
  CHECK(percent_in(captions_at_stops("stable").back()) < 60);
}

TEST_CASE("a question stands in the caption's place until the last stop, in both languages") {
  Presenter page = at_page("race");
  CHECK(page.caption() == page.page().question.en);
  page.go_to_stop(page.stops().size() - 1);
  CHECK_THAT(page.caption(), Catch::Contains("1 particle is lost"));
  page.step(-1);
  const InGerman in_german;
  CHECK(page.caption() == page.page().question.de);
}

TEST_CASE("a page with several stops asks before it answers") {
  for (const Page& page : built_in_lecture().pages) {
    CAPTURE(page.id);
    CHECK(page.question.en.empty() == page.question.de.empty());
    if (page.stops.size() > 1) CHECK_FALSE(page.question.en.empty());
  }
}

TEST_CASE("German figures have decimal commas, and thin spaces between thousands") {
  const InGerman in_german;
  CHECK_THAT(at_page("warps-sweep").caption(), Catch::Contains(" 47,8 % "));
  CHECK_THAT(at_page("poster").caption(), Catch::Contains("11\u2009072 Tests statt 1\u2009999\u2009000"));
  CHECK_THAT(at_page("swept").caption(), Catch::Contains("0,021 s"));
  Presenter hash = at_page("hash");
  hash.go_to_stop(1);
  CHECK(hash.frame_view(1.5f).page->step == "Thread 0: Zelle ⌊1,50⌋·5 + ⌊1,50⌋ = 6");
}

TEST_CASE("int() for floor is in the formula of its page") {
  Presenter page = at_page("int-for-floor");
  page.go_to_stop(1);
  CHECK(page.frame_view(1.5f).page->step == "thread 0: cell (int(0.400) + 2)·4 + (int(−1.80) + 2) = 9");
}

TEST_CASE("a page on real threads shows a stored run, or one that it measures in a window") {
  Presenter presenter = at_page("race-on-threads");
  const std::string stored = presenter.caption();
  CHECK_THAT(stored, Catch::Contains("On 2 real threads (AMD EPYC), "));
  CHECK(presenter.caption() == stored);
  presenter.measures = true;
  const std::string measured = presenter.caption();
  CHECK(measured.find('?') == std::string::npos);
  CHECK_THAT(measured, Catch::Contains("of 1\u2009000\u2009000 particles are lost"));
}

TEST_CASE("on slide 13 all cells become −1, on 14 and 15 particles 6 and 2 enter cell 4") {
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

TEST_CASE("the race on slide 16 loses sphere 5 and its contact with 3, every time, with the exchange neither") {
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

TEST_CASE("a page whose scene is missing says why, and the other pages still work") {
  const Lecture lecture = parse_lecture(
      "[[page]]\nid = 'a'\nscene = 'nowhere.toml'\n[[page]]\nid = 'b'\nscene = 'lecture-grid'\ncaption = '{spheres}'\n",
      "mine.toml");
  Presenter presenter(lecture);
  CHECK_THAT(presenter.failure(), Catch::Contains("nowhere.toml"));
  CHECK_THAT(presenter.caption(), Catch::Contains("nowhere.toml"));
  CHECK(presenter.frame_view(1.5f).page->has_no_scene);
  presenter.next();
  CHECK(presenter.failure().empty());
  CHECK(presenter.caption() == "20");
}

TEST_CASE("a page that takes long to compute is shown before it is ready, and looks the same in the end") {
  const Lecture lecture = parse_lecture(R"(title = "x"
[[page]]
id = "first"
title = "First"
caption = "{spheres}"
scene = "two-spheres"
[[page]]
id = "long"
title = "Long"
caption = "{time} s"
scene = "bouncing-balls"
time = 0.5
)",
                                        "long.toml");
  Presenter presenter(lecture);
  presenter.patience = 0.001;
  presenter.go_to(2);
  REQUIRE_FALSE(presenter.is_ready());
  CHECK(presenter.caption().empty());
  CHECK(presenter.frame_view(1.5f).page->title == "Long");
  while (!presenter.is_ready()) presenter.prepare();
  CHECK(presenter.caption() == "0.500 s");
  Presenter patient(lecture);
  patient.go_to(2);
  REQUIRE(patient.is_ready());
  CHECK(patient.demo().report().state_hash == presenter.demo().report().state_hash);
}
