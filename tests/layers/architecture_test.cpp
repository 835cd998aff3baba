// SPDX-License-Identifier: MIT
// Names in docs/architecture.md and CONTRIBUTING.md agree with the code: each file exists, and each function and class
// occurs in the sources.
#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "source_tree.h"

namespace fs = std::filesystem;

namespace {

/// What `page` has in backticks and `pattern` matches whole.
std::set<std::string> quoted(const std::string& page, const std::string& pattern) {
  const std::regex regex("`(" + pattern + ")`");
  std::set<std::string> found;
  for (std::sregex_iterator match(page.begin(), page.end(), regex), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

const std::string kFile = R"([\w./-]+\.(?:h|cpp|cu|toml|md|cmake|txt|vert|frag|glsl|csv|sh)|[\w.-]+/[\w./-]*)";
const std::string kFunction = R"((?:\w+::)*\w+\(\))";
const std::string kType = R"([A-Z][a-z]\w+(?:::\w+)*)";

/// Files are named from the root of the repository. What the build makes is not in it.
bool exists(const std::string& file) { return fs::exists(fs::path(BALLPIT_SOURCE_DIR) / file); }

bool is_made(const std::string& file) { return std::regex_search(file, std::regex("^(build|out|golden-failures)/")); }

using Words = std::set<std::string>;

Words words_in(const std::string& text) {
  Words words;
  std::string word;
  for (const char c : text + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

/// Whether one of the files has all words of the name: "World::step()" needs both in one file.
bool occurs(const std::string& name, const std::vector<Words>& files) {
  const Words wanted = words_in(name);
  const auto has_all = [&](const Words& file) {
    return std::includes(file.begin(), file.end(), wanted.begin(), wanted.end());
  };
  return std::any_of(files.begin(), files.end(), has_all);
}

std::vector<Words> sources() {
  std::vector<Words> files;
  for (const fs::path& file : files_below({"src", "cuda"})) {
    if (std::regex_match(file.extension().string(), std::regex(R"(\.(h|cpp|cu|cuh))"))) {
      files.push_back(words_in(text_of(file)));
    }
  }
  return files;
}

}  // namespace

TEST_CASE("each file that the architecture names exists") {
  for (const char* page : {"docs/architecture.md", "CONTRIBUTING.md"}) {
    const std::set<std::string> files = quoted(text_of(fs::path(BALLPIT_SOURCE_DIR) / page), kFile);
    CHECK(files.size() > 5);
    for (const std::string& file : files) {
      INFO(page << ": " << file);
      CHECK((is_made(file) || exists(file)));
    }
  }
}

TEST_CASE("each function and class that the architecture names occurs in the code") {
  const std::string page = text_of(fs::path(BALLPIT_SOURCE_DIR) / "docs/architecture.md");
  const std::vector<Words> code = sources();
  std::set<std::string> names = quoted(page, kFunction);
  names.merge(quoted(page, kType));
  CHECK(names.size() > 40);
  for (const std::string& name : names) {
    INFO(name);
    CHECK(occurs(name, code));
  }
}

TEST_CASE("names are found in backticks, and missing ones are noticed") {
  const std::string page = "`src/a/b.h`, `World::step()`, `kick()`, `Kick`, `dt`, `--dt 1` and `src/world/`";
  CHECK(quoted(page, kFile) == std::set<std::string>{"src/a/b.h", "src/world/"});
  CHECK(quoted(page, kFunction) == std::set<std::string>{"World::step()", "kick()"});
  CHECK(quoted(page, kType) == std::set<std::string>{"Kick"});
  const std::vector<Words> code{words_in("class World { void step(); };"), words_in("void stop();")};
  CHECK(occurs("World::step()", code));
  CHECK_FALSE(occurs("World::stop()", code));
}
