// SPDX-License-Identifier: MIT
// The program reads every state that it has written, and the run continues bit-identically, for all domains, boundaries,
// precisions and responses.
#include <cmath>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "scene/input_error.h"
#include "scene/read_scene.h"
#include "scene/spheres_csv.h"
#include "show/session.h"
#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

struct Case {
  double low, size;  ///< [m] of the domain
  std::string boundary, precision, response;
  uint64_t seed;
};

template <class T>
const T& one_of(const std::vector<T>& values, Random& random) {
  return values[random.bits() % values.size()];
}

/// Far from the origin, tiny, huge; with ends that single precision does not represent.
Case random_case(uint64_t seed) {
  Random random(seed);
  Case c{one_of<double>({0, 0.7, -0.3, 100.7, -5000.3, 1e-7, 3e5}, random),
         one_of<double>({1, 0.3, 7.1, 1e-6, 1e5, 1e9}, random),
         one_of<std::string>({"walls", "open-top", "periodic", "periodic"}, random),
         one_of<std::string>({"float", "double"}, random),
         one_of<std::string>({"impulse", "penalty", "position-based"}, random),
         seed};
  // Single precision must tell the spheres apart: fills are placed in it.
  c.size = std::max(c.size, std::fabs(c.low) * 1e-3);
  return c;
}

std::string array_of(double value) {
  const std::string v = number_text(value);
  return "[" + v + ", " + v + ", " + v + "]";
}

std::string domain_of(const Case& c) {
  return "[domain]\nmin = " + array_of(c.low) + "\nmax = " + array_of(c.low + c.size) + "\nboundary = '" + c.boundary +
         "'\n[physics]\nstiffness = 4e4\ninitial_overlap = 1\n";
}

std::vector<GivenOption> options_of(const Case& c, const std::string& precision) {
  return {{"response", c.response}, {"precision", precision}, {"dt", "0.001"}, {"max-overlap", "100"}};
}

void step(Session& session, int steps) {
  for (int k = 0; k < steps; ++k) session.world().step();
}

}  // namespace

TEST_CASE("a saved state is read again, and the run continues bit-identically") {
  const Scratch scratch;
  for (uint64_t seed = 1; seed <= 150; ++seed) {
    const Case c = random_case(seed);
    const std::string mass = c.response == "penalty" ? "mass = 1\n" : "";  // else of each sphere its own
    const std::string fill = "[[fill]]\ncount = 60\n" + mass + "radius = [" + number_text(0.02 * c.size) + ", " +
                             number_text(0.06 * c.size) + "]\nspeed = " + number_text(2 * c.size) + "\n";
    INFO(seed << ": from " << c.low << ", " << c.size << " long, " << c.boundary << ", " << c.precision << ", "
              << c.response);
    write_text(scratch / "a.toml", domain_of(c) + fill);
    write_text(scratch / "b.toml", "spheres = 'state.csv'\n" + domain_of(c));
    Session whole(scratch / "a.toml", options_of(c, c.precision));
    step(whole, 40);
    write_spheres_csv(scratch / "state.csv", whole.world().bodies());
    const Scene read = read_scene(scratch / "b.toml");
    CHECK(read.notes.empty());
    Session rest(scratch / "b.toml", options_of(c, c.precision));
    CHECK(rest.world().report().state_hash == whole.world().report().state_hash);
    step(whole, 30);
    step(rest, 30);
    CHECK(rest.world().report().state_hash == whole.world().report().state_hash);
  }
}

TEST_CASE("a state of one precision is read by the other") {
  const Scratch scratch;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const Case c = random_case(seed);
    INFO(seed << ": from " << c.low << ", " << c.size << " long, " << c.boundary << ", " << c.precision);
    write_text(scratch / "a.toml", domain_of(c) + "[[fill]]\ncount = 60\nmass = 1\nradius = " +
                                       number_text(0.04 * c.size) + "\nspeed = " + number_text(2 * c.size) + "\n");
    write_text(scratch / "b.toml", "spheres = 'state.csv'\n" + domain_of(c));
    Session first(scratch / "a.toml", options_of(c, c.precision));
    step(first, 30);
    write_spheres_csv(scratch / "state.csv", first.world().bodies());
    Session second(scratch / "b.toml", options_of(c, c.precision == "float" ? "double" : "float"));
    CHECK_NOTHROW(step(second, 20));
  }
}

TEST_CASE("spheres at the very edge of a periodic domain are read as they were written") {
  const Scratch scratch;
  for (const double low : {0.7, 100.7, -0.3, 0.1, 1e-7, -1e5 - 0.3}) {
    for (const char* precision : {"float", "double"}) {
      const Case c{low, std::fabs(low) > 1000 ? 1000.1 : 1, "periodic", precision, "impulse", 1};
      const std::string radius = number_text(0.05 * c.size);
      const std::string middle = number_text(low + 0.5 * c.size), end = number_text(low + c.size);
      const std::string just_below = number_text(std::nextafter(low + c.size, low));
      std::string spheres;
      for (const std::string& p : {number_text(low) + ", " + middle + ", " + middle,
                                   middle + ", " + end + ", " + middle, middle + ", " + middle + ", " + just_below}) {
        spheres += "[[spheres]]\nposition = [" + p + "]\nradius = " + radius + "\n";
      }
      INFO(low << " in " << precision);
      write_text(scratch / "a.toml", spheres + domain_of(c));
      write_text(scratch / "b.toml", "spheres = 'state.csv'\n" + domain_of(c));
      Session first(scratch / "a.toml", options_of(c, precision));
      write_spheres_csv(scratch / "state.csv", first.world().bodies());
      Session second(scratch / "b.toml", options_of(c, precision));
      CHECK(second.world().report().state_hash == first.world().report().state_hash);
      step(first, 20);
      step(second, 20);
      CHECK(second.world().report().state_hash == first.world().report().state_hash);
    }
  }
}

TEST_CASE("a state with more overlap than --max-overlap is read again and goes on") {
  const Scratch scratch;
  const std::string domain = "[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[physics]\ninitial_overlap = 1\n";
  write_text(scratch / "state.csv", "x,y,z,radius\n0.5,0.5,0.5,0.1\n0.5,0.5,0.5001,0.1\n0.55,0.5,0.5,0.01\n");
  write_text(scratch / "a.toml", "spheres = 'state.csv'\n" + domain);
  const Outcome first = run_program({"simulate", scratch / "a.toml", "--time", "0", "--out", scratch / "again.csv"});
  INFO(first.err);
  CHECK(first.status == 0);
  write_text(scratch / "b.toml", "spheres = 'again.csv'\n" + domain);
  const Outcome second = run_program({"simulate", scratch / "b.toml", "--time", "0.05", "--max-overlap", "0.1"});
  INFO(second.err);
  CHECK(second.status == 0);
}
