// SPDX-License-Identifier: MIT
// Messages of commands that read pictures and make films.
#include "tests/cli/messages_table.h"

namespace ballpit {

namespace {

/// The picture of the film that the test of the messages makes.
const std::string kPicture = "old/frame_00000.png";

}  // namespace

std::vector<Row> rows_of_pictures() {
  return {
      {"export/read_png.cpp: (path.string(), found, \"a PNG file\")",
       "a.csv: found an empty file, allowed a PNG file",
       {"compare", "a.csv", kPicture}},
      {"cli/command_compare.cpp: differs from",
       "dark/frame_00000.png: differs from old/frame_00000.png: ",
       {"compare", kPicture, "dark/frame_00000.png"}},
      {"cli/command_compare.cpp: pixels, and",
       "large.png: has 208x36 pixels, and old/frame_00000.png has 64x36",
       {"compare", kPicture, "large.png"}},
  };
}

}  // namespace ballpit
