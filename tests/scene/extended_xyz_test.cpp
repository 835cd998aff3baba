// SPDX-License-Identifier: MIT
// Reads trajectories back like a reader of extended XYZ: by the keys in the second line of each frame.
#include "scene/extended_xyz.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"

using namespace ballpit;
namespace fs = std::filesystem;

namespace {

/// An empty folder that is removed at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("ballpit-xyz-" + std::to_string(::getpid()));
  Folder() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }

  /// Whether the folder contains only `name`, or nothing if there is no name.
  bool holds_only(const std::string& name) const {
    for (const auto& entry : fs::directory_iterator(path)) {
      if (entry.path().filename() != name) return false;
    }
    return name.empty() || fs::exists(path / name);
  }
};

struct Frame {
  std::map<std::string, std::string> keys;      ///< without quotes
  std::vector<std::vector<std::string>> lines;  ///< words of each sphere's
};

/// key=value key="several values" …
std::map<std::string, std::string> keys_of(const std::string& line) {
  std::map<std::string, std::string> keys;
  for (size_t at = 0; at < line.size();) {
    const size_t equals = line.find('=', at);
    REQUIRE(equals != std::string::npos);
    const bool is_quoted = line[equals + 1] == '"';
    const size_t begin = equals + 1 + is_quoted;
    const size_t end = std::min(line.find(is_quoted ? '"' : ' ', begin), line.size());
    keys[line.substr(at, equals - at)] = line.substr(begin, end - begin);
    at = end + 1 + is_quoted;
  }
  return keys;
}

std::vector<Frame> frames_in(const fs::path& path) {
  std::istringstream in(read_file(path));
  std::vector<Frame> frames;
  for (std::string line; std::getline(in, line);) {
    Frame frame;
    const int count = std::stoi(line);
    REQUIRE(std::getline(in, line));
    frame.keys = keys_of(line);
    for (int i = 0; i < count; ++i) {
      REQUIRE(std::getline(in, line));
      std::istringstream words(line);
      frame.lines.emplace_back(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>());
    }
    frames.push_back(frame);
  }
  return frames;
}

Bodies some_bodies(int count, uint64_t seed) {
  Random random(seed);
  Bodies bodies;
  for (int i = 0; i < count; ++i) {
    bodies.position.push_back(random.uniform(Vec3d(-1), Vec3d(1)));
    bodies.velocity.push_back(random.uniform(Vec3d(-1e-9), Vec3d(1e-9)));
    bodies.radius.push_back(random.uniform(0.01, 0.02));
    bodies.mass.push_back(random.uniform(1e6, 1e7));
  }
  return bodies;
}

/// pos:R:3:radius:R:1:velo:R:3:mass:R:1, every bit as it was.
void check_bodies(const Frame& frame, const Bodies& bodies) {
  REQUIRE(frame.lines.size() == bodies.position.size());
  for (size_t i = 0; i < frame.lines.size(); ++i) {
    const std::vector<std::string>& words = frame.lines[i];
    REQUIRE(words.size() == 9);
    const auto number = [&](size_t k) { return std::stod(words[k]); };
    CHECK(words[0] == "X");
    CHECK(Vec3d(number(1), number(2), number(3)) == bodies.position[i]);
    CHECK(number(4) == bodies.radius[i]);
    CHECK(Vec3d(number(5), number(6), number(7)) == bodies.velocity[i]);
    CHECK(number(8) == bodies.mass[i]);
  }
}

std::map<std::string, std::string> keys_for(const Domain& domain) {
  const Folder folder;
  ExtendedXyz file(folder.path / "a.xyz", domain);
  file.append(0.125, some_bodies(2, 1));
  file.finish();
  return frames_in(folder.path / "a.xyz").at(0).keys;
}

}  // namespace

TEST_CASE("frames of a trajectory read back in order, bit-identical") {
  const Folder folder;
  const fs::path path = folder.path / "a.xyz";
  const std::vector<Bodies> states{some_bodies(3, 1), some_bodies(3, 2), some_bodies(3, 3)};
  ExtendedXyz file(path, Domain{});
  for (size_t k = 0; k < states.size(); ++k) {
    CHECK(file.frames() == static_cast<int64_t>(k));
    file.append(0.1 * static_cast<double>(k), states[k]);
  }
  CHECK_FALSE(fs::exists(path));
  file.finish();
  const std::vector<Frame> frames = frames_in(path);
  REQUIRE(frames.size() == 3);
  for (size_t k = 0; k < states.size(); ++k) {
    CHECK(std::stod(frames[k].keys.at("Time")) == 0.1 * static_cast<double>(k));
    check_bodies(frames[k], states[k]);
  }
  CHECK(folder.holds_only("a.xyz"));
}

