// SPDX-License-Identifier: MIT
#include "tests/support/picture_compare.h"

#include <cstdlib>
#include <filesystem>

namespace ballpit {

std::string compare_with_golden(const std::string& name, const Image& actual, const std::string& folder) {
  const std::string golden = folder + "/" + name + ".png";
  if (!std::getenv("BALLPIT_BLESS")) return compare_pictures(name, actual, read_png(golden));
  if (std::filesystem::exists(golden) && compare_pictures(name, actual, read_png(golden)).empty()) return "";
  write_png(golden, actual);
  return "blessed: " + golden + "; look at it, then test without BALLPIT_BLESS";
}

std::string compare_pictures(const std::string& name, const Image& actual, const Image& expected) {
  if (expected.width != actual.width || expected.height != actual.height) return name + ": of another size";
  const Comparison found = comparison_of(actual, expected);
  if (found.is_same()) return "";
  const std::filesystem::path folder = std::filesystem::current_path() / "golden-failures";
  std::filesystem::create_directories(folder);
  const std::string file = (folder / (name + ".png")).string();
  write_png(file, comparison_picture(actual, expected));
  return name + ": " + std::to_string(found.worst_block) + " of 64 pixels of a block differ (8 may); see " + file;
}

}  // namespace ballpit
