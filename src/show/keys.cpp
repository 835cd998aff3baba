// SPDX-License-Identifier: MIT
#include "show/keys.h"

#include <array>

namespace ballpit {

namespace {

constexpr std::array kKeys{
    Key{'1', "1", "brute force", Action::use_method, "brute-force"},
    Key{'2', "2", "sort and sweep", Action::use_method, "sort-and-sweep"},
    Key{'3', "3", "linked cell", Action::use_method, "linked-cell"},
    Key{'4', "4", "sorted grid", Action::use_method, "sorted-grid"},
    Key{' ', "Space", "pause, or go on", Action::pause, ""},
    Key{'.', ".", "one step forward", Action::step, ""},
    Key{',', ",", "one step back", Action::step_back, ""},
    Key{'R', "R", "restart the scene", Action::restart, ""},
    Key{'G', "G", "grid", Action::toggle_overlay, "grid"},
    Key{'I', "I", "intervals", Action::toggle_overlay, "intervals"},
    Key{'P', "P", "pairs: candidates, contacts, missed", Action::toggle_overlay, "pairs"},
    Key{'L', "L", "lists: head and next", Action::toggle_overlay, "lists"},
    Key{'N', "N", "numbers of spheres and cells", Action::toggle_overlay, "labels"},
    Key{'V', "V", "velocities", Action::toggle_overlay, "velocity"},
    Key{'W', "W", "swept ways", Action::toggle_overlay, "swept"},
    Key{'T', "T", "other theme", Action::change_theme, ""},
    Key{'H', "H", "view the whole domain again", Action::reset_view, ""},
    Key{'S', "S", "save a picture", Action::save_picture, ""},
    Key{kKeyF1, "F1", "show these keys, or hide them", Action::show_keys, ""},
};

}  // namespace

std::span<const Key> key_table() { return kKeys; }

}  // namespace ballpit
