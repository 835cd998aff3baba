// SPDX-License-Identifier: MIT
// Damaged scenes and CSV files are either read or refused with a UserError of one line.
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "core/file.h"
#include "core/random.h"
#include "scene/read_scene.h"
#include "scene/spheres_csv.h"
#include "scene_files.h"

using namespace ballpit;

namespace {

size_t below(Random& random, size_t limit) { return static_cast<size_t>(random.bits() % std::max<size_t>(limit, 1)); }

/// Cut off, bytes flipped, or a piece copied over another.
std::string damaged(std::string_view text, Random& random) {
  std::string result(text);
  switch (below(random, 3)) {
    case 0:
      result.resize(below(random, result.size()));
      break;
    case 1:
      for (size_t flips = 1 + below(random, 4); flips > 0; --flips) {
        result[below(random, result.size())] ^= static_cast<char>(1 + below(random, 255));
      }
      break;
    default: {
      const size_t from = below(random, result.size());
      result.insert(below(random, result.size()), result.substr(from, 1 + below(random, 40)));
    }
  }
  return result;
}

/// Whether `read` succeeds or fails as it should.
template <class Read>
bool behaves(const Read& read) {
  try {
    read();
  } catch (const UserError& error) {
    const std::string_view message = error.what();
    return message.find('\n') == std::string_view::npos && message.find("found") != std::string_view::npos;
  }
  return true;
}

}  // namespace

TEST_CASE("a damaged scene is read or refused, and never crashes", "[slow]") {
  SceneOverrides few;
  few.count = 60;  // so that thousands of scenes take seconds
  for (const EmbeddedFile& file : scene_files()) {
    Random random(1);
    int misbehaved = 0;
    for (int i = 0; i < 1500; ++i) {
      const std::string text = damaged(file.text, random);
      if (behaves([&] { parse_scene(text, "a.toml", "/nonexistent", few); })) continue;
      UNSCOPED_INFO(text);
      ++misbehaved;
    }
    CHECK(misbehaved == 0);
  }
}

TEST_CASE("a damaged scene with its own count is read or refused in bounded time and memory") {
  const std::string text =
      "[domain]\nmax = [1, 1, 1]\n[physics]\ngravity = [0, -9.81, 0]\n[[fill]]\ncount = 50\nradius = 0.05\n"
      "[[fill]]\ncount = 9\nradius = [0.05, 0.09]\narrangement = \"lattice\"\n[defaults]\nseed = 3\ncount = "
      "40\n";
  Random random(2);
  int misbehaved = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string bad = damaged(text, random);
    if (behaves([&] { parse_scene(bad, "a.toml"); })) continue;
    UNSCOPED_INFO(bad);
    ++misbehaved;
  }
  CHECK(misbehaved == 0);
}

TEST_CASE("a damaged CSV file is read or refused, and never crashes") {
  const std::string text = "x,y,z,radius,vx,vy,vz,mass\n0.5,1e-3,-2.25,0.1,0,0,-1.5,1\r\n1,2,3,0.25,4,5,6,7\n";
  Random random(3);
  int misbehaved = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string bad = damaged(text, random);
    misbehaved += !behaves([&] { read_spheres_csv({bad, "a.csv"}); });
  }
  CHECK(misbehaved == 0);
}
