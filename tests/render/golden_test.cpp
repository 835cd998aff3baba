// SPDX-License-Identifier: MIT
// Compares pictures of stored states with tests/golden. After an intended change of pictures:
//     BALLPIT_BLESS=1 ctest --test-dir build/release -R golden
// It fails with "blessed: …" for each picture that it replaces. Look at them, and run it again without BALLPIT_BLESS.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>

#include "tests/support/oracle.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr float kAspect = 16.0f / 9;

const DomainBox kBox;
const DomainBox kOpen{Vec3(0), Vec3(1), 3, true};
const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};

Inspection stored(const std::string& name, const DomainBox& domain, float edge) {
  return inspect(read_spheres(BALLPIT_GOLDEN_FOLDER "/" + name + ".csv"), domain, edge);
}

}  // namespace

TEST_CASE("golden: a cloud of spheres with its grid, on white") {
  const Inspection cloud = stored("cloud", kBox, 0.125f);
  CHECK(compare_with_golden("cloud_grid", draw(view_of(cloud, kBox, kAspect, {"grid"}), kWidth, kHeight)) == "");
}

TEST_CASE("golden: a cloud of spheres in an open box, on dark") {
  const Inspection cloud = stored("cloud", kOpen, 0);
  const RenderOptions dark{theme_named("dark"), 1};
  CHECK(compare_with_golden("cloud_open_dark", draw(view_of(cloud, kOpen, kAspect), kWidth, kHeight, dark)) == "");
}

TEST_CASE("golden: a cloud of spheres that hide the light from each other and from the floor") {
  for (const char* theme : {"projector", "dark"}) {
    Inspection cloud = stored("cloud", kBox, 0);
    cloud.bodies.occluders = all_occluders(cloud.bodies);
    const Image picture = draw(view_of(cloud, kBox, kAspect), kWidth, kHeight, {theme_named(theme), 1});
    CHECK(compare_with_golden(std::string("cloud_occlusion_") + theme, picture) == "");
  }
}

TEST_CASE("the comparison of pictures detects lost shadows, of the floor and of spheres alone") {
  Inspection cloud = stored("cloud", kBox, 0);
  cloud.bodies.occluders = all_occluders(cloud.bodies);
  const FrameView view = view_of(cloud, kBox, kAspect);
  const Image whole = draw(view, kWidth, kHeight);
  RenderOptions bright;
  bright.theme.shadow = 0;
  CHECK(worst_block(draw(view, kWidth, kHeight, bright), whole) > 8);
  cloud.bodies.occluders.assign(cloud.bodies.occluders.size(), {});
  CHECK(worst_block(draw(view, kWidth, kHeight), whole) > 8);
}

TEST_CASE("golden: a planar scene with its grid") {
  const Inspection plane = stored("plane", kPlane, 1);
  CHECK(compare_with_golden("plane_grid", draw(view_of(plane, kPlane, kAspect, {"grid"}), kWidth, kHeight)) == "");
}

TEST_CASE("the comparison of pictures detects a missing sphere, but ignores rounding") {
  std::vector<Sphere> spheres = read_spheres(BALLPIT_GOLDEN_FOLDER "/cloud.csv");
  const Inspection all = inspect(spheres, kBox);
  const Image whole = draw(view_of(all, kBox, kAspect), kWidth, kHeight);
  Image rounded = whole;
  for (size_t i = 0; i < rounded.pixels.size(); i += 7) rounded.pixels[i] ^= 3;
  CHECK(worst_block(rounded, whole) == 0);

  // The nearest sphere is not hidden.
  const Vec3 eye = view_of(all, kBox, kAspect).camera.eye;
  const auto nearest = std::min_element(spheres.begin(), spheres.end(), [&](const Sphere& a, const Sphere& b) {
    return length(a.center - eye) < length(b.center - eye);
  });
  spheres.erase(nearest);
  const Inspection fewer = inspect(spheres, kBox);
  CHECK(worst_block(draw(view_of(fewer, kBox, kAspect), kWidth, kHeight), whole) > 8);
}

TEST_CASE("the comparison of pictures detects a grid line that is shifted by a twentieth of a cell") {
  const Inspection plane = stored("plane", kPlane, 1);
  Inspection shifted = plane;
  shifted.grids[0].origin.x += 0.05f;
  const Image expected = draw(view_of(plane, kPlane, kAspect, {"grid"}), kWidth, kHeight);
  CHECK(worst_block(draw(view_of(shifted, kPlane, kAspect, {"grid"}), kWidth, kHeight), expected) > 8);
}

TEST_CASE("blessing replaces golden pictures that differ or are missing, and does not pass") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "ballpit-bless";
  std::filesystem::create_directories(folder);
  const std::string golden = (folder / "dot.png").string();
  const Image white{16, 16, std::vector<uint8_t>(16 * 16 * 4, 255)},
      gray{16, 16, std::vector<uint8_t>(16 * 16 * 4, 200)};
  const char* before = std::getenv("BALLPIT_BLESS");
  const std::string own = before ? before : "";
  ::setenv("BALLPIT_BLESS", "1", 1);
  for (const Image& picture : {white, gray}) {
    CHECK_THAT(compare_with_golden("dot", picture, folder.string()),
               Catch::StartsWith("blessed: " + golden + "; look"));
    CHECK(difference(read_png(golden).pixel(0, 0), picture.pixel(0, 0)) == 0);
    CHECK(compare_with_golden("dot", picture, folder.string()) == "");  // it is the golden picture now
  }
  before ? ::setenv("BALLPIT_BLESS", own.c_str(), 1) : ::unsetenv("BALLPIT_BLESS");
  std::filesystem::remove_all(folder);
}

TEST_CASE("pictures that differ are written side by side, and the file is named") {
  Image expected{4, 3, std::vector<uint8_t>(4 * 3 * 4, 200)}, actual = expected;
  std::fill_n(actual.pixels.begin(), 3 * 4 * 3, uint8_t{0});
  CHECK(compare_pictures("side-by-side", expected, expected) == "");
  const std::string file = (std::filesystem::current_path() / "golden-failures" / "side-by-side.png").string();
  CHECK_THAT(compare_pictures("side-by-side", actual, expected), Catch::Contains(file));
  CHECK(read_png(file).width == 3 * 4 + 2 * 8);
  std::filesystem::remove(file);
}
