// SPDX-License-Identifier: MIT
// A world's snapshot by its parts: numbers, and buffers brought to the host. One function of the world lists its parts, in one
// order, for both ways:
//
//     steps, position, velocity, order, …  ──SavePart──▶  snapshot  ──RestorePart──▶  the same parts
//
// Cost: a copy of what is kept for each body; 28 bytes a sphere in single precision and space, or 52 where the guard's last good
// state is another, and 12 more where velocity Verlet keeps something.
#pragma once

#include <any>
#include <cstddef>
#include <vector>

#include "world/world.h"

namespace ballpit {

struct PartsSnapshot final : Snapshot {
  int64_t bytes() const override { return size; }

  std::vector<std::any> parts;  ///< values, or vectors of them
  int64_t size = 0;             ///< [bytes]

  static constexpr int64_t kPartBytes = 64;  ///< for its keeping, about
};

/// Adds a part to a snapshot.
template <class Exec>
struct SavePart {
  Exec& exec;
  PartsSnapshot& snapshot;

  template <class T>
  void operator()(const T& value) const {
    if constexpr (requires { value.span(); }) {
      snapshot.parts.emplace_back(exec.download(value.span()));
      snapshot.size += value.size() * int64_t(sizeof(value.span()[0]));
    } else {
      snapshot.parts.emplace_back(value);
    }
    snapshot.size += PartsSnapshot::kPartBytes;
  }
};

/// Puts the next part back. Throws std::bad_any_cast where another one was saved.
template <class Exec>
struct RestorePart {
  Exec& exec;
  const PartsSnapshot& snapshot;
  size_t& next;

  template <class T>
  void operator()(T& value) const {
    const std::any& part = snapshot.parts.at(next++);
    if constexpr (requires { value.span(); }) {
      using Values = decltype(exec.download(value.span()));
      exec.upload(value, std::any_cast<const Values&>(part));
    } else {
      value = std::any_cast<const T&>(part);
    }
  }
};

}  // namespace ballpit
