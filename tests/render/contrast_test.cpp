// SPDX-License-Identifier: MIT
// Whether marks can be told from what they are drawn on: computed from the colours of the themes, and measured in
// pictures.
#include "render/contrast.h"

#include <catch2/catch.hpp>

#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};

/// A colour that carries meaning, its rim, and all that it is drawn on.
struct Use {
  const char* mark;
  Vec3 color, rim;  // equal if it has no rim
  std::vector<Vec3> grounds;
  bool is_outline = false;  // the rim need not differ from the colour
};

/// The tints of cells with up to eight spheres, as the grid draws them.
std::vector<Vec3> cell_tints(const Theme& theme) {
  std::vector<Vec3> tints;
  for (const float opacity : {0.0f, 0.2f, 0.3f, 0.48f}) tints.push_back(blended(theme.grid, opacity, theme.background));
  for (const Vec3& tint : std::vector(tints)) tints.push_back(blended(theme.selected, 0.2f, tint));
  return tints;
}

std::vector<Use> uses_of(const Theme& theme) {
  const Vec3 ground = theme.background, floor = theme.floor, sphere = theme.body, touching = theme.contact;
  const Vec3 contact_rim = rim_of(theme.contact);
  const std::vector<Vec3> anywhere{ground, floor, sphere, touching};
  std::vector<Use> uses = {
      {"rim of a touching sphere on a resting one", contact_rim, contact_rim, {sphere, touching}},
      {"touching sphere, with its rim", theme.contact, contact_rim, anywhere},
      {"candidate", theme.candidate, rim_of(theme.candidate), anywhere},
      {"selected sphere and block", theme.selected, rim_of(theme.selected), anywhere},
      {"missed contact, on its casing", theme.missed, theme.missed, {ground, floor}},
      {"velocity and path", theme.text, ground, anywhere},
      {"domain", theme.domain, theme.domain, {ground, floor}},
      {"begin and end", theme.begin, theme.begin, {ground}},
      {"idle thread", theme.idle, theme.idle, {ground}},
      {"grid", theme.grid, theme.grid, {ground, floor}},
      {"theory, reference and exact motion", theme.reference, theme.reference, {ground, floor}},
      {"brute force in charts", theme.text, theme.text, {ground}},
      {"sort and sweep in charts", theme.begin, theme.begin, {ground}},
      {"linked cell in charts", theme.grid, theme.grid, {ground}},
      {"sorted grid and a failed run in charts", theme.missed, theme.missed, {ground}},
      {"number of a cell", theme.cell_text, theme.cell_text, cell_tints(theme)},
      {"text", theme.text, theme.text, {ground, floor}},
      {"pale text", blended(theme.text, 0.6f, ground), blended(theme.text, 0.6f, ground), {ground}},
  };
  for (int mark = 0; mark < 2 + kScaleColors; ++mark) {
    const Vec3 fill = color_of(theme, mark);
    uses.push_back({"number of a sphere", text_on(fill), text_on(fill), {fill}});
    const Vec3 edge = rim_width(theme, mark) > 0 ? contact_rim : fill;
    if (mark > 0) uses.push_back({"sphere with a mark, or its rim", fill, edge, {ground, floor}, true});
  }
  for (const Vec3& fill : {theme.begin, theme.candidate}) {
    uses.push_back({"name of an endpoint", text_on(fill), text_on(fill), {fill}});
  }
  return uses;
}

/// The largest contrast to `ground` on a row of pixels.
float most_contrast(const Image& image, int y, int from, int to, const Vec3& ground) {
  float most = 1;
  for (int x = from; x <= to; ++x) {
    const uint8_t* pixel = image.pixel(x, y);
    most = std::max(most, contrast(Vec3(pixel[0], pixel[1], pixel[2]) / 255.0f, ground));
  }
  return most;
}

constexpr int kDirections = 16;

/// The largest contrast to the ground near the edge of a sphere, in direction k: on the outer fifth of its radius, which perspective
/// makes up to a twentieth longer.
float contrast_of_edge(const Image& image, Vec2 middle, float radius, int k, const Vec3& ground) {
  const float angle = static_cast<float>(k) * 2 * 3.14159265f / kDirections;
  float most = 1;
  for (float part = 0.8f; part < 1.05f; part += 0.004f) {
    const Vec2 at = middle + part * radius * Vec2(std::cos(angle), std::sin(angle));
    most = std::max(
        most, most_contrast(image, static_cast<int>(at.y), static_cast<int>(at.x), static_cast<int>(at.x), ground));
  }
  return most;
}

