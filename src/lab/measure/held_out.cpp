// SPDX-License-Identifier: MIT
#include "lab/measure/held_out.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "core/random.h"
#include "methods/number_range.h"

namespace ballpit {

namespace {

using std::numbers::pi;

constexpr double kRadius = 0.05;   // [m] in units of 1
constexpr double kDensity = 1000;  // [kg/m³], in the plane of spheres too
constexpr double kGravity = 9.81;  // [m/s²]
constexpr double kSpeed = 1;       // [m/s] of gases

/// Writes a scene file in other units.
class Writer {
 public:
  Writer(const Units& units, double tolerance) : units_(units), tolerance_(tolerance) {}

  void section(std::string_view name) { text_ += fmt::format("\n{}\n", name); }
  void line(std::string_view key, const std::string& value) { text_ += fmt::format("{} = {}\n", key, value); }
  void number(std::string_view key, double value) { line(key, typed(value)); }
  void length(std::string_view key, double value) { number(key, value * units_.length); }
  void lengths(std::string_view key, const Vec3d& v) { vector(key, v, units_.length); }
  void velocities(std::string_view key, const Vec3d& v) { vector(key, v, units_.length / units_.time); }
  void speed(std::string_view key, double value) { number(key, value * units_.length / units_.time); }
  void time(std::string_view key, double value) { number(key, value * units_.time); }
  void mass(std::string_view key, double value) { number(key, value * units_.mass); }
  void gravity() { vector("gravity", {0, -kGravity, 0}, units_.length / units_.time / units_.time); }
  void density() { number("density", kDensity * units_.mass / std::pow(units_.length, 3)); }
  void stiffness(double value) { number("stiffness", value * units_.mass / units_.time / units_.time); }
  void tolerance(std::string_view key, double value) { number(key, value * tolerance_); }
  void largest_speed(double value) { speed("max_speed", value * tolerance_); }

  std::string text() const { return text_; }

 private:
  void vector(std::string_view key, const Vec3d& v, double unit) {
    line(key, fmt::format("[{}, {}, {}]", typed(v.x * unit), typed(v.y * unit), typed(v.z * unit)));
  }

