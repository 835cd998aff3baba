// SPDX-License-Identifier: MIT
// Bodies of planar scenes: flat discs with an outline, as on a board. Later bodies lie over earlier ones.
// Sibling: sphere_renderer.h for spatial scenes.
#pragma once

#include "render/body_buffer.h"
#include "render/shader.h"

namespace ballpit {

class DiscRenderer {
 public:
  DiscRenderer();
  void draw(const BodyBuffer& bodies);

 private:
  Shader shader_;
};

}  // namespace ballpit
