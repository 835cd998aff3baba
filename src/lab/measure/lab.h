// SPDX-License-Identifier: MIT
// Makes the measurements of an experiment and keeps them in a file, each with a key that names everything it depends
// on. So an interrupted run continues where it stopped, and a changed chart needs no new measurements.
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
  std::filesystem::path cache = {};              ///< a file; empty: keep nothing
  std::function<void(bool was_kept)> tell = {};  ///< called after each measurement
  std::string name = "lab";                      ///< of the experiment, in messages
  std::function<bool()> stop = {};               ///< called before each measurement; true ends the run
};

class Lab {
 public:
  /// Reads the cache. Throws RunError if it cannot be read or created.
  explicit Lab(LabOptions options);

  bool is_quick() const { return options_.is_quick; }
  uint64_t seed() const { return options_.seed; }

  /// The result of the function: numbers that depend on nothing but the key and the version. Throws RunError if the run
  /// is interrupted, also during a measurement, or if the cache cannot be written.
  std::vector<double> measure(const std::string& key, const std::function<std::vector<double>()>& function);
  double measure_number(const std::string& key, const std::function<double()>& function) {
    return measure(key, [&] { return std::vector<double>{function()}; })[0];
  }

  /// The same for times [s], which also depend on the machine and the build. Records the load of the machine.
  std::vector<double> time(const std::string& key, const std::function<std::vector<double>()>& function);

  int64_t measured() const { return measured_; }  ///< those not read from the cache
  int64_t asked() const { return asked_; }

  /// The highest load average at the end of a timing, over a minute and with our own threads; 0 if nothing was timed.
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
