// SPDX-License-Identifier: MIT
// What include roots cannot check: which files include the headers of GLM and CUDA. That no folder of src includes a
// folder above it is checked by the compiler: include_test.cmake.
#include <regex>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

#include "source_tree.h"

TEST_CASE("GLM is included by core/math.h alone, and CUDA's headers by cuda/ and core/math.h") {
  const std::regex glm(R"(^\s*#\s*include\s*<glm/)"), cuda(R"(^\s*#\s*include\s*<(cuda|cub/|thrust/))");
  const std::filesystem::path own = std::filesystem::path(BALLPIT_SOURCE_DIR) / "cuda";
  int found = 0;
  for (const auto& file : files_below({"src", "cuda"})) {
    const bool is_math = file.filename() == "math.h";
    const bool is_cuda = file.parent_path() == own;
    std::istringstream in(text_of(file));
    for (std::string line; std::getline(in, line);) {
      const bool has_glm = std::regex_search(line, glm), has_cuda = std::regex_search(line, cuda);
      found += has_glm || has_cuda;
      INFO(file.string() << ": " << line);
      CHECK((!has_glm || is_math));
      CHECK((!has_cuda || is_math || is_cuda));
    }
  }
  CHECK(found > 0);
}
