// SPDX-License-Identifier: MIT
#include "render/gl_debug.h"

#include <iterator>
#include <vector>

#include <epoxy/gl.h>

#include "core/error.h"

namespace ballpit {

namespace {

const char* error_name(GLenum error) {
  constexpr const char* kNames[] = {"GL_INVALID_ENUM",
                                    "GL_INVALID_VALUE",
                                    "GL_INVALID_OPERATION",
                                    "GL_STACK_OVERFLOW",
                                    "GL_STACK_UNDERFLOW",
                                    "GL_OUT_OF_MEMORY",
                                    "GL_INVALID_FRAMEBUFFER_OPERATION",
                                    "GL_CONTEXT_LOST"};
  const GLenum k = error - GL_INVALID_ENUM;
  return k < std::size(kNames) ? kNames[k] : "an unknown error";
}

}  // namespace

void enable_gl_debug() {
  glEnable(GL_DEBUG_OUTPUT);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_HIGH, 0, nullptr, GL_TRUE);
}

void check_gl(const std::string& doing) {
  if (glGetGraphicsResetStatus() != GL_NO_ERROR) {
    throw RunError(doing, "the OpenGL context is lost, since the driver has reset the graphics device", "start again");
  }
  std::vector<std::string> errors;
  // A lost context reports errors without end.
  for (GLenum error = glGetError(); error != GL_NO_ERROR && errors.size() < 8; error = glGetError()) {
    errors.push_back(error_name(error));
  }
  std::string message(8192, '\0');
  GLsizei length = 0;  // with the zero at the end
  while (glGetDebugMessageLog(1, static_cast<GLsizei>(message.size()), nullptr, nullptr, nullptr, nullptr, &length,
                              message.data()) == 1) {
    errors.push_back(message.substr(0, static_cast<size_t>(length > 0 ? length - 1 : 0)));
  }
  if (!errors.empty()) throw RunError(doing, "OpenGL reports " + join(errors, "; "));
}

}  // namespace ballpit
