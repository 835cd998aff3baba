// SPDX-License-Identifier: MIT
// Order of attempts: the CUDA device's EGL device, EGL devices without EGL_MESA_device_software, EGL's software device,
// Mesa's surfaceless platform. EGL's default display needs a display server, so it is not tried.
#include "render/gl_context.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include "core/error.h"

namespace ballpit {

namespace {

constexpr EGLint kEglRendererExt = 0x335F;  // EGL_EXT_device_query_name, newer than libepoxy 1.5.10

std::string egl_error(const std::string& call) {
  constexpr const char* kNames[] = {"EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",        "EGL_BAD_ALLOC",
                                    "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",        "EGL_BAD_CONTEXT",
                                    "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",       "EGL_BAD_MATCH",
                                    "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW", "EGL_BAD_PARAMETER"};
  const EGLint code = eglGetError(), k = code - EGL_NOT_INITIALIZED;
  if (k >= 0 && k < std::ssize(kNames)) return fmt::format("{}: {}", call, kNames[k]);
  return fmt::format("{}: EGL error {}", call, code);
}

std::vector<EGLDeviceEXT> egl_devices() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base") &&
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
    return {};
  }
  EGLint count = 0;
  if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return {};
  std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
  if (!eglQueryDevicesEXT(count, devices.data(), &count)) return {};
  devices.resize(static_cast<size_t>(count));
  return devices;
}

bool has_word(const std::string& words, const std::string& word) {
  return (" " + words + " ").find(" " + word + " ") != std::string::npos;
}

EglDeviceInfo describe(EGLDeviceEXT device, int index) {
  EglDeviceInfo info;
  info.index = index;
  const char* text = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  const std::string extensions = text ? text : "";
  info.software = has_word(extensions, "EGL_MESA_device_software");
  info.name = info.software ? "software" : "graphics device";
  if (has_word(extensions, "EGL_EXT_device_query_name")) {
    if (const char* name = eglQueryDeviceStringEXT(device, kEglRendererExt)) info.name = name;
  } else if (has_word(extensions, "EGL_EXT_device_drm")) {
    if (const char* file = eglQueryDeviceStringEXT(device, EGL_DRM_DEVICE_FILE_EXT)) info.name = file;
  }
  EGLAttrib ordinal = -1;
  if (has_word(extensions, "EGL_NV_device_cuda") && eglQueryDeviceAttribEXT(device, EGL_CUDA_DEVICE_NV, &ordinal)) {
    info.cuda_device = static_cast<int>(ordinal);
  }
  return info;
}

/// A display that may work.
struct Candidate {
  std::string platform;
  EGLDisplay display;
};

std::vector<Candidate> candidates(int cuda_device) {
  std::vector<Candidate> result;
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) return result;
  const std::vector<EGLDeviceEXT> devices = egl_devices();
  std::vector<EglDeviceInfo> infos = list_egl_devices();
  const auto rank = [cuda_device](const EglDeviceInfo& info) {
    if (cuda_device >= 0 && info.cuda_device == cuda_device) return 0;
    return info.software ? 2 : 1;
  };
  std::stable_sort(infos.begin(), infos.end(),
                   [&](const EglDeviceInfo& a, const EglDeviceInfo& b) { return rank(a) < rank(b); });
  for (const EglDeviceInfo& info : infos) {
    const auto device = devices.at(static_cast<size_t>(info.index));
    result.push_back(
        {fmt::format("EGL device {}", info.index), eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr)});
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    result.push_back(
        {"EGL surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
  }
  return result;
}

/// `reports_reset`: whether glGetGraphicsResetStatus() reports a reset of the device, which some drivers do not support.
EGLContext create_context(EGLDisplay display, EGLConfig config, bool reports_reset) {
  std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5};
  const auto add = [&](EGLint name, EGLint value) { attributes.insert(attributes.end(), {name, value}); };
  add(EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT);
  add(EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE);
  if (reports_reset) add(EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET);
  attributes.push_back(EGL_NONE);
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

/// Makes a context current and returns it; or returns EGL_NO_CONTEXT and the reason.
EGLContext try_context(EGLDisplay display, std::string& reason) {
  const auto fail = [&reason](std::string why) {
    reason = std::move(why);
    return EGL_NO_CONTEXT;
  };
  if (display == EGL_NO_DISPLAY) return fail(egl_error("eglGetPlatformDisplay"));
  if (!eglInitialize(display, nullptr, nullptr)) return fail(egl_error("eglInitialize"));
  if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) {
    return fail("no EGL_KHR_surfaceless_context");
  }
  if (!eglBindAPI(EGL_OPENGL_API)) return fail(egl_error("eglBindAPI(EGL_OPENGL_API)"));
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count < 1) {
    return fail(egl_error("eglChooseConfig for OpenGL"));
  }
  EGLContext context = create_context(display, config, true);
  if (context == EGL_NO_CONTEXT) context = create_context(display, config, false);
  if (context == EGL_NO_CONTEXT) return fail(egl_error("eglCreateContext for OpenGL 4.5 core"));
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    reason = egl_error("eglMakeCurrent");
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
  }
  return context;
}

/// Describes the context that is current in this thread.
GlInfo current_gl_info(const std::string& platform) {
  const auto text_of = [](GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return std::string(text ? text : "unknown");
  };
  return {text_of(GL_RENDERER), text_of(GL_VERSION), platform, draws_in_software()};
}

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

std::string trouble_with(const GlLibrary& library) {
  const auto close = [](void* handle) { ::dlclose(handle); };
  const std::unique_ptr<void, decltype(close)> handle(::dlopen(library.file, RTLD_LAZY | RTLD_LOCAL));
  std::string trouble;
  if (!handle) {
    const char* const reason = ::dlerror();
    trouble = fmt::format("cannot load {} ({})", library.file, reason ? reason : "unknown");
  } else if (!::dlsym(handle.get(), library.function)) {
    trouble = fmt::format("{} has no {}()", library.file, library.function);
  }
  return trouble.empty() ? "" : fmt::format("{}; on Debian, the package {} has it", trouble, library.package);
}

std::vector<EglDeviceInfo> list_egl_devices() {
  if (!trouble_with(kEglLibrary).empty()) return {};
  std::vector<EglDeviceInfo> infos;
  for (EGLDeviceEXT device : egl_devices()) infos.push_back(describe(device, static_cast<int>(infos.size())));
  return infos;
}

GlContext::GlContext(int cuda_device) {
  for (const GlLibrary& library : {kEglLibrary, kGlLibrary}) {
    const std::string trouble = trouble_with(library);
    if (!trouble.empty()) throw RunError("OpenGL", "no OpenGL 4.5 context: " + trouble);
  }
  std::vector<std::string> failures;
  for (const Candidate& candidate : candidates(cuda_device)) {
    std::string reason;
    context_ = try_context(candidate.display, reason);
    if (context_ != EGL_NO_CONTEXT) {
      display_ = candidate.display;
      info_ = current_gl_info(candidate.platform);
      enable_gl_debug();
      return;
    }
    failures.push_back(fmt::format("{} ({})", candidate.platform, reason));
  }
  if (failures.empty()) failures.push_back("EGL offers neither devices nor the surfaceless platform");
  throw RunError("OpenGL", "no OpenGL 4.5 context without a display: " + join(failures),
                 "on Debian, libegl1, libegl-mesa0 and libgl1-mesa-dri give one in software");
}

GlContext::~GlContext() {
  if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

bool draws_in_software() {
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = text ? text : "";
  return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos ||
         renderer.find("SWR") != renderer.npos;
}

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
