// SPDX-License-Identifier: MIT
#include "render/body_buffer.h"

#include <atomic>
#include <cassert>

#include "core/error.h"

namespace ballpit {

namespace {

constexpr GLuint kPosition = 0, kRadius = 1, kMark = 2, kOccluder = 3;  // attributes of the vertex shaders;
                                                                        // those of the occluders from 3 on
constexpr GLuint kVectors = sizeof(Occluders) / sizeof(Vec4);
static_assert(sizeof(Occluders) == 80, "the shaders read them from memory");

/// A new buffer of fixed size; at least one byte, since OpenGL has no empty buffers.
GlBuffer make_buffer(int64_t bytes) {
  GlBuffer buffer;
  glNamedBufferStorage(buffer.name(), std::max<int64_t>(bytes, 1), nullptr, GL_DYNAMIC_STORAGE_BIT | GL_MAP_WRITE_BIT);
  return buffer;
}

template <class T>
void fill(const GlBuffer& buffer, const std::vector<T>& values) {
  if (values.empty()) return;
  glNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data());
}

constexpr float kPoint = 1.5f;  // [pixel] below this radius, a point shows a sphere as well

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
  for (GLuint k = 0; k < kVectors; ++k) {
    glVertexArrayAttribFormat(array, kOccluder + k, 4, GL_FLOAT, GL_FALSE, k * GLuint(sizeof(Vec4)));
    glVertexArrayAttribBinding(array, kOccluder + k, kOccluder);
  }
  glEnableVertexArrayAttrib(array, kPosition);
  glEnableVertexArrayAttrib(array, kMark);
  attach_buffers();
}

bool BodyBuffer::fits(const BodyShape& shape, bool with_occluders) const {
  return shape.count <= capacity_ && shape.dimensions == shape_.dimensions &&
         shape.has_equal_radii == shape_.has_equal_radii && (has_room_for_occluders_ || !with_occluders);
}

void BodyBuffer::resize(const BodyShape& shape, bool with_occluders) {
  const bool can_stay = fits(shape, with_occluders);
  shape_ = shape;
  has_occluders_ = with_occluders;
  if (can_stay) return;
  has_room_for_occluders_ = with_occluders;
  capacity_ = std::max(shape.count, capacity_);
  attach_buffers();
}

