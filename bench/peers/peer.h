// SPDX-License-Identifier: MIT
// One interface for everything that finds overlapping spheres here: other libraries, and our own search.
// Each library has a file; the build makes a table of those whose packages it finds.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bodies/pair.h"
#include "families.h"

namespace ballpit {

struct PeerOptions {
  int threads = 1;
  std::string broadphase = "auto";  ///< ours only
  double skin = 0;                  ///< ours only, as a fraction of the radius
};

/// A search with its memory pools and devices.
class Peer {
 public:
  virtual ~Peer() = default;

  /// From bare arrays to the list of pairs, including the making of any structure.
  virtual void find(const Spheres& spheres) = 0;

  /// Finds the pairs after the same spheres have moved a little. The structure may be kept.
  virtual void update(const Spheres& spheres) = 0;

  /// Removes all spheres before the next find(), but keeps the memory if the library can.
  virtual void forget() {}

  /// The pairs found last, each once, in any order and either direction.
  virtual std::vector<Pair> pairs() = 0;
};

struct PeerInfo {
  std::string name;     ///< "bullet-deferred"
  std::string package;  ///< "Bullet 3.24"
  std::string method;
  bool uses_threads;
  std::unique_ptr<Peer> (*make)(const PeerOptions& options);
};

/// Our own search, with which the others are compared.
PeerInfo ours();

/// The libraries of this build.
std::span<const PeerInfo> peer_table();

/// The exact test of two spheres of the same arrays, for libraries that find boxes.
class SphereTest {
 public:
  SphereTest() = default;
  explicit SphereTest(const Spheres& spheres)
      : position_(spheres.position.data()),
        radius_(spheres.radius.data()),
        stride_(spheres.radius.size() > 1 ? 1 : 0) {}

  const Vec3& position(size_t i) const { return position_[i]; }
  float radius(size_t i) const { return radius_[i * stride_]; }

  bool overlap(size_t i, size_t j) const {
    const Vec3 d = position(i) - position(j);
    const float sum = radius(i) + radius(j);
    return dot(d, d) <= sum * sum;
  }

 private:
  const Vec3* position_ = nullptr;
  const float* radius_ = nullptr;
  size_t stride_ = 0;
};

inline Pair pair_of(size_t i, size_t j) { return {static_cast<int32_t>(i), static_cast<int32_t>(j)}; }

}  // namespace ballpit