Vec2 place(const FrameView& view, const Vec3& point, int size) {
  const Vec4 clip = view.camera.projection() * view.camera.view() * Vec4(point, 1);
  return Vec2(1 + clip.x / clip.w, 1 - clip.y / clip.w) / 2.0f * static_cast<float>(size);
}

}  // namespace

TEST_CASE("contrast is 1 for equal colours, 21 for black on white, and the same in both orders") {
  CHECK(contrast(rgb(0x8FA9C4), rgb(0x8FA9C4)) == Approx(1));
  CHECK(contrast(rgb(0x000000), rgb(0xFFFFFF)) == Approx(21));
  CHECK(contrast(rgb(0xFFFFFF), rgb(0x000000)) == Approx(21));
  CHECK(contrast(rgb(0x767676), rgb(0xFFFFFF)) == Approx(4.54).margin(0.01));  // the example of WCAG 2.1
}

TEST_CASE("every mark, or its rim, has a contrast of at least 3:1 to all that it is drawn on, in both themes") {
  for (const Theme& theme : themes()) {
    for (const Use& use : uses_of(theme)) {
      for (const Vec3& ground : use.grounds) {
        INFO(theme.name << ": " << use.mark << " on " << ground.r * 255 << ", " << ground.g * 255 << ", "
                        << ground.b * 255);
        CHECK(std::max(contrast(use.color, ground), contrast(use.rim, ground)) >= kMinContrast);
      }
      if (use.color != use.rim && !use.is_outline) CHECK(contrast(use.color, use.rim) >= kMinContrast);
    }
  }
}

TEST_CASE("a touching sphere differs from a resting one by a dark rim, in the plane and in space") {
  constexpr int kSize = 300;
  const std::vector<Sphere> flat{{{1.5f, 2.5f, 0}, 1}, {{3.5f, 2.5f, 0}, 1}};
  const std::vector<Sphere> round{{{0.35f, 0.5f, 0.5f}, 0.15f}, {{0.65f, 0.5f, 0.5f}, 0.15f}};
  for (const bool is_planar : {true, false}) {
    for (const Theme& theme : themes()) {
      INFO(is_planar << ", " << theme.name);
      const DomainBox domain = is_planar ? kPlane : DomainBox();
      Inspection inspection = inspect(is_planar ? flat : round, domain);
      inspection.contacts = {{0, 1}};
      const FrameView view = view_of(inspection, domain, 1);
      const Image image = draw(view, kSize, kSize, {theme});
      const auto left = inspection.bodies.position_of(0), radius = Vec3(inspection.bodies.radius_of(0), 0, 0);
      const Vec2 centre = place(view, left, kSize), edge = place(view, left + radius, kSize);
      const int y = static_cast<int>(centre.y), x = static_cast<int>(edge.x);
      CHECK(most_contrast(image, y, x - 5, x + 1, theme.contact) >= kMinContrast);
      CHECK(most_contrast(image, y, x - 5, x + 1, theme.body) >= kMinContrast);
    }
  }
}

TEST_CASE("a sphere of any colour, or its edge, can be told from the ground in every direction") {
  constexpr int kSizes[] = {900, 450};  // spheres of 40 and of 20 pixels
  const DomainBox box{Vec3(0), Vec3(4, 4, 4)}, plane{Vec3(0), Vec3(4, 4, 0), 2, false};
  std::vector<Sphere> spheres;
  for (int k = 0; k < 16; ++k) {
    const float x = 0.5f + static_cast<float>(k % 4), y = 0.5f + static_cast<float>(k / 4);
    spheres.push_back({{x, y, 2}, 0.2f + 0.01f * static_cast<float>(k)});  // each has a step of the scale to itself
  }
  for (const bool is_planar : {true, false}) {
    if (is_planar) std::ranges::for_each(spheres, [](Sphere& sphere) { sphere.center.z = 0; });
    if (!is_planar) std::ranges::for_each(spheres, [](Sphere& sphere) { sphere.center.z = 2; });
    Inspection inspection = inspect(spheres, is_planar ? plane : box);
    inspection.contacts = {{0, 1}};
    for (const Theme& theme : themes()) {
      for (const char* coloring : {"contact", "size"}) {
        for (const int size : kSizes) {
          FrameView view = view_of(inspection, is_planar ? plane : box, 1);
          view.coloring = coloring;
          const Image image = draw(view, size, size, {theme});
          // On dark ground, a sphere in space stands out by its lit side.
          const bool has_edge = is_planar || theme.background.r > 0.5f;
          for (const Sphere& sphere : spheres) {
            const Vec2 middle = place(view, sphere.center, size);
            const float radius = length(place(view, sphere.center + sphere.radius * view.camera.up, size) - middle);
            float most_of_all = 1;
            for (int k = 0; k < kDirections; ++k) {
              const float most = contrast_of_edge(image, middle, radius, k, theme.background);
              most_of_all = std::max(most_of_all, most);
              INFO(is_planar << ", " << theme.name << ", " << coloring << ", radius " << radius << ", " << k);
              if (has_edge) CHECK(most >= kMinContrast);
            }
            CHECK(most_of_all >= kMinContrast);
          }
        }
      }
    }
  }
}

