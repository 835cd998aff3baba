// SPDX-License-Identifier: MIT
// The messages about files of acts: their keys are in tests/scene/acts_test.cpp.
#include "tests/cli/messages_table.h"

namespace ballpit {

namespace {

/// An act on the ten metres of a box with a sphere in its middle.
std::string act(const std::string& more) { return "[[act]]\ntime = 0\n" + more + "\n"; }

const Arguments kSimulate{"simulate", "two-spheres", "--time", "0", "--acts", "a.toml"};

Row row(const std::string& site, const std::string& said, const std::string& text) {
  return {site, said, kSimulate, text};
}

}  // namespace

std::vector<Row> rows_of_acts() {
  const std::string fine = "act = \"throw\"\nsphere = 0\nvector = [1, 0, 0]";
  return {
      row("scene/acts.cpp: only with act", "[[act]] reach: found 1, allowed only with act = \"push\"",
          act(fine + "\nreach = 1")),
      row("scene/acts.cpp: missing(\"time\"", "[[act]] time: found nothing, allowed 0 to 1e+09", "[[act]]\n"),
      row("scene/acts.cpp: the time of the act before", "found 0, allowed 1, the time of the act before, or more",
          "[[act]]\ntime = 1\n" + fine + "\n" + act(fine)),
      row("scene/acts.cpp: missing(\"act\"", "[[act]] act: found nothing, allowed throw, push, drop", act("")),
      row("scene/acts.cpp: missing(\"sphere\"", "[[act]] sphere: found nothing, allowed an integer, 0 to 1",
          act("act = \"throw\"\nvector = [1, 0, 0]")),
      row("scene/acts.cpp: missing(\"vector\"", "[[act]] vector: found nothing, allowed an array of 3 numbers",
          act("act = \"throw\"\nsphere = 0")),
      row("scene/acts.cpp: inside of the domain", "allowed inside of the domain",
          act("act = \"drop\"\nvector = [100, 0, 0]")),
      {"scene/acts.cpp: a drop before it",
       "[[act]] sphere: found 0, allowed a drop before it: there is no sphere yet",
       {"simulate", "empty.toml", "--time", "0", "--acts", "a.toml"},
       act(fine)},
      row("world/acts.cpp: RunError", "drop at t = 0 s: no room for a sphere",
          act("act = \"drop\"\nvector = [-1.5, -0.25, 0]")),
  };
}

}  // namespace ballpit
