// SPDX-License-Identifier: MIT
// Who may include whom: each folder includes only folders below it. Broken includes are told by file and line.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace fs = std::filesystem;

namespace {

struct Rule {
  std::set<std::string> folders;          ///< may be included whole
  std::set<std::string> headers_besides;  ///< single headers of other folders that may be included as well
};

const std::map<std::string, Rule>& rules() {
  static const std::map<std::string, Rule> table{
      {"core", {}},
      {"exec", {{"core"}, {}}},
      {"scene", {{"core"}, {}}},
      {"simulate", {{"core", "exec", "scene"}, {}}},
      {"render", {{"core"}, {"simulate/state.h", "simulate/inspection.h", "simulate/pair.h"}}},
      {"export", {{"core", "render"}, {}}},
      {"lab", {{"core", "exec", "scene", "simulate"}, {}}},
      {"app", {{"core", "exec", "scene", "simulate", "render", "export", "lab"}, {}}},
      {"cuda", {{"core", "exec", "scene", "simulate"}, {"render/body_buffer.h", "render/body_writer.h"}}},
  };
  return table;
}

/// Stages of a step are siblings: they meet in the state's header, not in each other's.
const std::vector<std::string> kStages{"broadphase", "narrowphase", "response", "integrate"};

struct Include {
  fs::path file;
  int line;
  std::string target;
};

/// The quoted includes of all sources below `root`; broken lines and comments are no includes.
std::vector<Include> includes_below(const fs::path& root) {
  static const std::regex pattern(R"(^\s*#\s*include\s*"([^"]+)\")");
  std::vector<Include> result;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (!std::regex_match(entry.path().extension().string(), std::regex(R"(\.(h|hpp|cpp|cu|cuh|in))"))) continue;
    std::ifstream in(entry.path());
    int line = 0;
    for (std::string text; std::getline(in, text);) {
      ++line;
      std::smatch match;
      if (std::regex_search(text, match, pattern)) result.push_back({entry.path(), line, match[1]});
    }
  }
  return result;
}

/// What is wrong with an include in `folder` ("render"), empty if nothing.
std::string verdict(const std::string& folder, const std::string& own_subfolder, const std::string& target) {
  const size_t slash = target.find('/');
  if (slash == std::string::npos) return "";  // generated, or beside the file (cuda/)
  const std::string other = target.substr(0, slash);
  if (rules().count(other) == 0) return "";  // a library's
  const Rule& rule = rules().at(folder);
  if (other == folder) {
    if (folder != "simulate") return "";
    for (const std::string& stage : kStages) {
      const bool is_stage = own_subfolder == stage;
      for (const std::string& sibling : kStages) {
        if (is_stage && stage != sibling && target.rfind("simulate/" + sibling + "/", 0) == 0) {
          return stage + " may not include " + target + ": stages meet in simulate/state.h";
        }
      }
    }
    return "";
  }
  if (rule.folders.count(other) > 0 || rule.headers_besides.count(target) > 0) return "";
  return folder + " may not include " + target;
}

std::vector<std::string> violations_in(const std::string& folder, const fs::path& root) {
  std::vector<std::string> found;
  if (!fs::exists(root)) return found;
  for (const Include& include : includes_below(root)) {
    const std::string subfolder = fs::relative(include.file, root).begin()->string();
    const std::string wrong = verdict(folder, subfolder, include.target);
    if (!wrong.empty()) found.push_back(include.file.string() + ":" + std::to_string(include.line) + ": " + wrong);
  }
  return found;
}

}  // namespace

TEST_CASE("no file includes what its layer may not") {
  const fs::path source(BALLPIT_SOURCE_DIR);
  for (const auto& [folder, rule] : rules()) {
    const fs::path root = folder == "cuda" ? source / "cuda" : source / "src" / folder;
    for (const std::string& violation : violations_in(folder, root)) FAIL_CHECK(violation);
  }
  CHECK(includes_below(source / "src").size() > 100);  // that something was read
}

TEST_CASE("every folder of src has a rule") {
  for (const auto& entry : fs::directory_iterator(fs::path(BALLPIT_SOURCE_DIR) / "src")) {
    INFO(entry.path().filename().string());
    CHECK(rules().count(entry.path().filename().string()) == 1);
  }
}

TEST_CASE("upward, sideways and device includes are found") {
  CHECK(verdict("core", "", "exec/reduce.h") == "core may not include exec/reduce.h");
  CHECK_FALSE(verdict("render", "", "simulate/world.h").empty());
  CHECK(verdict("render", "", "simulate/inspection.h").empty());
  CHECK_FALSE(verdict("lab", "", "render/camera.h").empty());
  CHECK_FALSE(verdict("app", "", "cuda/device_buffer.h").empty());
  CHECK_FALSE(verdict("simulate", "response", "simulate/broadphase/grid.h").empty());
  CHECK(verdict("simulate", "world_on.h", "simulate/broadphase/grid.h").empty());
  CHECK(verdict("cuda", "", "render/body_buffer.h").empty());
  CHECK_FALSE(verdict("cuda", "", "render/renderer.h").empty());
}

TEST_CASE("GLM is included by core/math.h alone, and CUDA's headers by cuda/ and core") {
  const std::regex glm(R"(^\s*#\s*include\s*<glm/)"), cuda(R"(^\s*#\s*include\s*<(cuda|cub/|thrust/))");
  for (const char* folder : {"src", "cuda"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(BALLPIT_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path());
      for (std::string text; std::getline(in, text);) {
        INFO(entry.path().string() << ": " << text);
        if (std::regex_search(text, glm)) CHECK(entry.path().filename() == "math.h");
        if (std::regex_search(text, cuda))
          CHECK((std::string(folder) == "cuda" || entry.path().filename() == "math.h"));
      }
    }
  }
}
