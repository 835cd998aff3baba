// SPDX-License-Identifier: MIT
// Links between the project's pages, pictures and sources lead somewhere.
#include <regex>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "source_tree.h"

namespace fs = std::filesystem;

namespace {

/// The targets of a page's links and pictures, without links to other sites and within the page.
std::vector<std::string> links_in(const std::string& page) {
  static const std::regex pattern(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
  std::vector<std::string> links;
  for (std::sregex_iterator link(page.begin(), page.end(), pattern), end; link != end; ++link) {
    const std::string target = (*link)[1];
    if (target.find("://") == target.npos) links.push_back(target);
  }
  return links;
}

}  // namespace

TEST_CASE("every link of the pages in the root and in docs leads to a file") {
  const fs::path source(BALLPIT_SOURCE_DIR);
  std::vector<fs::path> pages{source / "README.md", source / "CONTRIBUTING.md", source / "CHANGELOG.md"};
  for (const fs::path& file : files_below({"docs"})) {
    if (file.extension() == ".md") pages.push_back(file);
  }
  size_t links = 0;
  for (const fs::path& page : pages) {
    REQUIRE(fs::exists(page));
    for (const std::string& link : links_in(text_of(page))) {
      INFO(page.string() << ": " << link);
      CHECK(fs::exists(page.parent_path() / link));
      ++links;
    }
  }
  CHECK(links > 50);  // the pages were read
}

TEST_CASE("links are found with and without a heading; links to other sites are ignored") {
  CHECK(links_in("see [a](b.md), ![c](d/e.png) and [f](g.md#h), [i](https://j.k) or [l](#m)") ==
        std::vector<std::string>{"b.md", "d/e.png", "g.md"});
}
