// SPDX-License-Identifier: MIT
// Has a world write its bodies where the vertex shader reads them, so that none of them passes through an inspection. By the
// processor that steps them: the CPU into mapped buffers, CUDA into OpenGL's own memory.
#pragma once

#include <memory>
#include <string>

#include "render/body_buffer.h"

namespace ballpit {

class World;

class BodyWriter {
 public:
  virtual ~BodyWriter() = default;

  /// Places, radii and contact marks of the present state. False where this cannot be, from then on: trouble() says why,
  /// and an inspection has to be uploaded.
  virtual bool write(World& world, BodyBuffer& buffer) = 0;

  virtual std::string trouble() const { return ""; }

  /// Lets go of the buffers of the last write: to be called before others resize them.
  virtual void release() {}
};

/// For worlds on a GPU, by CUDA's OpenGL interoperability: buffers are registered where they are new. Tries once whether that
/// is possible: OpenGL may draw in software, or on another device. Defined by the CUDA library, or its stub.
std::unique_ptr<BodyWriter> make_cuda_body_writer();

}  // namespace ballpit
