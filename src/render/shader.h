// SPDX-License-Identifier: MIT
// Programs from the files in /shaders, which are compiled into the library.
#pragma once

#include <string>

#include "core/math.h"
#include "render/gl_object.h"

namespace ballpit {

class Shader {
 public:
  /// Names of two files in /shaders, such as "sphere.vert" and "sphere.frag". A line `#include "frame.glsl"` is replaced by
  /// that file. Throws RunError with the file's name and the driver's log.
  Shader(const std::string& vertex_file, const std::string& fragment_file);

  void use() const { glUseProgram(program_.name()); }

  void set(const char* uniform, int value) const { glProgramUniform1i(program_.name(), location(uniform), value); }
  void set(const char* uniform, float value) const { glProgramUniform1f(program_.name(), location(uniform), value); }

 private:
  GLint location(const char* uniform) const;

  std::string name_;
  GlProgram program_;
};

}  // namespace ballpit
