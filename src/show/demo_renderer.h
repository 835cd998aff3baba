// SPDX-License-Identifier: MIT
// Draws a demonstration, in a window or without: the world writes its bodies into the renderer's buffer, the rest comes from
// what the view wants of an inspection.
#pragma once

#include <memory>
#include <string>

#include "render/body_writer.h"
#include "render/renderer.h"
#include "show/demo.h"

namespace ballpit {

class DemoRenderer {
 public:
  /// As Renderer.
  DemoRenderer(int width, int height, const RenderOptions& options);

  /// The present state and view, in the view's theme. Where a GPU cannot share its memory with OpenGL, the demonstration's
  /// message says so once, and copies are drawn.
  void draw(Demo& demo, RenderOptions options);

  /// From now on the bodies are copied to the host and uploaded, as where a GPU cannot share its memory with OpenGL.
  void copy_bodies() { copies_ = true; }

  Renderer& renderer() { return renderer_; }

  /// How bodies got into the picture: "written by cuda", "written by cpu", "copied: " and why, "copied" where this was asked for.
  const std::string& path() const { return path_; }

 private:
  bool write(Demo& demo);

  Renderer renderer_;
  std::unique_ptr<BodyWriter> by_cuda_, by_cpu_;
  std::string path_;
  bool copies_ = false;
};

}  // namespace ballpit
