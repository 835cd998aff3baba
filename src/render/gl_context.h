// SPDX-License-Identifier: MIT
// An OpenGL 4.5 core context without a window, by EGL: on a graphics device where there is one, else in
// software. Also what `ballpit doctor` tells about both.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/gl_debug.h"

namespace ballpit {

/// What draws.
struct GlInfo {
  std::string renderer;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version;   ///< "4.5 (Core Profile) Mesa 22.3.6"
  std::string platform;  ///< where the context comes from: "EGL device 0", "EGL surfaceless"
  bool software = false;
};

/// Of the context that is current in this thread.
GlInfo current_gl_info(std::string platform);

struct EglDeviceInfo {
  int index = 0;
  std::string name;  ///< the driver's name for it, or its device file
  bool software = false;
  int cuda_device = -1;  ///< CUDA's ordinal of it, −1 where it has none
};

/// All EGL devices in the driver's order; empty where EGL is missing or cannot enumerate them.
std::vector<EglDeviceInfo> list_egl_devices();

/// Current in the thread that made it, until it is destroyed.
class GlContext {
 public:
  /// Prefers the device with that CUDA ordinal if one is given, then any graphics device, then software.
  /// Throws RunError with the library that is missing, or with what failed for each device tried.
  explicit GlContext(int cuda_device = -1);
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  ~GlContext();

  /// For programs with more than one context, or to move this one to another thread (release it there first).
  void make_current();
  void release();

  const GlInfo& info() const { return info_; }

 private:
  void* display_ = nullptr;  ///< EGLDisplay: the process's, never terminated, since contexts share it
  void* context_ = nullptr;  ///< EGLContext
  GlInfo info_;
  std::unique_ptr<GlDebug> debug_;
};

}  // namespace ballpit
