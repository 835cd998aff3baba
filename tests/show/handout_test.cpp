// SPDX-License-Identifier: MIT
#include "show/handout.h"

#include <catch2/catch.hpp>

#include "tests/support/in_german.h"

using namespace ballpit;
using Catch::Contains;

TEST_CASE("base64 has the test vectors of RFC 4648") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string_view("\xff\xfe\x00", 3)) == "//4A");
}

TEST_CASE("a handout holds pictures, captions as alternative texts, and notes, and loads nothing") {
  const InGerman in_german;
  const std::string page = handout_page("A & B", {{"a-1", "T", "1 < 2", "N", "foo"}, {"b", "U", "C", "", "foo"}});
  CHECK_THAT(page, Contains("<html lang=\"de\">"));
  CHECK_THAT(page, Contains("<title>A &amp; B</title>"));
  CHECK_THAT(page, Contains("<section id=\"a-1\">"));
  CHECK_THAT(page, Contains("<img alt=\"1 &lt; 2\" src=\"data:image/png;base64,Zm9v\">"));
  CHECK_THAT(page, Contains("<details><summary>Notizen</summary><p>N</p></details>"));
  CHECK_THAT(page, !Contains("http"));
  CHECK(page.find("<details", page.find("id=\"b\"")) == std::string::npos);
}
