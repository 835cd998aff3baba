// SPDX-License-Identifier: MIT
#include "render/gl_library.h"

#include <memory>

#include <dlfcn.h>

namespace ballpit {

namespace {

struct Close {
  void operator()(void* handle) const { ::dlclose(handle); }
};

std::string dl_reason() {
  const char* reason = ::dlerror();
  return reason ? reason : "unknown";
}

}  // namespace

std::string trouble_with(const GlLibrary& library) {
  const std::string hint = std::string("; on Debian, the package ") + library.package + " has it";
  const std::unique_ptr<void, Close> handle(::dlopen(library.file, RTLD_LAZY | RTLD_LOCAL));
  if (!handle) return std::string("cannot load ") + library.file + " (" + dl_reason() + ")" + hint;
  if (!::dlsym(handle.get(), library.function)) {
    return std::string(library.file) + " has no " + library.function + "()" + hint;
  }
  return "";
}

}  // namespace ballpit
