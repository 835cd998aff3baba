// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "core/error.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

/// Spheres of these masses in a row, in a large box.
std::string row_of(const std::vector<double>& masses) {
  std::string text = "[domain]\nmax = [100, 1, 1]\n";
  for (size_t i = 0; i < masses.size(); ++i) {
    text += "[[spheres]]\nposition = [" + std::to_string(i + 1) +
            ", 0.5, 0.5]\nradius = 0.25\nmass = " + std::to_string(masses[i]) + "\n";
  }
  return text;
}

std::vector<double> masses_of(const std::string& text, std::optional<double> ratio) {
  SceneOverrides overrides;
  overrides.mass_ratio = ratio;
  return parse_scene(text, "a.toml", {}, overrides).bodies.mass;
}

}  // namespace

TEST_CASE("a mass ratio makes the heavy spheres so many times as heavy as the light ones, whichever come first") {
  CHECK(masses_of(row_of({2, 5, 2, 5}), 100) == std::vector<double>{2, 200, 2, 200});
  CHECK(masses_of(row_of({5, 2}), 1e8) == std::vector<double>{2e8, 2});
  CHECK(masses_of(row_of({5, 2}), 1) == std::vector<double>{2, 2});
  CHECK(masses_of(row_of({5, 2}), {}) == std::vector<double>{5, 2});
}

TEST_CASE("a scene may have a mass ratio of its own, which the command line overrides") {
  const std::string text = row_of({1, 2}) + "[defaults]\nmass-ratio = 7\n";
  CHECK(masses_of(text, {}) == std::vector<double>{1, 7});
  CHECK(masses_of(text, 9) == std::vector<double>{1, 9});
}

TEST_CASE("a mass ratio changes listed spheres only, not those of a fill") {
  const std::string text = row_of({1, 2}) + "[[fill]]\ncount = 1\nradius = 0.1\nmass = 3\n";
  CHECK(masses_of(text, 10) == std::vector<double>{1, 10, 3});
}

TEST_CASE("a mass ratio is refused where it is not clear which spheres it means, or would make them too heavy") {
  CHECK_THROWS_WITH(
      masses_of(row_of({1, 1}), 10),
      "a.toml:3: --mass-ratio: found 10, allowed only in a scene whose [[spheres]] have two masses, not 1");
  CHECK_THROWS_WITH(masses_of(row_of({1, 2, 3}), 10), Catch::EndsWith("two masses, not 3"));
  CHECK_THROWS_WITH(masses_of("title = 'x'", 10), Catch::EndsWith("two masses, not 0"));
  CHECK_THROWS_WITH(masses_of("[[fill]]\ncount = 1\nradius = 0.1\n[defaults]\nmass-ratio = 10", {}),
                    Catch::StartsWith("a.toml:4: [defaults] mass-ratio: found 10, allowed only in a scene"));
  CHECK_THROWS_WITH(masses_of(row_of({1e25, 2e25}), 8e5),
                    Catch::Contains("--mass-ratio: found 8e+05, a mass of 8e+30 kg, allowed 1e-30 to 1e+30 kg"));
  CHECK_THROWS_AS(masses_of(row_of({1, 2}) + "[defaults]\nmass-ratio = 0.5\n", {}), UserError);
}
