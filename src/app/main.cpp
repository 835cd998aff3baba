// SPDX-License-Identifier: MIT
// The command line: one command, one run, one exit status. 0 done, 1 failed while running, 2 the user's input
// is wrong.
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

#include <CLI/CLI.hpp>
#include <malloc.h>

#include "app/commands.h"
#include "app/parse_error.h"
#include "core/error.h"
#include "version.h"

using namespace ballpit;

namespace {

constexpr std::array kCommands{
    CommandEntry{"show", "a window with the panel", make_show_command},
    CommandEntry{"render", "draw a scene into PNG frames, without a window or a display", make_render_command},
    CommandEntry{"simulate", "no pictures: final state and summary", make_simulate_command},
    CommandEntry{"pairs", "overlapping pairs among spheres in a CSV file", make_pairs_command},
    CommandEntry{"bench", "time per step by method, backend, threads and number of spheres", make_bench_command},
    CommandEntry{"lab", "experiments: tables, charts and one report of what methods cost and get right",
                 make_lab_command},
    CommandEntry{"list", "scenes, methods, backends, overlays, colours, themes, observables, experiments",
                 make_list_command},
    CommandEntry{"doctor", "what this machine offers", make_doctor_command},
};

int fail(int status, const std::string& message) {
  std::cerr << "ballpit: " << on_one_line(message) << "\n";
  return status;
}

/// A summary that was lost, on a full disk or a closed pipe, is a failure like any other.
void flush_output() {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return;
  throw RunError(std::string("standard output: cannot write: ") + std::strerror(errno));
}

int run(int argc, char** argv) {
  CLI::App app("Ballpit shows how fast collision detection works, on bouncing spheres.", "ballpit");
  app.set_version_flag("--version", std::string("ballpit ") + kVersion);
  app.require_subcommand(1);
  std::vector<std::unique_ptr<Command>> commands;
  std::vector<std::string_view> names;
  for (const CommandEntry& entry : kCommands) {
    commands.push_back(entry.create());
    names.push_back(entry.name);
    Command* command = commands.back().get();
    CLI::App* sub = app.add_subcommand(std::string(entry.name), std::string(entry.help));
    command->add_options(*sub);
    sub->final_callback([command] { command->run(); });
  }
  check_command(argc, argv, names);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    return fail(2, describe_parse_error(error, app));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  // Frames are megabytes, made and freed at a steady pace: kept by the program, they are not mapped and cleared by the
  // system each time. Measured: one part in twenty of the time of a frame.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has left is told as a full disk is
  try {
    const int status = run(argc, argv);
    flush_output();
    return status;
  } catch (const UserError& error) {
    return fail(2, error.what());
  } catch (const std::bad_alloc&) {
    return fail(1, "out of memory; fewer spheres (--count) or a smaller picture (--size) need less");
  } catch (const std::exception& error) {
    return fail(1, error.what());
  }
}
