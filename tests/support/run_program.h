// SPDX-License-Identifier: MIT
// Runs the program as a user does, in a process of its own, and returns its output and exit status.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/types.h>

namespace ballpit {

using Arguments = std::vector<std::string>;

/// Arguments, followed by more.
Arguments with(Arguments arguments, const Arguments& more);

/// An empty folder that is removed at the end.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The current folder, until its end.
class Within {
 public:
  explicit Within(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  ~Within() { std::filesystem::current_path(before_); }
  Within(const Within&) = delete;
  Within& operator=(const Within&) = delete;

 private:
  std::filesystem::path before_;
};

/// A variable of the environment, until the end of the test.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }

  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

struct Outcome {
  int status = 0;  ///< exit status, or 128 + the signal that ended it
  std::string out, err;

  nlohmann::json json() const;
};

struct Circumstances {
  uint64_t memory = 0;     ///< [bytes] of address space, where above 0
  std::string out_file{};  ///< where standard output goes, in place of Outcome::out
  std::string folder{};    ///< where the program runs, in place of one that is removed at the end
  uint64_t file_size = 0;  ///< [bytes] that a file may have, where above 0
};

/// A running program; killed if nobody waits for its end.
class Program {
 public:
  explicit Program(const Arguments& arguments, const Circumstances& circumstances = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;

  /// Waits until the program catches a signal, as /proc shows; false if it ends before, or after a minute.
  bool wait_until_it_catches(int number) const;
  Outcome wait();

 private:
  Scratch scratch_;
  pid_t process_ = -1;
};

/// Runs the program to its end.
Outcome run_program(const Arguments& arguments, const Circumstances& circumstances = {});

/// Whether the sanitizers watch, which need more address space than a limit could leave them.
bool is_sanitized();

void write_text(const std::string& path, const std::string& text);
std::string read_text(const std::string& path);

}  // namespace ballpit
