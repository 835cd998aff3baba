// SPDX-License-Identifier: MIT
// Maps OpenGL buffers as CUDA memory, so that the GPU that computes a step writes directly for the vertex shader.
#include <algorithm>
#include <utility>
#include <vector>

// clang-format off
#include <epoxy/gl.h>  // before any other of OpenGL's
#include <cuda_gl_interop.h>
// clang-format on

#include "bodies/body_snapshot.h"
#include "core/span.h"
#include "cuda_error.h"
#include "render/body_buffer.h"
#include "world/world.h"

namespace ballpit {

namespace {

/// Registers a buffer for CUDA. The buffer must outlive this object, unless its name is not used again.
class Registered {
 public:
  explicit Registered(GLuint buffer) {
    BALLPIT_CUDA_CHECK(cudaGraphicsGLRegisterBuffer(&resource_, buffer, cudaGraphicsRegisterFlagsWriteDiscard));
  }
  ~Registered() {
    if (resource_ != nullptr && cudaGraphicsUnregisterResource(resource_) != cudaSuccess) (void)cudaGetLastError();
  }
  Registered(Registered&& other) noexcept : resource_(std::exchange(other.resource_, nullptr)) {}
  Registered(const Registered&) = delete;
  Registered& operator=(const Registered&) = delete;

  cudaGraphicsResource_t get() const { return resource_; }

 private:
  cudaGraphicsResource_t resource_ = nullptr;
};

/// Maps buffers for CUDA; OpenGL must not use them meanwhile. Mapping and unmapping run on the legacy stream, which
/// waits for the worlds' streams and makes them wait.
class Mapped {
 public:
  explicit Mapped(const std::vector<Registered>& buffers) {
    for (const Registered& buffer : buffers) resources_.push_back(buffer.get());
    BALLPIT_CUDA_CHECK(cudaGraphicsMapResources(static_cast<int>(resources_.size()), resources_.data()));
  }
  ~Mapped() {
    const auto n = static_cast<int>(resources_.size());
    if (cudaGraphicsUnmapResources(n, resources_.data()) != cudaSuccess) (void)cudaGetLastError();
  }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;

  template <class T>
  Span<T> span(size_t index, int64_t n) const {
    void* memory = nullptr;
    size_t bytes = 0;
    BALLPIT_CUDA_CHECK(cudaGraphicsResourceGetMappedPointer(&memory, &bytes, resources_[index]));
    return {static_cast<T*>(memory), n};
  }

 private:
  std::vector<cudaGraphicsResource_t> resources_;
};

/// Throws RunError if the current OpenGL context draws on another device than CUDA's.
void check_same_device() {
  int own = 0;
  unsigned count = 0;
  std::vector<int> devices(16);
  BALLPIT_CUDA_CHECK(cudaGetDevice(&own));
  BALLPIT_CUDA_CHECK(cudaGLGetDevices(&count, devices.data(), unsigned(devices.size()), cudaGLDeviceListAll));
  devices.resize(count);
  if (std::find(devices.begin(), devices.end(), own) == devices.end())
    throw RunError("CUDA", "OpenGL draws on another device");
}

class CudaBodyWriter final : public BodyWriter {
 public:
  bool write(World& world, BodyBuffer& buffer, bool with_occluders) override {
    if (!trouble_.empty()) return false;
    const BodyShape shape = world.shape();
    if (!buffer.fits(shape, with_occluders)) shared_.clear();  // CUDA releases buffers before OpenGL does
    buffer.resize(shape, with_occluders);
    try {
      share(buffer, shape);
    } catch (const RunError& error) {
      trouble_ = error.what();
      shared_.clear();
      return false;
    }
    const Mapped mapped(shared_);
    BodyTarget target;
    target.position = mapped.span<float>(0, shape.count * shape.dimensions);
    target.touching = mapped.span<uint8_t>(1, shape.count);
    size_t next = 2;
    if (!shape.has_equal_radii) target.radius = mapped.span<float>(next++, shape.count);
    if (with_occluders) target.occluders = mapped.span<Occluders>(next, shape.count);
    world.write_bodies(target);
    return true;
  }

  std::string trouble() const override { return trouble_; }

  void release() override {
    shared_.clear();
    generation_ = -1;
  }

 private:
  void share(const BodyBuffer& buffer, const BodyShape& shape) {
    if (generation_ == buffer.generation()) return;
    shared_.clear();
    check_same_device();
    shared_.emplace_back(buffer.position_buffer());
    shared_.emplace_back(buffer.mark_buffer());
    if (!shape.has_equal_radii) shared_.emplace_back(buffer.radius_buffer());
    if (buffer.has_occluders()) shared_.emplace_back(buffer.occluder_buffer());
    generation_ = buffer.generation();
  }

  std::string trouble_;
  std::vector<Registered> shared_;  // position, mark, radius where radii differ, and occluders
  int generation_ = -1;             // of the BodyBuffer that they belong to
};

}  // namespace

std::unique_ptr<BodyWriter> make_cuda_body_writer() { return std::make_unique<CudaBodyWriter>(); }

}  // namespace ballpit
