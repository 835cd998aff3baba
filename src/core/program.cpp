// SPDX-License-Identifier: MIT
#include "core/program.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/interrupt.h"

namespace ballpit {

/// A nameless file in memory. Files, unlike pipes, never make a program wait for its reader.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& text = "") : descriptor_(::memfd_create("ballpit", MFD_CLOEXEC)) {
    if (::pwrite(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size())) return;
    throw RunError("memory", std::string("cannot hold the input of a program: ") + std::strerror(errno));
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  std::string content() const {
    std::string text(static_cast<size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
    text.resize(static_cast<size_t>(std::max<ssize_t>(0, ::pread(descriptor_, text.data(), text.size(), 0))));
    return text;
  }

 private:
  int descriptor_;
};

namespace {

pid_t start(const ProgramCall& call, int input, const MemoryFile& out, const MemoryFile& err) {
  std::vector<std::string> words{call.path};
  words.insert(words.end(), call.arguments.begin(), call.arguments.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
  if (!call.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, call.folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  if (!call.gets_interrupts)
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a process group of its own
  pid_t process = -1;
  const int error = ::posix_spawn(&process, call.path.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw RunError(call.path, std::string("cannot start: ") + std::strerror(error));
  return process;
}

int exit_status(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

std::string find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return ::access(name.c_str(), X_OK) == 0 ? name : "";
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string candidate = folder + "/" + name;
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return "";
}

ProgramResult call_program(const ProgramCall& call) {
  const MemoryFile in(call.input), out, err;
  const pid_t process = start(call, in.descriptor(), out, err);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return {exit_status(status), out.content(), err.content()};
}

struct PipedProgram::Output {
  MemoryFile out, err;
};

PipedProgram::PipedProgram(const ProgramCall& call) : output_(std::make_unique<Output>()) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw RunError(call.path, std::string("cannot open a pipe: ") + std::strerror(errno));
  input_ = ends[1];
  try {
    process_ = start(call, ends[0], output_->out, output_->err);
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[0]);  // the program has its own
}

PipedProgram::~PipedProgram() {
  if (input_ >= 0) ::close(input_);
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool PipedProgram::write(std::string_view bytes) {
  while (!bytes.empty()) {
    stop_if_interrupted();
    const ssize_t written = ::write(input_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;  // EPIPE: main() ignores SIGPIPE
    if (written > 0) bytes.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

ProgramResult PipedProgram::finish() {
  ::close(std::exchange(input_, -1));
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) stop_if_interrupted();
  process_ = -1;
  return {exit_status(status), output_->out.content(), output_->err.content()};
}

}  // namespace ballpit
