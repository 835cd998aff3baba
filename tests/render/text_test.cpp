// SPDX-License-Identifier: MIT
// Whether text can be read from the last row, and where numbers stand.
#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "render/overlays/overlay.h"
#include "render/page_view.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};
constexpr float kLecture = 1.6f;

/// A text in black on white, in a picture of 1080 lines.
Image drawn(const char* text, TextSize size, float scale) {
  const GlContext context;
  const RenderTarget target(400, 1080);
  Sheet sheet;
  sheet.begin(target.width, target.height, {0, 0, target.width, target.height}, scale);
  target.bind();
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  sheet.text({20, 200}, kUpperLeft, to_rgba(Vec3(0)), text, size);
  sheet.draw();
  Image image{target.width, target.height, {}};
  image.pixels.resize(static_cast<size_t>(target.width * target.height) * 4);
  glReadPixels(0, 0, target.width, target.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  return image;
}

/// The height of a text's ink [pixel] in a picture of 1080 lines.
int height_of(const char* text, TextSize size, float scale) {
  const Image image = drawn(text, size, scale);
  int rows = 0;
  for (int y = 0; y < image.height; ++y) {
    bool is_dark = false;
    for (int x = 0; x < image.width; ++x) is_dark |= image.pixel(x, y)[0] < 128;
    rows += is_dark;
  }
  return rows;
}

/// Where two pictures of a size differ: the corners of the smallest rectangle.
std::pair<IVec3, IVec3> changed(const Image& a, const Image& b) {
  IVec3 low(a.width, a.height, 0), high(-1, -1, 0);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (difference(a.pixel(x, y), b.pixel(x, y)) <= 8) continue;
      low = glm::min(low, IVec3(x, y, 0));
      high = glm::max(high, IVec3(x, y, 0));
    }
  }
  return {low, high};
}

}  // namespace

TEST_CASE("in a lecture of 1080 lines, capitals of captions are 34 pixels high, and digits in boxes 26") {
  CHECK(height_of("H", TextSize::normal, kLecture) >= 34);
  CHECK(height_of("8", TextSize::small, kLecture) >= 26);
  CHECK(height_of("H", TextSize::title, kLecture) >= height_of("H", TextSize::normal, kLecture));
}

TEST_CASE("in a picture of 1080 lines, digits are 22 pixels high") {
  CHECK(height_of("8", TextSize::small, 1) >= 22);
  CHECK(height_of("8", TextSize::normal, 1) >= 22);
}

TEST_CASE("each sign of the texts has a letter, and no question mark stands for it, also the arrows of the keys") {
  for (const TextSize size : {TextSize::small, TextSize::panel}) {
    const Image unknown = drawn("?", size, 1);
    const auto is_unknown = [&](const char* sign) { return drawn(sign, size, 1).pixels == unknown.pixels; };
    CHECK(is_unknown("☃"));
    for (const char* sign : {"←", "→", "⌊", "⌋", "⁰", "³", "⁻", "−", "–", "…", "·", "×", "√", "≤",
                             "≥", "≈", "∞", "∂", "Δ", "°", "µ", "α", "λ", "τ", "„", "“", "ß", "Ü"}) {
      CAPTURE(sign);
      CHECK_FALSE(is_unknown(sign));
    }
  }
}

TEST_CASE("a page leaves room for every line of its caption") {
  PageView page;
  page.slides = "Slides 2–4";
  page.caption = "2 spheres touch.";
  const float one = room_of(page, kLecture, 16.0f / 9).below;
  page.caption = "Threads 3 and 5 both load 2 from head[4]: one particle is lost, and so is its contact.";
  const float two = room_of(page, kLecture, 16.0f / 9).below;
  CHECK(two - one == Approx(line_height(TextSize::normal, kLecture) / 1080));
}

