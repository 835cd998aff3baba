// SPDX-License-Identifier: MIT
#include "tests/support/run_program.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ballpit {

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

namespace {

/// In the child, between fork and exec: only calls that are safe there.
bool redirect(const char* path, int to) {
  const int file = ::open(path, O_WRONLY | O_CREAT, 0600);
  return file >= 0 && ::dup2(file, to) >= 0;
}

bool set_limit(int resource, uint64_t bytes) {
  const rlimit limit{bytes, bytes};
  return bytes == 0 || ::setrlimit(resource, &limit) == 0;
}

/// What the child becomes, made before the fork.
struct Child {
  std::vector<char*> arguments;
  std::string folder, out, err;
  uint64_t memory, file_size;
};

[[noreturn]] void become_program(const Child& child) {
  const bool is_ready = ::chdir(child.folder.c_str()) == 0 && redirect(child.out.c_str(), STDOUT_FILENO) &&
                        redirect(child.err.c_str(), STDERR_FILENO) && set_limit(RLIMIT_AS, child.memory) &&
                        set_limit(RLIMIT_FSIZE, child.file_size) && ::signal(SIGXFSZ, SIG_IGN) != SIG_ERR;
  if (is_ready) ::execv(BALLPIT_PROGRAM, child.arguments.data());
  ::_exit(127);
}

}  // namespace

Scratch::Scratch() {
  std::string name = (std::filesystem::temp_directory_path() / "ballpit-app-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test: " + name);
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Program::Program(const Arguments& arguments, const Circumstances& circumstances) {
  std::vector<std::string> words{BALLPIT_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Child child{{},
              circumstances.folder,
              circumstances.out_file,
              scratch_ / "err",
              circumstances.memory,
              circumstances.file_size};
  for (std::string& word : words) child.arguments.push_back(word.data());
  child.arguments.push_back(nullptr);
  if (child.folder.empty()) child.folder = scratch_.path().string();
  if (child.out.empty()) child.out = scratch_ / "out";
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("cannot fork");
  if (process_ == 0) become_program(child);
}

Program::~Program() {
  if (process_ < 0) return;
  signal(SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Program::signal(int number) const { ::kill(process_, number); }

bool Program::wait_until_it_catches(int number) const {
  for (int k = 0; k < 60'000; ++k) {
    const std::string process = "/proc/" + std::to_string(process_);
    std::error_code missing;
    // Before that, it is still the test, which catches signals for itself.
    const bool is_program = std::filesystem::equivalent(process + "/exe", BALLPIT_PROGRAM, missing);
    std::ifstream status(process + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.rfind("State:\tZ", 0) == 0) return false;
      if (!is_program || line.rfind("SigCgt:", 0) != 0) continue;
      if (std::stoull(line.substr(7), nullptr, 16) >> (number - 1) & 1u) return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

Outcome Program::wait() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(scratch_ / "out"),
          read_text(scratch_ / "err")};
}

nlohmann::json Outcome::json() const { return nlohmann::json::parse(out); }

Outcome run_program(const Arguments& arguments, const Circumstances& circumstances) {
  return Program(arguments, circumstances).wait();
}

bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

void write_text(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace ballpit
