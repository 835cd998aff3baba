// SPDX-License-Identifier: MIT
// Messages of commands that read pictures and make films.
#include "tests/cli/messages_table.h"

namespace ballpit {

namespace {

const std::vector<std::pair<const char*, std::string>> kBroken{{"PATH", "broken"}}, kNoProgram{{"PATH", ""}};

/// A film of two frames with other options.
Arguments film(const Arguments& more) {
  return with({"render", "two-spheres", "--frames", "2", "--film", "film.mp4"}, more);
}

/// Of the pictures that the test of the messages makes.
const std::string kPicture = "projector/frame_00000.png";

}  // namespace

std::vector<Row> rows_of_pictures() {
  return {
      {"export/read_png.cpp: (path.string(), found, \"a PNG file\")",
       "a.csv: found an empty file, allowed a PNG file",
       {"compare", "a.csv", kPicture}},
      {"cli/command_compare.cpp: differs from",
       "dark/frame_00000.png: differs from projector/frame_00000.png: ",
       {"compare", kPicture, "dark/frame_00000.png"}},
      {"cli/command_compare.cpp: pixels, and",
       "large.png: has 208x36 pixels, and projector/frame_00000.png has 64x36",
       {"compare", kPicture, "large.png"}},
      {"cli/command_render.cpp: --out DIR",
       "--out: found nothing, allowed --out DIR, --film FILE.mp4 or both",
       {"render"}},
      {"cli/command_render.cpp: a film is made whole",
       "--resume: found with --film, allowed without it, since a film is made whole", film({"--resume"})},
      {"cli/command_render.cpp: even sides", "--size: found 641x360 with --film, allowed even sides",
       film({"--size", "641x360"})},
      {"cli/command_render.cpp: 1 or more", "--film: found 0.5 frames a second (--fps by --every), allowed 1 or more",
       film({"--every", "120"})},
      {"export/film_file.cpp: ends in .mp4",
       "--film: found film.avi, allowed a name that ends in .mp4",
       {"render", "--film", "film.avi"}},
      {"export/film_file.cpp: one to replace",
       "--film: found folder.mp4, which is no file, allowed a new file, or one to replace",
       {"render", "--film", "folder.mp4"}},
      {"export/film_file.cpp: installed",
       "--film: found no ffmpeg on the PATH, allowed an installed ffmpeg; on Debian: ", film({}), "", kNoProgram},
      {"export/film_file.cpp: ffmpeg failed", "film.mp4: ffmpeg failed: broken", film({"--size", "64x36"}), "",
       kBroken},
  };
}

std::vector<Unreached> unreached_of_pictures() {
  return {{"core/program.cpp: cannot open a pipe", "the system without file descriptors"}};
}

}  // namespace ballpit
