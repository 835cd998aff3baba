// SPDX-License-Identifier: MIT
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/file.h"
#include "render/gl_context.h"

namespace ballpit {

namespace {

std::vector<Pair> all_contacts(const std::vector<Sphere>& spheres) {
  std::vector<Pair> pairs;
  for (size_t i = 0; i < spheres.size(); ++i) {
    for (size_t j = i + 1; j < spheres.size(); ++j) {
      const float distance = length(spheres[i].center - spheres[j].center);
      if (distance < spheres[i].radius + spheres[j].radius) {
        pairs.push_back({static_cast<int32_t>(i), static_cast<int32_t>(j)});
      }
    }
  }
  return pairs;
}

GridInspection make_grid(const std::vector<Sphere>& spheres, const DomainBox& domain, float edge) {
  GridInspection grid;
  grid.origin = domain.min;
  grid.edge = Vec3(edge);
  const Vec3 size = domain.max - domain.min;
  for (int axis = 0; axis < 3; ++axis) {
    grid.cells[axis] = std::max(1, static_cast<int>(std::ceil(size[axis] / edge - 1e-4f)));
  }
  grid.head.assign(static_cast<size_t>(grid.cells.x * grid.cells.y * grid.cells.z), -1);
  for (const Sphere& sphere : spheres) {
    IVec3 cell = IVec3((sphere.center - domain.min) / edge);
    for (int axis = 0; axis < 3; ++axis) cell[axis] = std::clamp(cell[axis], 0, grid.cells[axis] - 1);
    int32_t& head = grid.head[static_cast<size_t>((cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x)];
    grid.next.push_back(head);
    head = static_cast<int32_t>(grid.next.size()) - 1;
  }
  return grid;
}

}  // namespace

Inspection inspect(const std::vector<Sphere>& spheres, const DomainBox& domain, float cell_edge) {
  Inspection inspection;
  BodySnapshot& bodies = inspection.bodies;
  bodies.count = static_cast<int64_t>(spheres.size());
  bodies.dimensions = domain.dimensions;
  for (const Sphere& sphere : spheres) {
    for (int axis = 0; axis < domain.dimensions; ++axis) bodies.position.push_back(sphere.center[axis]);
    bodies.radius.push_back(sphere.radius);
  }
  inspection.contacts = all_contacts(spheres);
  if (cell_edge > 0) inspection.grids = {make_grid(spheres, domain, cell_edge)};
  return inspection;
}

std::vector<Sphere> read_spheres(const std::string& path) {
  std::istringstream lines(read_file(path));
  std::string line;
  std::getline(lines, line);  // the header
  std::vector<Sphere> spheres;
  while (std::getline(lines, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    Sphere sphere;
    numbers >> sphere.center.x >> sphere.center.y >> sphere.center.z >> sphere.radius;
    spheres.push_back(sphere);
  }
  return spheres;
}

FrameView view_of(const Inspection& inspection, const DomainBox& domain, float aspect,
                  std::vector<std::string> overlays) {
  return {inspection, domain, frame_box(domain.min, domain.max, domain.dimensions, aspect), std::move(overlays)};
}

Image draw(const FrameView& view, int width, int height, const RenderOptions& options) {
  const GlContext context;
  Renderer renderer(width, height, options);
  renderer.draw(view);
  return renderer.read_pixels();
}

int difference(const uint8_t* pixel, const Vec3& color) {
  int largest = 0;
  for (int c = 0; c < 3; ++c) {
    largest = std::max(largest, std::abs(pixel[c] - static_cast<int>(std::lround(color[c] * 255))));
  }
  return largest;
}

int difference(const uint8_t* a, const uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

int count_different(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) count += difference(a.pixel(x, y), b.pixel(x, y)) > 8;
  }
  return count;
}

}  // namespace ballpit
