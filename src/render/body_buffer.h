// SPDX-License-Identifier: MIT
// The bodies in GPU memory, in the layout of the simulation: `dimensions` floats of position per body (OpenGL reads a missing
// z as 0), one radius for all or one each, one mark each. So the processor that steps the bodies can write the buffers itself
// (body_writer.h), and a planar scene stores no third coordinate.
#pragma once

#include <cstdint>
#include <vector>

#include "bodies/body_snapshot.h"
#include "bodies/pair.h"
#include "render/gl_object.h"

namespace ballpit {

/// The colour of a body; the shaders' colours are in this order.
enum class Mark : uint8_t { none, contact };  // followed by the colours of the scale
inline constexpr int kScaleColors = 16;
inline constexpr Mark scale_mark(int step) { return static_cast<Mark>(2 + step); }

/// The mark of every body: contact for the bodies in `contacts`.
std::vector<Mark> contact_marks(int64_t count, const std::vector<Pair>& contacts);

class BodyBuffer {
 public:
  /// What a call of the vertex shader gets: a corner of a body's quad, or a body.
  enum class Rate { body_per_instance, body_per_vertex };

  BodyBuffer();

  /// Makes room for bodies of this shape. If they do not fit, the buffers are replaced, and generation() changes.
  void resize(const BodyShape& shape);
  bool fits(const BodyShape& shape) const;

  /// resize() and copy from the host.
  void upload(const BodySnapshot& bodies);

  /// Calls write(target) with the buffers mapped into the host's memory. Call resize() before. Throws RunError if they cannot
  /// be mapped.
  template <class Write>
  void map(Write&& write) {
    struct Unmap {
      BodyBuffer& buffer;
      ~Unmap() { buffer.end_map(); }
    };
    const Unmap unmap{*this};
    write(begin_map());
  }
  void set_marks(const std::vector<Mark>& marks);

  /// Makes this the source of vertex attributes 0 (position), 1 (radius) and 2 (mark).
  void bind(Rate rate) const;

  int64_t count() const { return shape_.count; }
  int dimensions() const { return shape_.dimensions; }
  float max_radius() const { return shape_.radius; }  ///< [m]

  GLuint position_buffer() const { return position_.name(); }
  GLuint radius_buffer() const { return radius_.name(); }  ///< used if radii differ
  GLuint mark_buffer() const { return mark_.name(); }
  int generation() const { return generation_; }  ///< identifies its buffers; no other BodyBuffer has the same

 private:
  void attach_buffers();
  BodyTarget begin_map();
  void end_map();

  GlVertexArray vertex_array_;
  GlBuffer position_;
  GlBuffer radius_;
  GlBuffer mark_;
  BodyShape shape_;
  int64_t capacity_ = 0;
  int generation_ = 0;
};

}  // namespace ballpit
