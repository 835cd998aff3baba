// SPDX-License-Identifier: MIT
#include "window/lecture_window.h"

#include <set>

#include <catch2/catch.hpp>

#include "core/file.h"
#include "window/show_window.h"

using namespace ballpit;
using Catch::Contains;

TEST_CASE("the documentation names every key of the presenter, and every figure of captions") {
  const std::string text = read_file(BALLPIT_SOURCE_DIR "/docs/lecture.md");
  for (const PresenterKey& key : presenter_keys()) {
    const std::string name(key.name.substr(key.name.find(' ') + 1));  // "Enter" of "digits, Enter"
    CHECK_THAT(text, Contains("`" + name + "`"));
  }
  for (const Placeholder& figure : placeholder_table())
    CHECK_THAT(text, Contains("`{" + std::string(figure.name) + "}`"));
}

TEST_CASE("a key of the presenter has one action") {
  std::set<int> codes;
  for (const PresenterKey& key : presenter_keys()) CHECK(codes.insert(key.code).second);
}

TEST_CASE("the README names the keys of the window, and none does what a key of the demonstration does") {
  const std::string text = read_file(BALLPIT_SOURCE_DIR "/README.md");
  std::set<int> codes;
  for (const Key& key : key_table()) codes.insert(key.code);
  for (const WindowKey& key : window_keys()) {
    CHECK_THAT(text, Contains("`" + std::string(key.name) + "`"));
    CHECK(codes.insert(key.code).second);
  }
}
