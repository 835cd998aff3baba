// SPDX-License-Identifier: MIT
// Vectors and matrices: the project's only include of GLM, and aliases for all other code.
//
// Simulation code is written once for planar and spatial scenes: the vector type V (Vec2 or Vec3) is a template parameter,
// so a planar scene neither stores nor searches a third coordinate.
#pragma once

#ifdef __CUDACC__
#include <cuda.h>  // GLM 0.9.9 reads CUDA_VERSION from it
#define GLM_FORCE_CUDA
#endif
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace ballpit {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using IVec3 = glm::ivec3;
using Mat4 = glm::mat4;

using glm::dot;
using glm::length;
using glm::normalize;

/// The component type of a vector type: float for Vec3.
template <class V>
using Scalar = typename V::value_type;

/// The number of components of a vector type: 3 for Vec3.
template <class V>
inline constexpr int kDimensions = V::length();

/// The first kDimensions<V> components of `a`, rounded to V's scalar.
template <class V>
V narrow(const Vec3d& a) {
  V result{};
  for (int axis = 0; axis < kDimensions<V>; ++axis) result[axis] = static_cast<Scalar<V>>(a[axis]);
  return result;
}

/// `a` with the components that V lacks set to zero.
template <class V>
Vec3d widen(const V& a) {
  Vec3d result{0.0};
  for (int axis = 0; axis < kDimensions<V>; ++axis) result[axis] = a[axis];
  return result;
}

}  // namespace ballpit
