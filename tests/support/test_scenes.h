// SPDX-License-Identifier: MIT
// States to draw in tests, made without a simulation.
#pragma once

#include <string>
#include <vector>

#include "export/picture_compare.h"
#include "render/frame_view.h"
#include "render/image.h"
#include "render/renderer.h"

namespace ballpit {

struct Sphere {
  Vec3 center;
  float radius;
};

/// With all contacts, and a grid of cells of the given edge unless that is 0.
Inspection inspect(const std::vector<Sphere>& spheres, const DomainBox& domain, float cell_edge = 0);

/// Fills in what the broad phase would hand on: pairs of neighbouring cells, or all pairs if there is no grid. Contacts
/// that are not among them become missed ones.
void add_candidates(Inspection& inspection);

/// As sort-and-sweep along this axis.
void add_endpoints(Inspection& inspection, int axis);

/// All spheres turn around the domain's middle, once in 2π seconds.
void add_velocities(Inspection& inspection, const DomainBox& domain);

/// "x,y,z,radius" under a header, one sphere a line.
std::vector<Sphere> read_spheres(const std::string& path);

/// The whole domain, above the room that these overlays need.
FrameView view_of(const Inspection& inspection, const DomainBox& domain, float aspect,
                  std::vector<std::string> overlays = {});

/// In a context of its own.
Image draw(const FrameView& view, int width, int height, const RenderOptions& options = {});

/// The largest difference of a colour channel, of 255.
int difference(const uint8_t* pixel, const Vec3& color);

/// Pixels that differ by more than 8/255 between two pictures of the same size.
int count_different(const Image& a, const Image& b);

}  // namespace ballpit
