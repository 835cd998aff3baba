// SPDX-License-Identifier: MIT
#include "render/gl_debug.h"

#include <utility>

#include <epoxy/gl.h>

#include "core/error.h"

namespace ballpit {

namespace {

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                           const void* user) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  // The callback's user pointer is const by OpenGL's signature only; it is the GlDebug that installed it.
  static_cast<GlDebug*>(const_cast<void*>(user))->record({text, static_cast<size_t>(length)});
}

/// The GlDebug of the current context, or null if it has none.
GlDebug* installed_debug() {
  void* function = nullptr;
  void* user = nullptr;
  glGetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &function);
  glGetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &user);
  return function == reinterpret_cast<void*>(&on_message) ? static_cast<GlDebug*>(user) : nullptr;
}

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return "an unknown error";
  }
}

}  // namespace

GlDebug::GlDebug() {
  glEnable(GL_DEBUG_OUTPUT);
  glDebugMessageCallback(on_message, this);
}

GlDebug::~GlDebug() { glDebugMessageCallback(nullptr, nullptr); }

void GlDebug::record(std::string message) {
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::move(message));
}

std::vector<std::string> GlDebug::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(messages_, {});
}

void check_gl(const std::string& doing) {
  if (glGetGraphicsResetStatus() != GL_NO_ERROR) {
    throw RunError(doing, "the OpenGL context is lost, since the driver has reset the graphics device", "start again");
  }
  std::vector<std::string> errors;
  // A lost context reports an error for ever.
  for (GLenum error = glGetError(); error != GL_NO_ERROR && errors.size() < 8; error = glGetError()) {
    errors.push_back(error_name(error));
  }
  if (GlDebug* debug = installed_debug()) {
    std::vector<std::string> messages = debug->take();
    errors.insert(errors.end(), messages.begin(), messages.end());
  }
  if (!errors.empty()) throw RunError(doing, "OpenGL reports " + join(errors, "; "));
}

}  // namespace ballpit
