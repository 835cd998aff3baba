// SPDX-License-Identifier: MIT
#include "lab/charts/gnuplot.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/program.h"
#include "lab/charts/html.h"

namespace ballpit {

namespace {

/// A file in memory, without a name.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& text = "") : descriptor_(::memfd_create("ballpit", MFD_CLOEXEC)) {
    if (descriptor_ < 0 || ::write(descriptor_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
      throw RunError("gnuplot", std::string("cannot pass the chart: ") + std::strerror(errno));
    }
    ::lseek(descriptor_, 0, SEEK_SET);
  }
  ~MemoryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  std::string content() const {
    ::lseek(descriptor_, 0, SEEK_SET);
    std::string text;
    std::array<char, 65536> part;
    for (ssize_t size; (size = ::read(descriptor_, part.data(), part.size())) > 0;) {
      text.append(part.data(), static_cast<size_t>(size));
    }
    return text;
  }

 private:
  int descriptor_;
};

/// Runs a program with these as its standard input, output and error, in a group of its own: Ctrl-C is for us, and a chart
/// that is begun is also ended. Returns its exit status.
int run(const std::string& program, const MemoryFile& in, const MemoryFile& out, const MemoryFile& err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::string name = program, no_settings_of_the_user = "--default-settings";
  std::array<char*, 3> arguments{name.data(), no_settings_of_the_user.data(), nullptr};
  pid_t process = -1;
  const int error = ::posix_spawn(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw RunError(program, std::string("cannot start: ") + std::strerror(error));
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
}

}  // namespace

std::string gnuplot_path() { return find_program("gnuplot"); }

std::string draw_svg(const Chart& chart, Ground ground, const std::string& gnuplot) {
  const MemoryFile script(gnuplot_script(chart, ground)), out, err;
  const int status = run(gnuplot, script, out, err);
  std::string svg = out.content();
  if (status != 0 || svg.find("</svg>") == std::string::npos) {
    throw RunError(gnuplot, "failed on chart " + chart.name + ": " + err.content());
  }
  // gnuplot takes one family; and neighbouring cells of a map must not show the ground between them.
  replace_all(svg, "font-family=\"sans-serif\"",
              "font-family=\"Roboto, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif\"");
  replace_all(svg, "<title>Gnuplot</title>", "<title>" + html_text(chart.title) + "</title>");
  replace_all(svg, "<polygon fill", "<polygon shape-rendering='crispEdges' fill");
  return svg;
}

}  // namespace ballpit
