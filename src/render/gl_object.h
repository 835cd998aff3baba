// SPDX-License-Identifier: MIT
// OpenGL names with owners: each is made with its object, deleted with it, moved but never copied.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace ballpit {

/// `create(1, &name)` makes a name, `destroy(1, &name)` deletes it.
template <auto& create, auto& destroy>
class GlObject {
 public:
  GlObject() { create(1, &name_); }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) destroy(1, &name_);
  }

  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

inline void create_texture(GLsizei count, GLuint* names) { glCreateTextures(GL_TEXTURE_2D, count, names); }
inline void create_program(GLsizei, GLuint* name) { *name = glCreateProgram(); }
inline void delete_program(GLsizei, const GLuint* name) { glDeleteProgram(*name); }

using GlBuffer = GlObject<glCreateBuffers, glDeleteBuffers>;
using GlVertexArray = GlObject<glCreateVertexArrays, glDeleteVertexArrays>;
using GlFramebuffer = GlObject<glCreateFramebuffers, glDeleteFramebuffers>;
using GlTexture = GlObject<create_texture, glDeleteTextures>;
using GlProgram = GlObject<create_program, delete_program>;

}  // namespace ballpit
