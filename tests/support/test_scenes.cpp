// SPDX-License-Identifier: MIT
#include "tests/support/test_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "core/file.h"
#include "render/gl_context.h"
#include "render/overlays/overlay.h"

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

void add_candidates(Inspection& inspection) {
  const BodySnapshot& bodies = inspection.bodies;
  const auto cell_of = [&](int32_t i) {
    const GridInspection& grid = inspection.grids[0];
    return IVec3(glm::floor((bodies.position_of(i) - grid.origin) / grid.edge));
  };
  const auto are_near = [&](int32_t i, int32_t j) {
    if (inspection.grids.empty()) return true;
    const IVec3 apart = glm::abs(cell_of(i) - cell_of(j));
    return std::max({apart.x, apart.y, apart.z}) <= 1;
  };
  const auto count = static_cast<int32_t>(bodies.count);
  for (int32_t i = 0; i < count; ++i) {
    for (int32_t j = i + 1; j < count; ++j) {
      if (are_near(i, j)) inspection.candidates.push_back({i, j});
    }
  }
  const auto is_missed = [&](const Pair& pair) { return !are_near(pair.i, pair.j); };
  std::vector<Pair>& contacts = inspection.contacts;
  std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(inspection.missed), is_missed);
  contacts.erase(std::remove_if(contacts.begin(), contacts.end(), is_missed), contacts.end());
}

void add_endpoints(Inspection& inspection, int axis) {
  inspection.axis = axis;
  for (int32_t i = 0; i < static_cast<int32_t>(inspection.bodies.count); ++i) {
    const float x = inspection.bodies.position_of(i)[axis], r = inspection.bodies.radius_of(i);
    inspection.endpoints.push_back({x - r, i, false});
    inspection.endpoints.push_back({x + r, i, true});
  }
  std::stable_sort(inspection.endpoints.begin(), inspection.endpoints.end(),
                   [](const Endpoint& a, const Endpoint& b) { return a.at < b.at; });
}

void add_velocities(Inspection& inspection, const DomainBox& domain) {
  BodySnapshot& bodies = inspection.bodies;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 arm = bodies.position_of(i) - (domain.min + domain.max) / 2.0f;
    const Vec3 velocity = domain.is_planar() ? Vec3(-arm.y, arm.x, 0) : Vec3(arm.z, 0, -arm.x);
    for (int axis = 0; axis < bodies.dimensions; ++axis) bodies.velocity.push_back(velocity[axis]);
  }
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
  const Camera camera =
      leave_room_below(frame_box(domain.min, domain.max, domain.dimensions, aspect), room_below(overlays, inspection));
  return {inspection, domain, camera, std::move(overlays)};
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

int count_different(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) count += difference(a.pixel(x, y), b.pixel(x, y)) > 8;
  }
  return count;
}

}  // namespace ballpit
