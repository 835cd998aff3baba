// SPDX-License-Identifier: MIT
// OpenGL's own account of its errors (KHR_debug). An error is a failure: it is kept and thrown at the next
// check.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace ballpit {

/// Collects error messages of the context that is current when it is made; the owner of the context owns it
/// too.
class GlDebug {
 public:
  GlDebug();
  GlDebug(const GlDebug&) = delete;
  GlDebug& operator=(const GlDebug&) = delete;
  ~GlDebug();  ///< the context must be current

  void record(std::string message);
  std::vector<std::string> take();

 private:
  std::mutex mutex_;  ///< drivers may report from their own threads
  std::vector<std::string> messages_;
};

/// Throws RunError with all errors of the current context since the last check; `doing` says what was under
/// way.
void check_gl(const std::string& doing);

}  // namespace ballpit
