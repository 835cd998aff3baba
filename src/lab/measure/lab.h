// SPDX-License-Identifier: MIT
// What an experiment runs with. Every measurement is kept by its key, which holds all that it depends on, in a file that
// grows with each: a run that was interrupted goes on where it stopped, and a changed chart measures nothing again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ballpit {

struct LabOptions {
  bool is_quick = false;
  uint64_t seed = 1;
  std::filesystem::path cache = {};              ///< a file; empty: nothing is kept
  std::function<void(bool was_kept)> tell = {};  ///< hears of each measurement that is there
  std::string name = "lab";                      ///< of the experiment, in messages
  std::function<bool()> stop = {};               ///< asked before each; true ends the run
};

class Lab {
 public:
  /// Reads what the cache holds. Throws RunError where it cannot be read or made.
  explicit Lab(LabOptions options);

  bool is_quick() const { return options_.is_quick; }
  uint64_t seed() const { return options_.seed; }

  /// What the function gives: numbers that depend on the key and the version alone. Throws RunError where the run was
  /// interrupted, also within a measurement, or the cache cannot be written.
  std::vector<double> measure(const std::string& key, const std::function<std::vector<double>()>& function);

  /// The same for seconds, which depend on the machine and the build too; the machine's load is noted.
  std::vector<double> time(const std::string& key, const std::function<std::vector<double>()>& function);

  int64_t measured() const { return measured_; }  ///< by a function, not read from the cache
  int64_t asked() const { return asked_; }

  /// The highest load average over a minute at the end of a timing, our own threads included; 0 where nothing was timed.
  double load() const { return load_; }

 private:
  [[noreturn]] void stop() const;
  void keep(const std::string& key, const std::vector<double>& values);

  LabOptions options_;
  std::map<std::string, std::vector<double>> kept_;
  int64_t measured_ = 0;
  int64_t asked_ = 0;
  double load_ = 0;
};

}  // namespace ballpit
