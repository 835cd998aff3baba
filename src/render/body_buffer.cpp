// SPDX-License-Identifier: MIT
#include "render/body_buffer.h"

#include <algorithm>
#include <cassert>

namespace ballpit {

namespace {

constexpr GLuint kPosition = 0;
constexpr GLuint kRadius = 1;
constexpr GLuint kMark = 2;

/// A new buffer of fixed size; at least one byte, since OpenGL has no empty ones.
GlBuffer make_buffer(int64_t bytes) {
  GlBuffer buffer;
  glNamedBufferStorage(buffer.name(), std::max<int64_t>(bytes, 1), nullptr, GL_DYNAMIC_STORAGE_BIT);
  return buffer;
}

template <class T>
void fill(const GlBuffer& buffer, const std::vector<T>& values) {
  if (values.empty()) return;
  glNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data());
}

}  // namespace

std::vector<Mark> contact_marks(int64_t count, const std::vector<Pair>& contacts) {
  std::vector<Mark> marks(static_cast<size_t>(count), Mark::none);
  for (const Pair& pair : contacts) {
    marks.at(static_cast<size_t>(pair.i)) = Mark::contact;
    marks.at(static_cast<size_t>(pair.j)) = Mark::contact;
  }
  return marks;
}

BodyBuffer::BodyBuffer() {
  const GLuint array = vertex_array_.name();
  for (GLuint attribute : {kPosition, kRadius, kMark}) glVertexArrayAttribBinding(array, attribute, attribute);
  glVertexArrayAttribFormat(array, kRadius, 1, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribIFormat(array, kMark, 1, GL_UNSIGNED_BYTE, 0);
  glEnableVertexArrayAttrib(array, kPosition);
  glEnableVertexArrayAttrib(array, kMark);
  attach_buffers();
}

void BodyBuffer::resize(int64_t count, int dimensions, bool equal_radii) {
  count_ = count;
  if (count <= capacity_ && dimensions == dimensions_ && equal_radii == equal_radii_) return;
  capacity_ = std::max(count, capacity_);
  dimensions_ = dimensions;
  equal_radii_ = equal_radii;
  attach_buffers();
}

void BodyBuffer::attach_buffers() {
  ++generation_;
  position_ = make_buffer(capacity_ * dimensions_ * 4);
  radius_ = make_buffer(equal_radii_ ? 0 : capacity_ * 4);
  mark_ = make_buffer(capacity_);
  const GLuint array = vertex_array_.name();
  glVertexArrayAttribFormat(array, kPosition, dimensions_, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayVertexBuffer(array, kPosition, position_.name(), 0, dimensions_ * 4);
  glVertexArrayVertexBuffer(array, kRadius, radius_.name(), 0, 4);
  glVertexArrayVertexBuffer(array, kMark, mark_.name(), 0, 1);
  if (equal_radii_) {
    glDisableVertexArrayAttrib(array, kRadius);
  } else {
    glEnableVertexArrayAttrib(array, kRadius);
  }
}

void BodyBuffer::upload(const BodySnapshot& bodies) {
  const bool equal_radii = bodies.radius.size() == 1;
  assert(static_cast<int64_t>(bodies.position.size()) == bodies.count * bodies.dimensions);
  assert(equal_radii || static_cast<int64_t>(bodies.radius.size()) == bodies.count);
  resize(bodies.count, bodies.dimensions, equal_radii);
  fill(position_, bodies.position);
  if (!equal_radii) fill(radius_, bodies.radius);
  if (equal_radii) equal_radius_ = bodies.radius[0];
  max_radius_ = bodies.radius.empty() ? 0.0f : *std::max_element(bodies.radius.begin(), bodies.radius.end());
}

void BodyBuffer::set_marks(const std::vector<Mark>& marks) {
  assert(static_cast<int64_t>(marks.size()) == count_);
  fill(mark_, marks);
}

void BodyBuffer::bind(Rate rate) const {
  const GLuint divisor = rate == Rate::body_per_instance ? 1 : 0;
  for (GLuint attribute : {kPosition, kRadius, kMark}) {
    glVertexArrayBindingDivisor(vertex_array_.name(), attribute, divisor);
  }
  glBindVertexArray(vertex_array_.name());
  // What a disabled array reads; part of the context's state, not of the vertex array's.
  if (equal_radii_) glVertexAttrib1f(kRadius, equal_radius_);
}

}  // namespace ballpit
