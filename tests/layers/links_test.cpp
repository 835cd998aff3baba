// SPDX-License-Identifier: MIT
// Links between the project's pages, pictures and sources lead somewhere.
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace fs = std::filesystem;

namespace {

/// What links and pictures of a page name, but for other sites and places in the same page.
std::vector<std::string> links_in(const std::string& page) {
  static const std::regex pattern(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
  std::vector<std::string> links;
  for (std::sregex_iterator link(page.begin(), page.end(), pattern), end; link != end; ++link) {
    const std::string target = (*link)[1];
    if (target.find("://") == target.npos) links.push_back(target);
  }
  return links;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("every link of README, CHANGELOG and docs leads to a file") {
  const fs::path source(BALLPIT_SOURCE_DIR);
  std::vector<fs::path> pages{source / "README.md", source / "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(source / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  size_t links = 0;
  for (const fs::path& page : pages) {
    for (const std::string& link : links_in(text_of(page))) {
      INFO(page.string() << ": " << link);
      CHECK(fs::exists(page.parent_path() / link));
      ++links;
    }
  }
  CHECK(links > 50);  // that something was read
}

TEST_CASE("links are found with and without a place in the page, links to other sites are left alone") {
  CHECK(links_in("see [a](b.md), ![c](d/e.png) and [f](g.md#h), [i](https://j.k) or [l](#m)") ==
        std::vector<std::string>{"b.md", "d/e.png", "g.md"});
}
