// SPDX-License-Identifier: MIT
// The keys of a demonstration.
#include <array>

#include "show/demo.h"

namespace ballpit {

std::span<const Key> key_table() {
  static constexpr std::array kKeys{
      Key{'1', "1", "brute force", [](Demo& demo) { demo.set("broadphase", "brute-force"); }},
      Key{'2', "2", "sort and sweep", [](Demo& demo) { demo.set("broadphase", "sort-and-sweep"); }},
      Key{'3', "3", "linked cell", [](Demo& demo) { demo.set("broadphase", "linked-cell"); }},
      Key{'4', "4", "sorted grid", [](Demo& demo) { demo.set("broadphase", "sorted-grid"); }},
      Key{' ', "Space", "pause, or go on", [](Demo& demo) { demo.player.is_running = !demo.player.is_running; }},
      Key{'.', ".", "one step forward", [](Demo& demo) { demo.step(); }},
      Key{',', ",", "one step back", [](Demo& demo) { demo.step_back(); }},
      Key{'R', "R", "restart the scene", [](Demo& demo) { demo.restart(); }},
      Key{'G', "G", "grid", [](Demo& demo) { demo.view.toggle("grid"); }},
      Key{'I', "I", "intervals", [](Demo& demo) { demo.view.toggle("intervals"); }},
      Key{'P', "P", "pairs: candidates, contacts, missed", [](Demo& demo) { demo.view.toggle("pairs"); }},
      Key{'L', "L", "lists: head and next", [](Demo& demo) { demo.view.toggle("lists"); }},
      Key{'N', "N", "numbers of spheres and cells", [](Demo& demo) { demo.view.toggle("labels"); }},
      Key{'V', "V", "velocities", [](Demo& demo) { demo.view.toggle("velocity"); }},
      Key{'W', "W", "swept ways", [](Demo& demo) { demo.view.toggle("swept"); }},
      Key{'E', "E", "drop the exact ghost here", [](Demo& demo) { demo.drop_ghost(); }},
      Key{'X', "X", "hide the exact ghost, or show it", [](Demo& demo) { demo.view.toggle("ghost"); }},
      Key{'T', "T", "other theme",
          [](Demo& demo) { demo.view.theme = themes()[demo.view.theme == themes()[0].name ? 1 : 0].name; }},
      Key{'O', "O", "turn the camera slowly, or hold it",
          [](Demo& demo) { demo.view.set_turn(demo.view.turn == 0 ? kSlowTurn : 0, demo.session.time()); }},
      Key{'H', "H", "view the whole domain again", [](Demo& demo) { demo.view.reset(); }},
      Key{290, "F1", "show these keys, or hide them", [](Demo& demo) { demo.shows_keys = !demo.shows_keys; }},
  };
  return kKeys;
}

}  // namespace ballpit
