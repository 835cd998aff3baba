// SPDX-License-Identifier: MIT
// The bodies in GPU memory, in the layout of the simulation: `dimensions` floats of position per body (OpenGL reads a missing
// z as 0), one radius for all or one each, one mark each. So the processor that steps the bodies can write the buffers itself
// (BodyBuffer::map(), BodyWriter), and a planar scene stores no third coordinate.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/frame_view.h"
#include "render/seen_spheres.h"
#include "render/shader.h"

namespace ballpit {

/// The colour of a body; the shaders' colours are in this order.
enum class Mark : uint8_t { none, contact };  // followed by the colours of the scale
inline constexpr int kScaleColors = 16;
inline constexpr Mark scale_mark(int step) { return static_cast<Mark>(2 + step); }

/// The mark of every body: contact for the bodies in `contacts`.
std::vector<Mark> contact_marks(int64_t count, const std::vector<Pair>& contacts);

class BodyBuffer {
 public:
  BodyBuffer();

  /// Makes room for bodies of this shape, and for their occluders. If they do not fit, the buffers are replaced, and
  /// generation() changes.
  void resize(const BodyShape& shape, bool with_occluders = false);
  bool fits(const BodyShape& shape, bool with_occluders = false) const;

  /// resize() and copy from the host.
  void upload(const BodySnapshot& bodies);

  /// Calls write(target) with the buffers mapped into the host's memory. Call resize() before. Throws RunError if they cannot
  /// be mapped.
  void map(const std::function<void(const BodyTarget&)>& write);

  void set_marks(const std::vector<Mark>& marks);

  /// A copy on the host, of spatial bodies.
  SmallSpheres read() const;

  /// Makes this the source of vertex attributes 0 (position), 1 (radius), 2 (mark) and 3 to 7 (occluders, if it has them).
  /// `divisor` 1: of a body for each instance; 0: for each vertex.
  void bind(GLuint divisor) const;

  int64_t count() const { return shape_.count; }
  float max_radius() const { return shape_.radius; }  ///< [m]
  bool has_occluders() const { return has_occluders_; }

  GLuint position_buffer() const { return position_.name(); }
  GLuint radius_buffer() const { return radius_.name(); }  ///< used if radii differ
  GLuint mark_buffer() const { return mark_.name(); }
  GLuint occluder_buffer() const { return occluder_.name(); }
  int generation() const { return generation_; }  ///< identifies its buffers; no other BodyBuffer has the same

 private:
  void attach_buffers();

  GlVertexArray vertex_array_;
  GlBuffer position_, radius_, mark_, occluder_;
  BodyShape shape_;
  int64_t capacity_ = 0;
  bool has_occluders_ = false, has_room_for_occluders_ = false;
  int generation_ = 0;
};

/// [pixel] Radius of the largest sphere if it were where the domain is nearest to the eye, in a picture of this height.
float nearest_radius(const BodyBuffer& bodies, const FrameView& view, int height);

/// Draws a quad for each body.
void draw_quads(const Shader& shader, const BodyBuffer& bodies, bool writes_depth);

/// Draws bodies without a triangle mesh. Spatial scenes: one quad for each sphere, in whose pixels the eye's ray meets
/// the sphere exactly, with exact depth. A second pass blends the pixels of the outline by how much the sphere covers
/// them, in any order. Planar scenes: flat discs with an outline; later bodies lie over earlier ones.
/// Cost: proportional to the covered pixels, twice for outlines.
/// Source: Sigg et al. 2006, "GPU-Based Ray-Casting of Quadratic Surfaces", doi 10.2312/SPBG/SPBG06/059-065.
class BodyRenderer {
 public:
  /// `height` of the picture [pixel].
  void draw(const BodyBuffer& bodies, const FrameView& view, int height);

 private:
  Shader disc_{"disc.vert", "disc.frag"};
  Shader sphere_{"sphere.vert", "sphere.frag"};
  Shader outline_{"outline.vert", "outline.frag"};
  Shader point_{"point.vert", "point.frag"};
  Shader shadow_{"shadow.vert", "shadow.frag"};  // of spheres on the floor
};

class World;

/// Lets a world on a GPU write its bodies into OpenGL's own memory, without a copy on the host.
class BodyWriter {
 public:
  virtual ~BodyWriter() = default;

  /// Writes positions, radii, contact marks and perhaps occluders of the present state. Returns false if this is not possible, now and later:
  /// trouble() gives the reason, and the caller must upload an inspection.
  virtual bool write(World& world, BodyBuffer& buffer, bool with_occluders) = 0;

  virtual std::string trouble() const = 0;

  /// Releases the buffers of the last write. Call before resizing them.
  virtual void release() = 0;
};

/// By CUDA's OpenGL interoperability. It fails if OpenGL draws in software or on another device. Defined
/// by the CUDA library, or its stub.
std::unique_ptr<BodyWriter> make_cuda_body_writer();

}  // namespace ballpit
