// SPDX-License-Identifier: MIT
// Links between the project's pages, pictures and sources lead somewhere.
#include <cctype>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "source_tree.h"

namespace fs = std::filesystem;

namespace {

struct Link {
  std::string file;     ///< empty: the same page
  std::string heading;  ///< as in the address: "newtons-cradle"; empty: the whole page
  bool operator==(const Link&) const = default;
};

/// A page's links and pictures, without those to other sites.
std::vector<Link> links_in(const std::string& page) {
  static const std::regex pattern(R"(\]\(([^)#\s]*)#?([^)]*)\))");
  std::vector<Link> links;
  for (std::sregex_iterator link(page.begin(), page.end(), pattern), end; link != end; ++link) {
    const std::string file = (*link)[1];
    if (file.find("://") == file.npos) links.push_back({file, (*link)[2]});
  }
  return links;
}

/// The headings of a page as addresses: lower case, words joined by '-', without punctuation.
std::set<std::string> headings_of(const std::string& page) {
  std::set<std::string> headings;
  std::istringstream in(page);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind('#', 0) != 0) continue;
    std::string address;
    for (const char c : line.substr(line.find_first_not_of("# "))) {
      const auto byte = static_cast<unsigned char>(c);
      if (c == ' ') address += '-';
      if (byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '_') address += static_cast<char>(std::tolower(byte));
    }
    headings.insert(address);
  }
  return headings;
}

}  // namespace

TEST_CASE("every link of the pages in the root and in docs leads to a file and a heading") {
  const fs::path source(BALLPIT_SOURCE_DIR);
  std::vector<fs::path> pages{source / "README.md", source / "CONTRIBUTING.md", source / "CHANGELOG.md"};
  for (const fs::path& file : files_below({"docs"})) {
    if (file.extension() == ".md") pages.push_back(file);
  }
  size_t links = 0;
  for (const fs::path& page : pages) {
    REQUIRE(fs::exists(page));
    for (const Link& link : links_in(text_of(page))) {
      INFO(page.string() << ": " << link.file << "#" << link.heading);
      const fs::path target = link.file.empty() ? page : page.parent_path() / link.file;
      CHECK(fs::exists(target));
      if (!link.heading.empty()) CHECK(headings_of(text_of(target)).count(link.heading) == 1);
      ++links;
    }
  }
  CHECK(links > 50);  // the pages were read
}

TEST_CASE("links are found with and without a heading, links to other sites are ignored") {
  CHECK(links_in("see [a](b.md), ![c](d/e.png) and [f](g.md#h), [i](https://j.k) or [l](#m)") ==
        std::vector<Link>{{"b.md", ""}, {"d/e.png", ""}, {"g.md", "h"}, {"", "m"}});
  CHECK(headings_of("# A\ntext # no\n### Newton's cradle: `x`, 2\n") ==
        std::set<std::string>{"a", "newtons-cradle-x-2"});
}
