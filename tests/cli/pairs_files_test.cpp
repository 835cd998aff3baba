// SPDX-License-Identifier: MIT
// The files that `ballpit pairs` reads and writes, and what it reports of wrong ones.
#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "tests/cli/run_pairs.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

TEST_CASE("files without spheres, with one, in any order of columns and with velocities are searched") {
  const Scratch scratch;
  const auto pairs_in = [&](const std::string& text, const std::string& method) {
    write_text(scratch / "a.csv", text);
    pairs({scratch / "a.csv", "--verify", "--broadphase", method, "--out", scratch / "pairs.csv"});
    return read_text(scratch / "pairs.csv");
  };
  for (const std::string& method : search_methods()) {
    INFO(method);
    CHECK(pairs_in("x,y,z,radius\n", method) == "i,j\n");
    CHECK(pairs_in("x,y,z,radius\n1,2,3,4\n", method) == "i,j\n");
    CHECK(pairs_in("radius,vx,z,y,x,mass\r\n1,5,0,0,0,1e30\r\n1,5,0,0,1,1\r\n", method) == "i,j\n0,1\n");
    CHECK(pairs_in("x,y,z,radius\n1e15,1e15,1e15,1e15\n-1e15,-1e15,-1e15,1e15\n1e15,0,0,1e15\n", method) ==
          "i,j\n0,2\n");
    CHECK(pairs_in("x,y,z,radius\n0,0,0,1e-12\n2e-12,0,0,1e-12\n5e-12,0,0,1e-12\n", method) == "i,j\n0,1\n");
  }
}

TEST_CASE("an old list of pairs is replaced, and stays where the search fails") {
  const Scratch scratch;
  write_text(scratch / "four.csv", kFour);
  write_text(scratch / "bad.csv", "x,y,z,radius\n1,2,3,oops\n");
  write_text(scratch / "pairs.csv", "old");
  CHECK(run_program({"pairs", scratch / "bad.csv", "--out", scratch / "pairs.csv"}).status == 2);
  CHECK(read_text(scratch / "pairs.csv") == "old");
  pairs({scratch / "four.csv", "--out", scratch / "pairs.csv"});
  CHECK(read_text(scratch / "pairs.csv") == kPairsOfFour);
}

TEST_CASE("coordinates too large for single precision beside the radii are searched, with a warning") {
  const Scratch scratch;
  write_text(scratch / "far.csv", "x,y,z,radius\n10000000.3,0,0,0.1\n0,0,0,0.1\n");
  const Outcome outcome = run_program({"pairs", scratch / "far.csv"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Contains("far.csv: coordinates as large as 1e+07 are rounded by up to 0.5 m"));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

TEST_CASE("wrong files of spheres are refused with file, line, column, what was found and what is allowed") {
  const Scratch scratch;
  const std::string header = "x,y,z,radius\n";
  const std::string columns = ", allowed columns x, y, z, radius and optionally vx, vy, vz, mass";
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", ":1: header: found an empty file" + columns},
      {"x,y,z\n1,2,3\n", ":1: header: found no column \"radius\"" + columns},
      {"1,2,3,4\n", ":1: header: found \"1,2,3,4\", no column \"x\"" + columns},
      {header + "1,2,3\n", ":2: row: found 3 fields, allowed 4, as in the header"},
      {header + "1,2,3,1\n1,two,3,1\n", ":3: y: found \"two\", allowed a number, -1e+15 to 1e+15"},
      {header + "nan,2,3,1\n", ":2: x: found \"nan\", allowed a number, -1e+15 to 1e+15"},
      {header + "1,2,-inf,1\n", ":2: z: found \"-inf\", allowed a number, -1e+15 to 1e+15"},
      {header + "1,1e16,3,1\n", ":2: y: found \"1e16\", allowed a number, -1e+15 to 1e+15"},
      {header + "1,2,3,0\n", ":2: radius: found \"0\", allowed a number, 1e-12 to 1e+15"},
      {header + "1,2,3,-1\n", ":2: radius: found \"-1\", allowed a number, 1e-12 to 1e+15"},
      {std::string("\x7F\x45LF\x02\x00\n\xFF", 8),
       ":1: header: found \"\\x7FELF\\x02\\x00\", no column \"x\"" + columns},
      {std::string(3'000'000, 'x'), ":1: line: found more than 1048576 bytes"},
  };
  for (const auto& [text, message] : table) {
    write_text(scratch / "a.csv", text);
    const Outcome outcome = run_program({"pairs", scratch / "a.csv", "--out", scratch / "pairs.csv"});
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Catch::StartsWith("ballpit: " + scratch / "a.csv" + message));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(scratch / "pairs.csv"));
  }
}

TEST_CASE("files of spheres that are none are refused with the reason") {
  const auto error_of = [](const std::string& file) {
    const Outcome outcome = run_program({"pairs", file});
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    return outcome.err;
  };
  const Scratch scratch;
  CHECK_THAT(error_of(scratch / "none.csv"), Contains("none.csv: found no readable file (No such file"));
  CHECK_THAT(error_of(scratch.path().string()), Contains("found a folder, allowed a file"));
  CHECK_THAT(error_of("/proc/self/exe"), Contains(":1: header: found "));  // the program itself
  CHECK_THAT(error_of("/dev/zero"), Contains(":1: line: found more than 1048576 bytes"));
}

TEST_CASE("a list of pairs that cannot be written is named with the reason, before the spheres are read") {
  const Scratch scratch;
  write_text(scratch / "file", "x");
  const auto failure_of = [&](const std::string& out) {
    const Outcome outcome = run_program({"pairs", scratch / "none.csv", "--out", out});
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    return outcome.err;
  };
  CHECK_THAT(failure_of(scratch / "file/pairs.csv"), Contains("file/pairs.csv: cannot write: Not a directory"));
  CHECK_THAT(failure_of(scratch / "missing/pairs.csv"), Contains("pairs.csv: cannot write: No such file"));
  CHECK_THAT(failure_of(scratch.path().string()), Contains("cannot write: Is a directory"));

  write_text(scratch / "four.csv", kFour);
  const Outcome outcome = run_program({"pairs", scratch / "four.csv", "--out", "/proc/pairs.csv"});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("/proc/pairs.csv: cannot write"));
}

TEST_CASE("more overlapping pairs than memory can hold are reported as an error") {
  if (is_sanitized()) return;
  const Scratch scratch;
  std::string text = "x,y,z,radius\n";
  for (int k = 0; k < 30'000; ++k) text += "0,0,0,1\n";  // 450 million pairs
  write_text(scratch / "heap.csv", text);
  const Outcome outcome = run_program({"pairs", scratch / "heap.csv", "--threads", "2"}, {1'000'000'000, ""});
  INFO(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK_THAT(outcome.err, Contains("out of memory") && Contains("heap.csv"));
}
