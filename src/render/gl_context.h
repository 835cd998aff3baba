// SPDX-License-Identifier: MIT
// An OpenGL 4.5 core context without a window, by EGL: on a graphics device if there is one, else in software. Also
// gives `ballpit doctor` the devices and drivers, and turns the errors that OpenGL reports (KHR_debug) into exceptions.
#pragma once

#include <string>
#include <vector>

namespace ballpit {

/// A library of OpenGL that libepoxy, GLFW and Dear ImGui open by name while the program runs, a function in it, and its
/// Debian package. libepoxy ends the program if one is missing, so check with trouble_with() before its first call.
struct GlLibrary {
  const char *file, *function, *package;
};

inline constexpr GlLibrary kEglLibrary{"libEGL.so.1", "eglGetProcAddress", "libegl1"};  // contexts without a display
inline constexpr GlLibrary kGlLibrary{"libGL.so.1", "glGetString", "libgl1"};           // OpenGL itself, and GLX

/// Why the library cannot be used, and the package's name; empty if it can.
std::string trouble_with(const GlLibrary& library);

/// The implementation that draws.
struct GlInfo {
  std::string renderer;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version;   ///< "4.5 (Core Profile) Mesa 22.3.6"
  std::string platform;  ///< of the context: "EGL device 0", "EGL surfaceless"
  bool software = false;
};

struct EglDeviceInfo {
  int index = 0;
  std::string name;  ///< from the driver, or the device file
  bool software = false;
  int cuda_device = -1;  ///< its ordinal in CUDA, −1 if it has none
};

/// All EGL devices in the driver's order; empty if EGL is missing or cannot enumerate them.
std::vector<EglDeviceInfo> list_egl_devices();

/// The context is current in the thread that makes it, until it is destroyed.
class GlContext {
 public:
  /// Prefers the device with the given CUDA ordinal, then any graphics device, then software. Throws RunError with the
  /// library that is missing, or with the reason for each device that failed.
  explicit GlContext(int cuda_device = -1);
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  ~GlContext();

  const GlInfo& info() const { return info_; }

 private:
  void* display_ = nullptr;  ///< EGLDisplay; never terminated, since all contexts of the process share it
  void* context_ = nullptr;  ///< EGLContext
  GlInfo info_;
};

/// Whether the current context draws on the processor.
bool draws_in_software();

/// Makes the current context keep messages about errors for check_gl().
void enable_gl_debug();

/// Throws RunError with all errors of the current context since the last check; `doing` names the operation.
void check_gl(const std::string& doing);

}  // namespace ballpit
