// SPDX-License-Identifier: MIT
// Draws a demonstration, in a window or headless. The world writes its bodies into the renderer's buffer; overlays read
// an inspection.
#pragma once

#include <memory>
#include <string>

#include "render/renderer.h"
#include "show/demo.h"

namespace ballpit {

class DemoRenderer {
 public:
  /// See Renderer.
  DemoRenderer(int width, int height, const RenderOptions& options);

  /// Draws the present state and view, or all views of a comparison, in the view's theme. If a GPU cannot share its
  /// memory with OpenGL, copies are drawn, and the demonstration's message reports this once.
  void draw(Demo& demo, RenderOptions options);

  /// From now on the bodies are copied to the host and uploaded, as if the GPU could not share its memory with OpenGL.
  void copy_bodies() { copies_ = true; }

  Renderer& renderer() { return renderer_; }

  /// How bodies got into the picture: "written by cuda", "written by cpu", "copied: REASON", or "copied" after
  /// copy_bodies().
  const std::string& path() const { return path_; }

 private:
  void draw_view(Demo& demo, float aspect, float share = 1);
  bool write(Demo& demo, bool with_occluders);

  Renderer renderer_;
  RenderOptions options_;
  std::unique_ptr<BodyWriter> by_cuda_;  // none in a program without CUDA
  std::string path_;
  bool copies_ = false;
};

}  // namespace ballpit
