// SPDX-License-Identifier: MIT
#include "tests/cli/messages_table.h"

namespace ballpit {

namespace {

/// One sphere that must have springs, and must not.
const std::string kContradiction =
    kBox + kSphere + "[needs]\nduration = 1\neffects = [\"contact-time\", \"momentum-order\"]\n";

/// A film with a choice that was made before.
Arguments resumed(const std::string& folder) {
  return {"render",   "two-spheres", "--response", "auto",  "--out",   folder,
          "--frames", "200",         "--size",     "64x36", "--resume"};
}

}  // namespace

std::vector<Row> rows_of_choices() {
  return {
      {"cli/command_choose.cpp: choice.reason",
       "a: nothing holds all that is needed; nearest is",
       {"choose", "a.toml"},
       kContradiction},
      {"show/session.cpp: choice_->reason",
       "a: nothing holds all that is needed; nearest is",
       {"simulate", "a.toml", "--response", "auto"},
       kContradiction},
      interrupted("cli/command_choose.cpp: \"interrupted\"", "rain: interrupted",
                  {"choose", "rain", "--count", "30000", "--budget", "60"}),
      {"choose/record.cpp: the choice of an earlier run",
       "choice.json: found no JSON, allowed the choice of an earlier run", resumed("no-choice")},
      {"scene/table_reader.cpp: an array of texts",
       "[needs] effects: found \"resting\", allowed an array of texts",
       {"choose", "a.toml"},
       "[needs]\neffects = \"resting\"\n"},
      {"scene/table_reader.cpp: describe(element), join(names)",
       "[needs] effects: found \"rest\", allowed resting",
       {"choose", "a.toml"},
       "[needs]\neffects = [\"rest\"]\n"},
      {"show/session.cpp: no dearer settings", "two-spheres: t = ", resumed("poor-choice")},
      {"cli/command_render.cpp: with --click cheapest",
       "--resume: found with --click cheapest, allowed without it, since a choice depends on measured times",
       render({"--panel", "--click", "cheapest", "--resume"})},
  };
}

std::vector<Unreached> unreached_of_choices() {
  return {{"world/event_driven_world.cpp: kTooFast", "only pilots have no patience, and theirs is a result"}};
}

}  // namespace ballpit
