// SPDX-License-Identifier: MIT
// OpenGL's libraries, which libepoxy, GLFW and Dear ImGui open while the program runs. libepoxy ends the program where
// one is missing, so that this has to be known before its first call.
#pragma once

#include <string>

namespace ballpit {

/// A library that is opened by name, a function of it, and the Debian package that it comes with.
struct GlLibrary {
  const char* file;
  const char* function;
  const char* package;
};

inline constexpr GlLibrary kEglLibrary{"libEGL.so.1", "eglGetProcAddress", "libegl1"};  // contexts without a display
inline constexpr GlLibrary kGlLibrary{"libGL.so.1", "glGetString", "libgl1"};           // OpenGL itself, and GLX

/// Why it cannot be used, and the package's name; empty where it can.
std::string trouble_with(const GlLibrary& library);

}  // namespace ballpit