TEST_CASE("the number of a cell stays in its corner when a sphere comes there") {
  const auto picture = [](Vec3 centre, bool has_number) {
    Inspection inspection = inspect({{centre, 0.3f}}, kPlane, 5);  // one cell
    if (!has_number) inspection.grids.clear();
    FrameView view = view_of(inspection, kPlane, 1, {"labels"});
    return draw(view, 600, 600);
  };
  const auto corner_of_numbers = [&](Vec3 centre) { return changed(picture(centre, true), picture(centre, false)); };
  const auto far = corner_of_numbers({4.2f, 4.2f, 0}), near = corner_of_numbers({0.45f, 0.45f, 0});
  CHECK(length(Vec3(far.first - near.first)) <= 2);
  CHECK(length(Vec3(far.second - near.second)) <= 2);
}

TEST_CASE("on a page the number of a cell is in another corner where a sphere's number would hide it") {
  const auto picture = [](bool has_number, bool has_page) {
    Inspection inspection = inspect({{{0.2f, 0.25f, 0}, 0.3f}}, kPlane, 5);  // one cell
    if (!has_number) inspection.grids.clear();
    FrameView view = view_of(inspection, kPlane, 1, {"labels"});
    const PageView page;
    if (has_page) view.page = &page;
    return draw(view, 600, 600);
  };
  const auto height = [&](bool has_page) { return changed(picture(true, has_page), picture(false, has_page)).first.y; };
  CHECK(height(true) < 200);  // upper left; outside pages there is none, or it is below
  CHECK(height(false) > 400);
}

TEST_CASE("a kernel's lines are as large as they fit, and never smaller than the panel's text") {
  const auto line_of = [](int lines) {  // the height of the marked line
    PageView page;
    page.code.assign(static_cast<size_t>(lines), "load");
    page.line = 0;
    const Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 0.3f}}, kPlane);
    FrameView view = view_of(inspection, kPlane, 16.0f / 9);
    PageView none = page;
    none.line = -1;
    view.page = &page;
    const Image with = draw(view, 960, 540);
    view.page = &none;
    const auto [low, high] = changed(with, draw(view, 960, 540));
    return high.y - low.y + 1;
  };
  CHECK(line_of(4) > 1.4 * line_of(60));
  CHECK(line_of(60) >= 12);  // of 540; the panel has 11
}

TEST_CASE("a cell says how many spheres it holds as n = 2, and only where there are no numbers of spheres") {
  const auto drawn = [](int spheres, std::vector<std::string> overlays) {
    std::vector<Sphere> all;
    for (int k = 0; k < spheres; ++k) all.push_back({{0.4f + 0.2f * static_cast<float>(k), 0.4f, 0}, 0.05f});
    const Inspection inspection = inspect(all, kPlane, 2.5f);
    return draw(view_of(inspection, kPlane, 1, std::move(overlays)), 600, 600);
  };
  const Image one = drawn(1, {"grid"}), labelled = drawn(1, {"grid", "labels"});
  const auto dark_columns = [](const Image& image) {  // in the upper right quarter of the lower left cell
    const Vec3 ink = themes().front().cell_text;
    int columns = 0;
    for (int x = 200; x < 292; ++x) {
      bool has_ink = false;
      for (int y = 302; y < 340; ++y) has_ink |= difference(image.pixel(x, y), ink) < 110;
      columns += has_ink;
    }
    return columns;
  };
  CHECK(dark_columns(one) > 14);  // a digit alone is 6 wide
  CHECK(dark_columns(labelled) == 0);
}

TEST_CASE("a long note goes on in the next line where the picture is narrow") {
  const GlContext context;
  const Inspection inspection = inspect({{{2, 2, 0}, 0.3f}}, kPlane);  // without cells
  const auto lowest_of = [&](int width) {
    FrameView with = view_of(inspection, kPlane, static_cast<float>(width) / 600, {"grid"}), without = with;
    without.overlays.clear();
    return changed(draw(with, width, 600), draw(without, width, 600));
  };
  const auto wide = lowest_of(1200), narrow = lowest_of(338);
  CHECK(narrow.second.y - narrow.first.y > 1.5f * (wide.second.y - wide.first.y));
  CHECK(narrow.second.x < 338 - 4);
}
