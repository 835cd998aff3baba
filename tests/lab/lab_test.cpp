// SPDX-License-Identifier: MIT
// Measurements are kept: none is made twice, and none is lost.
#include "lab/measure/lab.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "lab/report/experiment.h"

using namespace ballpit;
using Catch::Contains;

namespace {

/// A path without a file; the file is removed at the end.
class CacheFile {
 public:
  CacheFile() : path_(std::filesystem::temp_directory_path() / ("ballpit-lab-" + std::to_string(::getpid()) + ".csv")) {
    std::filesystem::remove(path_);
  }
  ~CacheFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

Lab lab_with(const CacheFile& cache) {
  LabOptions options;
  options.cache = cache.path();
  return Lab(options);
}

}  // namespace

TEST_CASE("a laboratory reads what an earlier one has measured") {
  const CacheFile cache;
  const std::vector<double> values{0.1, 1e-300, -2, INFINITY};
  CHECK(lab_with(cache).measure("a, \"b\"", [&] { return values; }) == values);
  Lab again = lab_with(cache);
  CHECK(again.measure("a, \"b\"", []() -> std::vector<double> { throw std::logic_error("measured again"); }) == values);
  CHECK(again.measured() == 0);
  CHECK(again.asked() == 1);
  again.measure("another key", [&] { return values; });
  CHECK(again.measured() == 1);
}

TEST_CASE("NaN is kept as NaN") {
  const CacheFile cache;
  lab_with(cache).measure("k", [] { return std::vector<double>{kNoNumber, 1}; });
  const std::vector<double> read = lab_with(cache).measure("k", [] { return std::vector<double>{}; });
  REQUIRE(read.size() == 2);
  CHECK(std::isnan(read[0]));
  CHECK(read[1] == 1);
}

TEST_CASE("an incomplete line is measured again and does not affect others") {
  const CacheFile cache;
  lab_with(cache).measure("whole", [] { return std::vector<double>{1}; });
  const std::string whole = read_file(cache.path());
  std::ofstream(cache.path(), std::ios::app) << whole.substr(0, whole.size() / 2);
  Lab lab = lab_with(cache);
  lab.measure("next", [] { return std::vector<double>{2}; });
  Lab again = lab_with(cache);
  CHECK(again.measure("whole", [] { return std::vector<double>{}; }) == std::vector<double>{1});
  CHECK(again.measure("next", [] { return std::vector<double>{}; }) == std::vector<double>{2});
  CHECK(again.measured() == 0);
}

TEST_CASE("an interrupted laboratory stops before the next measurement and reports how to continue") {
  LabOptions options;
  int done = 0;
  options.tell = [&](bool) { ++done; };
  options.stop = [&] { return done == 2; };
  Lab lab(options);
  const auto measure = [&] { lab.measure(std::to_string(done), [] { return std::vector<double>{1}; }); };
  measure();
  measure();
  CHECK_THROWS_WITH(measure(), Contains("interrupted") && Contains("the same command goes on from there"));
}

TEST_CASE("an unknown experiment is an error that lists all experiments") {
  for (const Experiment& experiment : experiments()) {
    CHECK(find_experiment(experiment.name).name == experiment.name);
    CHECK_THROWS_WITH(find_experiment("nonsense"),
                      Contains("found nonsense") && Contains(std::string(experiment.name)));
  }
  CHECK_THROWS_AS(find_experiment(""), UserError);
}
