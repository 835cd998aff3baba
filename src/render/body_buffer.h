// SPDX-License-Identifier: MIT
// The bodies in GPU memory, exactly as the simulation has them: `dimensions` floats of position a body
// (OpenGL reads a missing z as 0), one radius for all or one each, one mark each. Nothing is copied into
// another layout, so that a device that computes can write position_buffer() itself, and a planar scene
// stores no third coordinate.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_object.h"
#include "simulate/inspection.h"

namespace ballpit {

/// How a body is shown; the shaders' colours are in this order.
enum class Mark : uint8_t { none, contact };  // and then the scale's colours
inline constexpr int kScaleColors = 16;
inline constexpr Mark scale_mark(int step) { return static_cast<Mark>(2 + step); }

/// The mark of every body: contact for those in a pair of `contacts`.
std::vector<Mark> contact_marks(int64_t count, const std::vector<Pair>& contacts);

class BodyBuffer {
 public:
  /// What one vertex shader call gets: one corner of one body's quad, or one body.
  enum class Rate { body_per_instance, body_per_vertex };

  BodyBuffer();

  /// Room for `count` bodies; buffers are replaced only when they must grow or change shape (see
  /// generation()).
  void resize(int64_t count, int dimensions, bool equal_radii);

  /// resize() and copy from the host.
  void upload(const BodySnapshot& bodies);
  void set_marks(const std::vector<Mark>& marks);

  /// Makes this the source of vertex attributes 0 (position), 1 (radius) and 2 (mark).
  void bind(Rate rate) const;

  int64_t count() const { return count_; }
  int dimensions() const { return dimensions_; }
  float max_radius() const { return max_radius_; }  ///< [m] of the last upload

  GLuint position_buffer() const { return position_.name(); }
  GLuint radius_buffer() const { return radius_.name(); }
  int generation() const { return generation_; }  ///< changes with the buffers' names

 private:
  void attach_buffers();

  GlVertexArray vertex_array_;
  GlBuffer position_;
  GlBuffer radius_;
  GlBuffer mark_;
  int64_t count_ = 0;
  int64_t capacity_ = 0;
  int dimensions_ = 3;
  bool equal_radii_ = true;
  float equal_radius_ = 0.0f;
  float max_radius_ = 0.0f;
  int generation_ = 0;
};

}  // namespace ballpit
