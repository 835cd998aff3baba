// SPDX-License-Identifier: MIT
// ballpit compare: status 0 for pictures that show the same, 1 for others, 2 for what is no picture.
#include <catch2/catch.hpp>

#include "export/png.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// White, with a black square of this edge [px] at (16, 8).
Image square(int edge, int width = 64) {
  Image image{width, 40, std::vector<uint8_t>(static_cast<size_t>(width) * 40 * 4, 255)};
  for (int y = 8; y < 8 + edge; ++y) {
    for (int x = 16; x < 16 + edge; ++x) std::fill_n(image.pixels.begin() + (y * width + x) * 4, 3, uint8_t{0});
  }
  return image;
}

/// A folder with the pictures plain.png, marked.png (a square of 5 x 5 pixels), dotted.png (of 2 x 2) and wide.png.
struct Pictures {
  Pictures() {
    write_png(folder / "plain.png", square(0));
    write_png(folder / "marked.png", square(5));
    write_png(folder / "dotted.png", square(2));
    write_png(folder / "wide.png", square(0, 65));
  }

  Outcome compare(const std::vector<std::string>& more) const {
    Circumstances here;
    here.folder = folder.path().string();
    return run_program(with({"compare"}, more), here);
  }

  Scratch folder;
};

}  // namespace

TEST_CASE("compare ends with status 0 for pictures that show the same, in one line") {
  const Pictures pictures;
  const Outcome same = pictures.compare({"plain.png", "plain.png"});
  CHECK(same.status == 0);
  CHECK(same.err.empty());
  CHECK(same.out ==
        "plain.png shows what plain.png shows: 0 of 2560 pixels differ; the largest difference of a colour is 0 of "
        "255\n");
  const Outcome near = pictures.compare({"plain.png", "dotted.png"});
  CHECK(near.status == 0);
  CHECK(near.out ==
        "dotted.png shows what plain.png shows: 4 of 2560 pixels differ, 4 of them in the block of 8 x 8 at (16, 8), "
        "where 8 may; the largest difference of a colour is 255 of 255\n");
}

TEST_CASE("compare ends with status 1 for pictures that differ, and says where and how much") {
  const Pictures pictures;
  const Outcome outcome = pictures.compare({"plain.png", "marked.png"});
  CHECK(outcome.status == 1);
  CHECK(outcome.out.empty());
  CHECK(outcome.err ==
        "ballpit: marked.png: differs from plain.png: 25 of 2560 pixels differ, 25 of them in the block of 8 x 8 at "
        "(16, 8), where 8 may; the largest difference of a colour is 255 of 255\n");
}

TEST_CASE("pictures of other sizes differ") {
  const Pictures pictures;
  const Outcome outcome = pictures.compare({"plain.png", "wide.png", "--out", "d.png"});
  CHECK(outcome.status == 1);
  CHECK(outcome.err == "ballpit: wide.png: has 65x40 pixels, and plain.png has 64x40; see d.png\n");
  CHECK(read_png(pictures.folder / "d.png").width == 64 + 8 + 65);
}

TEST_CASE("compare --out writes both pictures and what differs, whether they show the same or not") {
  const Pictures pictures;
  const Outcome outcome = pictures.compare({"plain.png", "marked.png", "--out", "d.png"});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("; see d.png\n"));
  const Image row = read_png(pictures.folder / "d.png");
  CHECK(row.width == 3 * 64 + 2 * 8);
  CHECK(row.pixel(16, 8)[0] == 255);
  CHECK(row.pixel(72 + 16, 8)[0] == 0);
  CHECK(row.pixel(144 + 16, 8)[0] == 0xD5);
  CHECK(pictures.compare({"plain.png", "plain.png", "--out", "same.png"}).status == 0);
  CHECK(read_png(pictures.folder / "same.png").width == row.width);
}

TEST_CASE("compare --json prints one object, with status 0 or 1") {
  const Pictures pictures;
  const Outcome other = pictures.compare({"plain.png", "marked.png", "--json", "--out", "d.png"});
  CHECK(other.status == 1);
  const nlohmann::json found = other.json();
  CHECK(found["same"] == false);
  CHECK(found["a"] == "plain.png");
  CHECK(found["b"] == "marked.png");
  CHECK(found["size_a"] == "64x40");
  CHECK(found["size_b"] == "64x40");
  CHECK(found["pixels"] == 2560);
  CHECK(found["differing"] == 25);
  CHECK(found["largest_difference"] == 255);
  CHECK(found["worst_block"] == nlohmann::json{{"left", 16}, {"top", 8}, {"differing", 25}});
  CHECK(found["out"] == "d.png");
  const Outcome same = pictures.compare({"plain.png", "dotted.png", "--json"});
  CHECK(same.status == 0);
  CHECK(same.json()["same"] == true);
  CHECK(same.json()["out"].is_null());
  const Outcome wide = pictures.compare({"plain.png", "wide.png", "--json"});
  CHECK(wide.status == 1);
  CHECK(wide.json()["same"] == false);
  CHECK(wide.json()["size_b"] == "65x40");
}

TEST_CASE("compare ends with status 2 for what is no picture, and leaves no file") {
  const Pictures pictures;
  write_text(pictures.folder / "cut.png", read_text(pictures.folder / "plain.png").substr(0, 60));
  write_text(pictures.folder / "text.png", "no picture");
  fs::create_directory(pictures.folder / "folder.png");
  for (const char* wrong : {"cut.png", "text.png", "folder.png", "missing.png", "plain.png/x"}) {
    for (const bool is_first : {false, true}) {
      INFO(wrong);
      const Outcome outcome =
          pictures.compare({is_first ? wrong : "plain.png", is_first ? "plain.png" : wrong, "--out", "d.png"});
      CHECK(outcome.status == 2);
      CHECK(outcome.out.empty());
      CHECK_THAT(outcome.err, Catch::StartsWith("ballpit: " + std::string(wrong) + ": found "));
      CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    }
  }
  for (const char* picture : {"plain.png", "./marked.png"}) {
    CHECK(pictures.compare({"plain.png", "marked.png", "--out", picture}).status == 2);
  }
  CHECK(pictures.compare({"plain.png"}).status == 2);
  CHECK(pictures.compare({"plain.png", "marked.png", "dotted.png"}).status == 2);
  CHECK_FALSE(fs::exists(pictures.folder / "d.png"));
  CHECK(read_png(pictures.folder / "marked.png").pixels == square(5).pixels);
}

TEST_CASE("a frame of another state differs from a golden picture, a frame of the same state does not") {
  const Scratch scratch;
  for (const char* name : {"a", "b"}) {
    REQUIRE(run_program({"render", "lecture-grid", "--size", "320x180", "--frames", "2", "--every", "30", "--out",
                         scratch / name})
                .status == 0);
  }
  CHECK(run_program({"compare", scratch / "a/frame_00001.png", scratch / "b/frame_00001.png"}).status == 0);
  CHECK(run_program({"compare", scratch / "a/frame_00000.png", scratch / "b/frame_00001.png"}).status == 1);
}
