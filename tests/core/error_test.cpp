// SPDX-License-Identifier: MIT
#include "core/error.h"

#include <catch2/catch.hpp>

using namespace ballpit;

TEST_CASE("a UserError names the place, what was found, what is allowed, and a hint") {
  CHECK(std::string(UserError("--dt", "x", "1 to 2").what()) == "--dt: found x, allowed 1 to 2");
  CHECK(std::string(UserError("--dt", "", "1 to 2").what()) == "--dt: found nothing, allowed 1 to 2");
  CHECK(std::string(UserError("--dt", " ", "1 to 2").what()) == "--dt: found \" \", allowed 1 to 2");
  CHECK(std::string(UserError("--dt", "x", "1 to 2", "see --help").what()) ==
        "--dt: found x, allowed 1 to 2; see --help");
  CHECK(std::string(UserError("dt", "x", "1 to 2", "see --help").inside("a.json").what()) ==
        "a.json: dt: found x, allowed 1 to 2; see --help");
}

TEST_CASE("a RunError names the place, what happened, and a remedy or what was saved") {
  CHECK(std::string(RunError("x.csv", "cannot write").what()) == "x.csv: cannot write");
  const RunError failure("step 3", "a sphere left", "a smaller --dt may help");
  CHECK(std::string(failure.what()) == "step 3: a sphere left; a smaller --dt may help");
  CHECK(std::string(failure.with("the rest is in x.csv").with("").what()) ==
        "step 3: a sphere left; a smaller --dt may help; the rest is in x.csv");
  CHECK(std::string(RunError("x.csv", "cannot write").with("more").what()) == "x.csv: cannot write; more");
  CHECK(std::string(failure.inside("gas").what()) == "gas: step 3: a sphere left; a smaller --dt may help");
  CHECK(std::string(failure.inside("step 3").what()) == failure.what());
}