  Units units_;
  double tolerance_;
  std::string text_;
};

double log_uniform(Random& random, double low, double high) { return low * std::pow(high / low, random.uniform()); }

double mass_of(double radius) { return kDensity * 4 / 3 * pi * radius * radius * radius; }

/// A stiffness with which a contact of equal spheres lasts this long [s].
double stiffness_for(double duration, double radius) { return mass_of(radius) / 2 * pi * pi / (duration * duration); }

/// The edge of a cube, or a square, that `count` spheres fill to this part.
double edge_for(int count, double packing, int dimensions) {
  const double volume = dimensions == 2 ? pi * kRadius * kRadius : 4.0 / 3 * pi * std::pow(kRadius, 3);
  return std::pow(count * volume / packing, 1.0 / dimensions);
}

void box(Writer& w, const Vec3d& max, std::string_view boundary, int dimensions) {
  w.section("[domain]");
  w.lengths("min", Vec3d(0.0));
  w.lengths("max", dimensions == 2 ? Vec3d(max.x, max.y, 0) : max);
  w.line("boundary", fmt::format("\"{}\"", boundary));
  w.line("dimensions", std::to_string(dimensions));
}

/// An elastic gas: overlap, energy, sometimes paths or the rate of collisions.
void gas(Writer& w, Random& random, int dimensions) {
  const int count = static_cast<int>(log_uniform(random, 100, 1500));
  const double packing = log_uniform(random, 0.02, dimensions == 2 ? 0.3 : 0.25);
  const double edge = edge_for(count, packing, dimensions);
  const double free_time =
      kRadius / (packing * kSpeed) / (dimensions == 2 ? 1.5 : 3);  // roughly, between two collisions
  const bool has_paths = random.uniform() < 0.25;
  const double duration = free_time * (has_paths ? log_uniform(random, 1, 4) : log_uniform(random, 5, 60));
  box(w, Vec3d(edge), random.uniform() < 0.5 ? "periodic" : "walls", dimensions);
  w.section("[physics]");
  w.number("restitution", 1);
  w.density();
  w.stiffness(stiffness_for(0.02 * kRadius / kSpeed * log_uniform(random, 1, 10), kRadius));
  w.section("[[fill]]");
  w.line("count", std::to_string(count));
  w.length("radius", kRadius);
  w.speed("speed", kSpeed);
  w.section("[needs]");
  w.time("duration", duration);
  w.tolerance("max_overlap", log_uniform(random, 0.003, 0.2));
  w.tolerance("energy_tolerance", log_uniform(random, 1e-4, 0.1));
  if (has_paths) w.tolerance("path_tolerance", log_uniform(random, 0.01, 0.5));
}

/// Spheres fall into a box and come to rest.
void heap(Writer& w, Random& random, int dimensions) {
  const int count = static_cast<int>(log_uniform(random, 60, 800));
  const double layers = random.uniform(1, dimensions == 2 ? 8 : 5), d = 2 * kRadius;
  const double width = dimensions == 2 ? d * count / layers * 1.1 : d * std::sqrt(count / layers * 1.2);
  const double height = d * layers * random.uniform(2.5, 5) + 4 * d;
  const double e = random.uniform(0.1, 0.5), fall = std::sqrt(2 * height / kGravity);
  box(w, {width, height, width}, "walls", dimensions);
  w.section("[physics]");
  w.gravity();
  w.number("restitution", e);
  w.density();
  w.stiffness(mass_of(kRadius) * kGravity * layers / kRadius * log_uniform(random, 100, 3000));
  w.section("[[fill]]");
  w.line("count", std::to_string(count));
  w.length("radius", kRadius);
  w.section("[needs]");
  w.time("duration", fall * (2 + 2 * (1 + e) / (1 - e)));
  w.tolerance("max_overlap", log_uniform(random, 0.01, 0.2));
  w.largest_speed(std::sqrt(kGravity * kRadius) * log_uniform(random, 0.1, 0.5));
}

/// Spheres upon each other, at rest.
void stack(Writer& w, Random& random) {
  const int count = 3 + static_cast<int>(random.uniform() * 18);
  const double e = random.uniform(0, 0.6), d = 2 * kRadius;
  box(w, {6 * d, d * (count + 1), 6 * d}, "walls", 3);
  w.section("[physics]");
  w.gravity();
  w.number("restitution", e);
  w.density();
  w.stiffness(mass_of(kRadius) * kGravity * count / kRadius * log_uniform(random, 30, 30000));
  for (int k = 0; k < count; ++k) {
    w.section("[[spheres]]");
    w.lengths("position", {3 * d, d * (k + 0.5), 3 * d});
    w.length("radius", kRadius);
  }
  w.section("[needs]");
  w.time("duration", random.uniform(1, 5));
  w.tolerance("max_overlap", log_uniform(random, 1e-4, 0.02));
  w.largest_speed(std::sqrt(kGravity * kRadius) * log_uniform(random, 0.003, 0.1));
}

/// A row of spheres that touch, or nearly, hit by one: one hit after another, or springs.
void cradle(Writer& w, Random& random) {
  const int count = 3 + static_cast<int>(random.uniform() * 5);
  const bool has_springs = random.uniform() < 0.5;
  const double d = 2 * kRadius, gap = has_springs ? 0 : d * random.uniform(0, 0.2);
  box(w, {3 * d + count * 1.4 * d, 4 * d, 4 * d}, "walls", 3);
  w.section("[physics]");
  w.number("restitution", 1);
  w.density();
  const double contact = 0.05 * d / kSpeed * log_uniform(random, 0.1, 1);
  w.stiffness(stiffness_for(contact, kRadius));
  for (int k = 0; k < count; ++k) {
    w.section("[[spheres]]");
    w.lengths("position", {k == 0 ? d : 2.5 * d + (k - 1) * (d + gap), 2 * d, 2 * d});
    w.velocities("velocity", {k == 0 ? kSpeed : 0, 0, 0});
    w.length("radius", kRadius);
  }
  w.section("[needs]");
  w.time("duration", d / kSpeed * random.uniform(1.2, 2.2));
  w.tolerance("max_overlap", 0.05);
  w.tolerance("energy_tolerance", log_uniform(random, 1e-4, 0.01));
  w.line("effects", has_springs ? "[\"contact-time\"]" : "[\"momentum-order\"]");
}

/// A fast sphere flies into a block of spheres at rest.
void bullet(Writer& w, Random& random) {
  const int side = 3 + static_cast<int>(random.uniform() * 4);
  const double d = 2 * kRadius, speed = kSpeed * log_uniform(random, 5, 50), pitch = d * random.uniform(1.05, 1.4);
  const double size = pitch * side;
  box(w, {size + 20 * d, size + 8 * d, size + 8 * d}, "walls", 3);
  w.section("[physics]");
  w.number("restitution", random.uniform() < 0.5 ? 1 : random.uniform(0.6, 1));
  w.density();
  w.stiffness(stiffness_for(0.02 * d / speed, kRadius));
  w.section("[[spheres]]");
  w.lengths("position", {2 * d, 4 * d + size / 2 + 0.2 * d, 4 * d + size / 2 + 0.1 * d});
  w.velocities("velocity", {speed, 0, 0});
  w.length("radius", kRadius);
  w.mass("mass", mass_of(kRadius) * log_uniform(random, 1, 20));
  for (int k = 0; k < side * side * side; ++k) {
    w.section("[[spheres]]");
    w.lengths("position", Vec3d(10 * d, 4 * d, 4 * d) +
                              pitch * (Vec3d(k % side, k / side % side, k / side / side) + 0.5));  // NOLINT
    w.length("radius", kRadius);
  }
  w.section("[needs]");
  w.time("duration", 20 * d / speed * log_uniform(random, 1, 4));
  w.tolerance("max_overlap", log_uniform(random, 0.003, 0.1));
  w.largest_speed(speed);
}

/// A gas of two sizes.
void mixture(Writer& w, Random& random) {
  const int large = static_cast<int>(log_uniform(random, 20, 150)), small = large * (2 + int(random.uniform() * 6));
  const double q = random.uniform(1.5, 4), packing = random.uniform(0.03, 0.2), r = kRadius / q;
  const double volume = 4.0 / 3 * pi * (large * std::pow(kRadius, 3) + small * std::pow(r, 3));
  box(w, Vec3d(std::cbrt(volume / packing)), random.uniform() < 0.5 ? "periodic" : "walls", 3);
  w.section("[physics]");
  w.number("restitution", 1);
  w.density();
  w.stiffness(stiffness_for(0.05 * r / kSpeed, r));
  for (const auto& [count, radius] : {std::pair{large, kRadius}, std::pair{small, r}}) {
    w.section("[[fill]]");
    w.line("count", std::to_string(count));
    w.length("radius", radius);
    w.speed("speed", kSpeed);
  }
  w.section("[needs]");
  w.time("duration", kRadius / kSpeed * log_uniform(random, 10, 150));
  w.tolerance("max_overlap", log_uniform(random, 0.003, 0.2));
  w.tolerance("energy_tolerance", log_uniform(random, 1e-3, 0.1));
}

double power_of_ten(Random& random, int smallest, int largest) {
  return std::pow(10.0, std::floor(random.uniform(smallest, largest + 1)));
}

}  // namespace

Units drawn_units(uint64_t seed) {
  Random random(mix_bits(seed) + 1);
  const double length = power_of_ten(random, -3, 3), time = power_of_ten(random, -1, 2),
               mass = power_of_ten(random, -3, 3);
  return {length, time, mass};
}

HeldOutScene held_out_scene(uint64_t seed, const Units& units, double tolerance) {
  Random random(mix_bits(seed));
  Writer writer(units, tolerance);
  const std::string_view family = kHeldOutFamilies[seed % kHeldOutFamilies.size()];
  if (family == "gas") gas(writer, random, 3);
  if (family == "heap") heap(writer, random, 3);
  if (family == "stack") stack(writer, random);
  if (family == "cradle") cradle(writer, random);
  if (family == "bullet") bullet(writer, random);
  if (family == "mixture") mixture(writer, random);
  if (family == "planar") random.uniform() < 0.5 ? gas(writer, random, 2) : heap(writer, random, 2);
  return {family, "title = \"Held out\"\n" + writer.text()};
}

}  // namespace ballpit