TEST_CASE("a frame larger than the buffer reads back completely") {
  const Folder folder;
  const Bodies bodies = some_bodies(20'000, 5);
  ExtendedXyz file(folder.path / "a.xyz", Domain{});
  file.append(0, bodies);
  file.append(1, bodies);
  file.finish();
  CHECK(fs::file_size(folder.path / "a.xyz") > 4 << 20);
  const std::vector<Frame> frames = frames_in(folder.path / "a.xyz");
  REQUIRE(frames.size() == 2);
  check_bodies(frames[1], bodies);
}

TEST_CASE("a frame's keys give the box, the columns, the time and the periodic borders") {
  const auto keys = keys_for({{-1, 0, 2}, {5, 0.5, 4}, Boundary::walls, 3});
  CHECK(keys == std::map<std::string, std::string>{{"Lattice", "6 0 0 0 0.5 0 0 0 2"},
                                                   {"Origin", "-1 0 2"},
                                                   {"Properties", "species:S:1:pos:R:3:radius:R:1:velo:R:3:mass:R:1"},
                                                   {"Time", "0.125"},
                                                   {"pbc", "F F F"}});
  CHECK(keys_for({Vec3d(0), Vec3d(1), Boundary::open_top, 3}).at("pbc") == "F F F");
  CHECK(keys_for({Vec3d(0), Vec3d(1), Boundary::periodic, 3}).at("pbc") == "T T T");
}

TEST_CASE("a planar frame is as thick as its largest sphere, and is not periodic in z") {
  const Folder folder;
  Bodies bodies = some_bodies(2, 1);
  bodies.radius = {0.25, 0.125};
  ExtendedXyz file(folder.path / "a.xyz", {Vec3d(0), {2, 3, 0}, Boundary::periodic, 2});
  file.append(0, bodies);
  file.finish();
  const auto keys = frames_in(folder.path / "a.xyz").at(0).keys;
  CHECK(keys.at("Lattice") == "2 0 0 0 3 0 0 0 0.5");
  CHECK(keys.at("Origin") == "0 0 -0.25");
  CHECK(keys.at("pbc") == "T T F");
}

TEST_CASE("numbers of a trajectory are written as short as possible") {
  const Folder folder;
  Bodies bodies;
  bodies.resize(1);
  bodies.position[0] = {0.1, 1.0 / 3.0, -2.0};
  bodies.radius[0] = 0.5;
  bodies.mass[0] = 1e-9;
  ExtendedXyz file(folder.path / "a.xyz", Domain{});
  file.append(0.3, bodies);
  file.finish();
  CHECK(read_file(folder.path / "a.xyz") ==
        "1\nLattice=\"1 0 0 0 1 0 0 0 1\" Origin=\"0 0 0\" Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:mass:R:1 "
        "Time=0.3 pbc=\"F F F\"\nX 0.1 0.3333333333333333 -2 0.5 0 0 0 1e-09\n");
}

TEST_CASE("an unfinished trajectory keeps its complete frames, one without frames leaves no file") {
  const Folder folder;
  { const ExtendedXyz none(folder.path / "none.xyz", Domain{}); }
  CHECK(folder.holds_only(""));
  {
    ExtendedXyz file(folder.path / "a.xyz", Domain{});
    file.append(0, some_bodies(3, 1));
  }
  CHECK(frames_in(folder.path / "a.xyz").size() == 1);
  CHECK(folder.holds_only("a.xyz"));
}

TEST_CASE("a trajectory that cannot be written names its path and the reason") {
  CHECK_THROWS_WITH(ExtendedXyz("/nonexistent/a.xyz", Domain{}),
                    "/nonexistent/a.xyz: cannot write: No such file or directory");
  if (!fs::exists("/dev/full")) return;
  const Folder folder;
  fs::create_symlink("/dev/full", folder.path / "a.xyz");
  {
    ExtendedXyz file(folder.path / "a.xyz", Domain{});
    CHECK_THROWS_WITH(file.append(0, some_bodies(1, 1)),
                      Catch::Contains("a.xyz: cannot write: No space left on device"));
    CHECK(file.frames() == 0);
  }
  CHECK(folder.holds_only("a.xyz"));
  CHECK(fs::is_symlink(folder.path / "a.xyz"));
}
