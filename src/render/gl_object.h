// SPDX-License-Identifier: MIT
// OpenGL names with owners: made with the object, deleted with it, moved but never copied.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace ballpit {

/// `Kind` knows how to create and destroy one name.
template <class Kind>
class GlObject {
 public:
  GlObject() : name_(Kind::create()) {}
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) Kind::destroy(name_);
  }

  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

struct BufferKind {
  static GLuint create() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};

struct VertexArrayKind {
  static GLuint create() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};

struct FramebufferKind {
  static GLuint create() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};

struct TextureKind {
  static GLuint create() {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};

struct ProgramKind {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint name) { glDeleteProgram(name); }
};

using GlBuffer = GlObject<BufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlTexture = GlObject<TextureKind>;
using GlProgram = GlObject<ProgramKind>;

}  // namespace ballpit
