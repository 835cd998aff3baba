// SPDX-License-Identifier: MIT
#include "core/file.h"

#include <catch2/catch.hpp>

#include "core/error.h"

using namespace ballpit;
namespace fs = std::filesystem;

TEST_CASE("a written file reads back whole and leaves nothing beside it") {
  const fs::path folder = fs::temp_directory_path() / "ballpit-file-test";
  fs::create_directories(folder);
  const std::string bytes("a\0b\n", 4);
  write_file(folder / "x.bin", bytes);
  CHECK(read_file(folder / "x.bin") == bytes);
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}) == 1);
  fs::remove_all(folder);
}

TEST_CASE("a failed write names the path and the reason and leaves no half file") {
  CHECK_THROWS_WITH(write_file("/nonexistent/x", "a"),
                    Catch::Contains("/nonexistent/x") && Catch::Contains("No such file"));
  if (fs::exists("/dev/full")) {
    const fs::path folder = fs::temp_directory_path() / "ballpit-full-test";
    fs::create_directories(folder);
    fs::remove(folder / "x.part");
    fs::create_symlink("/dev/full", folder / "x.part");
    CHECK_THROWS_WITH(write_file(folder / "x", "a"), Catch::Contains("No space left"));
    CHECK_FALSE(fs::exists(folder / "x"));
    CHECK_FALSE(fs::is_symlink(folder / "x.part"));
    fs::remove_all(folder);
  }
}

TEST_CASE("reading what is not a readable file is the user's error") {
  CHECK_THROWS_AS(read_file("/nonexistent/x"), UserError);
  CHECK_THROWS_WITH(read_file("/tmp"), Catch::Contains("folder"));
}
