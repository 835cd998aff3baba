// SPDX-License-Identifier: MIT
// With the real ffmpeg; tests/cli/film_test.cpp tests what the program does around it.
#include "export/film_file.h"

#include <array>
#include <filesystem>

#include <catch2/catch.hpp>

#include "core/error.h"

using namespace ballpit;

namespace {

constexpr int kWidth = 128, kHeight = 64;

/// The colours of candidate, contact, grid and missed contact, side by side.
constexpr std::array<std::array<uint8_t, 3>, 4> kColors{
    {{0x56, 0xB4, 0xE9}, {0xE6, 0x9F, 0x00}, {0x00, 0x9E, 0x73}, {0xD5, 0x5E, 0x00}}};

Image stripes() {
  Image image{kWidth, kHeight, std::vector<uint8_t>(kWidth * kHeight * 4, 255)};
  for (size_t k = 0; k < image.pixels.size(); ++k) {
    if (k % 4 < 3) image.pixels[k] = kColors[k / 4 % kWidth * 4 / kWidth][k % 4];
  }
  return image;
}

}  // namespace

TEST_CASE("colours are the same in a film") {
  const std::string ffmpeg = find_program("ffmpeg");
  if (ffmpeg.empty()) {
    WARN("skipped: ffmpeg is not installed");
    return;
  }
  const std::string path = (std::filesystem::temp_directory_path() / "ballpit-film-test.mp4").string();
  FilmFile film(path, kWidth, kHeight, 60);
  for (int k = 0; k < 4; ++k) film.push(stripes());
  CHECK_FALSE(std::filesystem::exists(path));
  film.finish();
  const ProgramResult decoded = call_program(
      {.path = ffmpeg, .arguments = {"-loglevel", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"}});
  REQUIRE(decoded.output.size() == size_t{4} * kWidth * kHeight * 3);
  for (size_t stripe = 0; stripe < 4; ++stripe) {
    const size_t pixel = kWidth * kHeight / 2 + (2 * stripe + 1) * kWidth / 8;
    for (size_t c = 0; c < 3; ++c) {
      INFO("stripe " << stripe << ", colour " << c);
      CHECK(std::abs(static_cast<uint8_t>(decoded.output[3 * pixel + c]) - int{kColors[stripe][c]}) <= 4);
    }
  }
  std::filesystem::remove(path);
}