void BodyBuffer::attach_buffers() {
  static std::atomic<int> generations = 0;
  generation_ = ++generations;
  position_ = make_buffer(capacity_ * shape_.dimensions * 4);
  radius_ = make_buffer(shape_.has_equal_radii ? 0 : capacity_ * 4);
  mark_ = make_buffer(capacity_);
  occluder_ = make_buffer(has_room_for_occluders_ ? capacity_ * int64_t(sizeof(Occluders)) : 0);
  const GLuint array = vertex_array_.name();
  glVertexArrayAttribFormat(array, kPosition, shape_.dimensions, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayVertexBuffer(array, kPosition, position_.name(), 0, shape_.dimensions * 4);
  glVertexArrayVertexBuffer(array, kRadius, radius_.name(), 0, 4);
  glVertexArrayVertexBuffer(array, kMark, mark_.name(), 0, 1);
  glVertexArrayVertexBuffer(array, kOccluder, occluder_.name(), 0, sizeof(Occluders));
  if (shape_.has_equal_radii) {
    glDisableVertexArrayAttrib(array, kRadius);
  } else {
    glEnableVertexArrayAttrib(array, kRadius);
  }
  for (GLuint k = kOccluder; k < kOccluder + kVectors; ++k) {
    (has_room_for_occluders_ ? glEnableVertexArrayAttrib : glDisableVertexArrayAttrib)(array, k);
  }
}

void BodyBuffer::upload(const BodySnapshot& bodies) {
  const bool equal_radii = bodies.radius.size() == 1;
  assert(static_cast<int64_t>(bodies.position.size()) == bodies.count * bodies.dimensions);
  assert(equal_radii || static_cast<int64_t>(bodies.radius.size()) == bodies.count);
  const float largest = bodies.radius.empty() ? 0 : *std::max_element(bodies.radius.begin(), bodies.radius.end());
  const bool with_occluders = !bodies.occluders.empty();
  resize({bodies.count, bodies.dimensions, equal_radii, largest}, with_occluders);
  fill(position_, bodies.position);
  if (!equal_radii) fill(radius_, bodies.radius);
  if (with_occluders) fill(occluder_, bodies.occluders);
}

void BodyBuffer::map(const std::function<void(const BodyTarget&)>& write) {
  struct Unmap {
    const BodyBuffer& all;
    ~Unmap() {
      for (const GlBuffer* buffer : {&all.position_, &all.radius_, &all.mark_, &all.occluder_}) {
        glUnmapNamedBuffer(buffer->name());
      }
    }
  };
  const Unmap unmap{*this};
  const auto memory_of = [&](const GlBuffer& buffer, int64_t bytes) {
    void* const memory = glMapNamedBufferRange(buffer.name(), 0, std::max<int64_t>(bytes, 1),
                                               GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (!memory) throw RunError("OpenGL", "cannot map its buffer of bodies into memory");
    return memory;
  };
  const int64_t n = shape_.count, radii = shape_.has_equal_radii ? 0 : n, occluders = has_occluders_ ? n : 0;
  write({{static_cast<float*>(memory_of(position_, n * shape_.dimensions * 4)), n * shape_.dimensions},
         {static_cast<float*>(memory_of(radius_, radii * 4)), radii},
         {static_cast<uint8_t*>(memory_of(mark_, n)), n},
         {static_cast<Occluders*>(memory_of(occluder_, occluders * int64_t(sizeof(Occluders)))), occluders}});
}

SmallSpheres BodyBuffer::read() const {
  const auto read = [](const GlBuffer& buffer, std::vector<float>& values, int64_t count) {
    values.resize(static_cast<size_t>(count));
    glGetNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(count * 4), values.data());
  };
  SmallSpheres spheres;
  read(position_, spheres.position, shape_.count * shape_.dimensions);
  if (shape_.has_equal_radii) return {std::move(spheres.position), {shape_.radius}};
  read(radius_, spheres.radius, shape_.count);
  return spheres;
}

void BodyBuffer::set_marks(const std::vector<Mark>& marks) {
  assert(static_cast<int64_t>(marks.size()) == shape_.count);
  fill(mark_, marks);
}

void BodyBuffer::bind(GLuint divisor) const {
  for (GLuint attribute : {kPosition, kRadius, kMark, kOccluder}) {
    glVertexArrayBindingDivisor(vertex_array_.name(), attribute, divisor);
  }
  glBindVertexArray(vertex_array_.name());
  // The value of a disabled array belongs to the context's state, not to the vertex array's.
  if (shape_.has_equal_radii) glVertexAttrib1f(kRadius, shape_.radius);
}

float nearest_radius(const BodyBuffer& bodies, const FrameView& view, int height) {
  const Camera& camera = view.camera;
  const Vec3 nearest = glm::clamp(camera.eye, view.domain.min, view.domain.max);
  const float distance = std::max(length(nearest - camera.eye), camera.near);
  return bodies.max_radius() / camera.pixel_size(distance, height);
}

void draw_quads(const Shader& shader, const BodyBuffer& bodies, bool writes_depth) {
  shader.use();
  bodies.bind(1);
  glDepthMask(writes_depth ? GL_TRUE : GL_FALSE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(bodies.count()));
  glDepthMask(GL_TRUE);
}

void BodyRenderer::draw(const BodyBuffer& bodies, const FrameView& view, int height) {
  if (view.domain.is_planar()) {
    draw_quads(disc_, bodies, false);
  } else if (nearest_radius(bodies, view, height) < kPoint) {
    point_.use();
    bodies.bind(0);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(bodies.count()));
  } else {
    draw_quads(shadow_, bodies, false);
    draw_quads(sphere_, bodies, true);
    draw_quads(outline_, bodies, false);
  }
}

}  // namespace ballpit