TEST_CASE("the line of a candidate can be seen where it crosses another sphere") {
  constexpr int kSize = 900;
  for (const Theme& theme : themes()) {
    Inspection inspection =
        inspect({{{2.5f, 0.5f, 0}, 0.3f}, {{2.5f, 4.5f, 0}, 0.3f}, {{2.5f, 2.5f, 0}, 0.8f}}, kPlane);
    inspection.candidates = {{0, 1}};
    const FrameView view = view_of(inspection, kPlane, 1, {"pairs"});
    const Image image = draw(view, kSize, kSize, {theme});
    const Vec2 middle = place(view, {2.5f, 2.5f, 0}, kSize);
    const int x = static_cast<int>(middle.x), y = static_cast<int>(middle.y);
    CHECK(most_contrast(image, y, x - 5, x + 5, theme.body) >= kMinContrast);
    const int above = static_cast<int>(place(view, {2.5f, 3.7f, 0}, kSize).y);
    CHECK(most_contrast(image, above, x - 5, x + 5, theme.background) >= kMinContrast);
  }
}

TEST_CASE("numbers are legible on the darkest and on the lightest colour of a scale") {
  constexpr int kSize = 600;
  for (const Theme& theme : themes()) {
    const Inspection inspection = inspect({{{1.5f, 2.5f, 0}, 0.7f}, {{3.5f, 2.5f, 0}, 0.9f}}, kPlane);
    FrameView view = view_of(inspection, kPlane, 1, {"labels"});
    view.coloring = "size";
    const Image image = draw(view, kSize, kSize, {theme});
    const int marks[] = {static_cast<int>(scale_mark(0)), static_cast<int>(scale_mark(kScaleColors - 1))};
    for (const int64_t body : {0, 1}) {
      const Vec2 at = place(view, inspection.bodies.position_of(body), kSize);
      const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
      const Vec3 fill = color_of(theme, marks[body]);
      CHECK(most_contrast(image, y, x - 8, x + 8, fill) >= kMinContrast);
    }
  }
}

TEST_CASE("the edges of few cells in space can be told from the ground, at the front and at the back") {
  constexpr int kSize = 900;
  const DomainBox box;
  const Inspection inspection = inspect({{{0.2f, 0.6f, 0.9f}, 0.05f}, {{0.9f, 0.6f, 0.1f}, 0.05f}}, box, 0.2f);
  const GridInspection& grid = inspection.grids.front();
  for (const Theme& theme : themes()) {
    const FrameView view = view_of(inspection, box, 1, {"grid"});
    const Image image = draw(view, kSize, kSize, {theme});
    for (size_t cell = 0; cell < grid.head.size(); ++cell) {
      if (grid.head[cell] < 0) continue;
      const auto x = static_cast<int>(cell) % grid.cells.x, rest = static_cast<int>(cell) / grid.cells.x;
      const IVec3 low(x, rest % grid.cells.y, rest / grid.cells.y);
      for (const IVec3& along : {IVec3(1, 0, 0), IVec3(0, 1, 0), IVec3(0, 0, 1)}) {
        const Vec3 middle = (lattice_point(grid, box, low) + lattice_point(grid, box, low + along)) / 2.0f;
        const Vec2 at = place(view, middle, kSize);
        const int column = static_cast<int>(at.x), row = static_cast<int>(at.y);
        float most = 1;
        for (int y = row - 2; y <= row + 2; ++y) {
          most = std::max(most, most_contrast(image, y, column - 2, column + 2, theme.background));
        }
        INFO(theme.name << ", cell " << cell << ", " << along.x << along.y << along.z);
        CHECK(most >= kMinContrast);
      }
    }
  }
}

TEST_CASE("the domain can be told from the ground") {
  constexpr int kSize = 900;
  const Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 0.3f}}, kPlane);
  for (const Theme& theme : themes()) {
    const FrameView view = view_of(inspection, kPlane, 1);
    const Image image = draw(view, kSize, kSize, {theme});
    const Vec2 edge = place(view, {0, 2.5f, 0}, kSize);
    const int x = static_cast<int>(edge.x), y = static_cast<int>(edge.y);
    CHECK(most_contrast(image, y, x - 2, x + 2, theme.background) >= kMinContrast);
  }
}
