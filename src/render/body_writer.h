// SPDX-License-Identifier: MIT
// Lets a world write its bodies directly into the memory that the vertex shader reads, without an inspection. The processor
// that steps the bodies writes them: the CPU into mapped buffers, CUDA into OpenGL's own memory.
#pragma once

#include <memory>
#include <string>

#include "render/body_buffer.h"

namespace ballpit {

class World;

class BodyWriter {
 public:
  virtual ~BodyWriter() = default;

  /// Writes positions, radii and contact marks of the present state. Returns false if this is not possible, now and later:
  /// trouble() gives the reason, and the caller must upload an inspection.
  virtual bool write(World& world, BodyBuffer& buffer) = 0;

  virtual std::string trouble() const { return ""; }

  /// Releases the buffers of the last write. Call before resizing them.
  virtual void release() {}
};

/// For worlds on a GPU, by CUDA's OpenGL interoperability. It fails if OpenGL draws in software or on another device. Defined
/// by the CUDA library, or its stub.
std::unique_ptr<BodyWriter> make_cuda_body_writer();

}  // namespace ballpit
