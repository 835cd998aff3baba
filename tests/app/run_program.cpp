// SPDX-License-Identifier: MIT
#include "tests/app/run_program.h"

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ballpit {

namespace {

/// In the child, between fork and exec: only calls that are safe there.
bool redirect(const char* path, int to) {
  const int file = ::open(path, O_WRONLY | O_CREAT, 0600);
  return file >= 0 && ::dup2(file, to) >= 0;
}

[[noreturn]] void become_program(char* const* arguments, const char* out, const char* err, uint64_t memory) {
  const rlimit limit{memory, memory};
  const bool is_ready = redirect(out, STDOUT_FILENO) && redirect(err, STDERR_FILENO) &&
                        (memory == 0 || ::setrlimit(RLIMIT_AS, &limit) == 0);
  if (is_ready) ::execv(BALLPIT_PROGRAM, arguments);
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

Program::Program(const std::vector<std::string>& arguments, const Circumstances& circumstances) {
  std::vector<std::string> words{BALLPIT_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const std::string out = circumstances.out_file.empty() ? scratch_ / "out" : circumstances.out_file;
  const std::string err = scratch_ / "err";
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("cannot fork");
  if (process_ == 0) become_program(pointers.data(), out.c_str(), err.c_str(), circumstances.memory);
}

Program::~Program() {
  if (process_ < 0) return;
  signal(SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Program::signal(int number) const { ::kill(process_, number); }

Outcome Program::wait() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(scratch_ / "out"),
          read_text(scratch_ / "err")};
}

Outcome run_program(const std::vector<std::string>& arguments, const Circumstances& circumstances) {
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
