// SPDX-License-Identifier: MIT
#include "render/seen_spheres.h"

#include <bit>
#include <cmath>

namespace ballpit {

namespace {

constexpr float kSmallest = 1;               // [pixel] radius, as in shaders/spheres/small.vert
constexpr float kSlack = 0.1f;               // [pixel] for rounding
constexpr float kHighest = 4, kNear = 2.6f;  // [radius] of spheres with a shadow, and of the shadow: as in shadow.vert

/// Around a sphere's outline in the picture [pixel], x to the right, y up.
struct Disc {
  float x, y;
  float inner;  ///< within this radius, all pixels are covered completely
  float outer;  ///< beyond this radius, no pixel is covered at all
};

/// A bit for each pixel of a picture.
class PixelSet {
 public:
  PixelSet(int width, int height)
      : width_(width), height_(height), words_((width + 63) / 64), bits_(size_t(words_) * size_t(height)) {}

  bool has_disc(float x, float y, float radius) const {
    bool has_all = true;
    for_rows(x, y, radius, [&](int row, int low, int high) { return has_all = has_run(row, low, high); });
    return has_all;
  }

  void add_disc(float x, float y, float radius) {
    for_rows(x, y, radius, [&](int row, int low, int high) {
      for_words(row, low, high, [&](size_t word, uint64_t mask) {
        bits_[word] |= mask;
        return true;
      });
      return true;
    });
  }

  bool has_rectangle(const Vec2& low, const Vec2& high) const {
    const int left = std::max(0, first(low.x)), right = std::min(width_ - 1, last(high.x));
    for (int row = std::max(0, first(low.y)); row <= std::min(height_ - 1, last(high.y)); ++row) {
      if (left <= right && !has_run(row, left, right)) return false;
    }
    return true;
  }

 private:
  /// Of the pixels whose centres lie beyond, or before, a coordinate.
  static int first(float at) { return static_cast<int>(std::ceil(at - 0.5f)); }
  static int last(float at) { return static_cast<int>(std::floor(at - 0.5f)); }

  bool has_run(int row, int low, int high) const {
    bool has_all = true;
    for_words(row, low, high, [&](size_t word, uint64_t mask) { return has_all = (bits_[word] & mask) == mask; });
    return has_all;
  }

  /// Calls visit(row, first pixel, last pixel) until it returns false.
  template <class Visit>
  void for_rows(float x, float y, float radius, const Visit& visit) const {
    if (!(radius > 0)) return;
    for (int row = std::max(0, first(y - radius)); row <= std::min(height_ - 1, last(y + radius)); ++row) {
      const float up = static_cast<float>(row) + 0.5f - y;
      const float half = std::sqrt(std::max(0.0f, radius * radius - up * up));
      const int low = std::max(0, first(x - half)), high = std::min(width_ - 1, last(x + half));
      if (low <= high && !visit(row, low, high)) return;
    }
  }

  template <class Visit>
  void for_words(int row, int low, int high, const Visit& visit) const {
    const size_t begin = size_t(row) * size_t(words_);
    for (int word = low / 64; word <= high / 64; ++word) {
      const int from = std::max(low - 64 * word, 0), to = std::min(high - 64 * word, 63);
      if (!visit(begin + size_t(word), ~uint64_t(0) << from & ~uint64_t(0) >> (63 - to))) return;
    }
  }

  int width_, height_, words_;
  std::vector<uint64_t> bits_;
};

class Finder {
 public:
  Finder(const FrameView& view, int width, int height)
      : view_(view),
        to_eye_(view.camera.view()),
        to_clip_(view.camera.projection()),
        size_(width, height),
        pixel_(view.camera.pixel_size(1, height)),
        covered_(width, height) {}

  SeenSpheres find(const SmallSpheres& spheres) {
    const size_t count = spheres.position.size() / 3;
    std::vector<Disc> discs(count);
    std::vector<uint64_t> order;  // depth, whose bits as a positive float grow with it, then number
    for (size_t i = 0; i < count; ++i) {
      const Vec4 sphere = at(spheres, i);
      const Vec3 center(to_eye_ * Vec4(Vec3(sphere), 1));
      if (!set_disc(center, sphere.w, discs[i])) continue;
      order.push_back(uint64_t(std::bit_cast<uint32_t>(-center.z)) << 32 | i);
    }
    std::sort(order.begin(), order.end());
    SeenSpheres seen;
    for (const uint64_t key : order) {
      const auto i = static_cast<uint32_t>(key);
      const Disc& disc = discs[i];
      if (covered_.has_disc(disc.x, disc.y, disc.outer)) continue;
      covered_.add_disc(disc.x, disc.y, disc.inner);
      seen.nearest_first.push_back(i);
    }
    for (size_t i = 0; i < count; ++i) {
      const Vec4 sphere = at(spheres, i);
      if (shows_shadow(sphere)) seen.near_floor.push_back(sphere);
    }
    return seen;
  }

 private:
  static Vec4 at(const SmallSpheres& spheres, size_t i) {
    const float* p = spheres.position.data() + 3 * i;
    return {p[0], p[1], p[2], spheres.radius[spheres.radius.size() > 1 ? i : 0]};
  }

  Vec2 in_picture(const Vec3& seen_from_eye) const {
    const Vec4 clip = to_clip_ * Vec4(seen_from_eye, 1);
    return (Vec2(clip.x, clip.y) / clip.w + 1.0f) / 2.0f * size_;
  }

  /// False if it is outside of the picture.
  bool set_disc(const Vec3& center, float radius, Disc& disc) const {
    const float distance2 = dot(center, center), depth = -center.z;
    const float r = std::max(radius, kSmallest * pixel_ * std::sqrt(distance2));
    if (depth <= r) return false;
    const float power = depth * depth - r * r, outline = r / std::sqrt(distance2 - r * r) / pixel_;
    const float across = r / std::sqrt(power) / pixel_;  // half the small axis of the ellipse
    const float along = across * std::sqrt((center.x * center.x + center.y * center.y) / power + 1);
    const float k = depth * depth / power;
    const Vec2 middle = in_picture({k * center.x, k * center.y, center.z});
    disc = {middle.x, middle.y, across * (1 - 0.5f / outline) - kSlack, along * (1 + 0.5f / outline) + kSlack};
    return middle.x + disc.outer > 0 && middle.x - disc.outer < size_.x && middle.y + disc.outer > 0 &&
           middle.y - disc.outer < size_.y;
  }

  bool shows_shadow(const Vec4& sphere) const {
    const float height = sphere.y - view_.domain.min.y, reach = kNear * sphere.w;
    if (height < 0 || height > kHighest * sphere.w) return false;
    Vec2 low(INFINITY), high(-INFINITY);
    for (int corner = 0; corner < 4; ++corner) {
      const Vec3 place(sphere.x + (corner & 1 ? reach : -reach), view_.domain.min.y,
                       sphere.z + (corner & 2 ? reach : -reach));
      const Vec3 seen(to_eye_ * Vec4(place, 1));
      if (-seen.z <= view_.camera.near) return true;
      const Vec2 at = in_picture(seen);
      low = min(low, at);
      high = max(high, at);
    }
    return !covered_.has_rectangle(low - kSlack, high + kSlack);
  }

  const FrameView& view_;
  Mat4 to_eye_, to_clip_;
  Vec2 size_;
  float pixel_;  // [m] at distance 1 m
  PixelSet covered_;
};

}  // namespace

SeenSpheres find_seen(const SmallSpheres& spheres, const FrameView& view, int width, int height) {
  return Finder(view, width, height).find(spheres);
}

}  // namespace ballpit
