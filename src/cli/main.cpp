// SPDX-License-Identifier: MIT
// The program: runs one command and returns its exit status. 0: done, 1: failed while running, 2: wrong input.
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

#include "cli/command_line.h"
#include "core/heap.h"

using namespace ballpit;

namespace {

constexpr std::array kCommands {
  CommandEntry{"show", "a window with the panel", make_show_command},
      CommandEntry{"lecture", "a lecture, page by page; --export makes a handout", make_lecture_command},
      CommandEntry{"render", "draw a scene into PNG frames, without a window or a display", make_render_command},
      CommandEntry{"simulate", "no pictures: final state and summary", make_simulate_command},
      CommandEntry{"choose", "the cheapest method that gives what the scene's [needs] ask for, and why",
                   make_choose_command},
      CommandEntry{"pairs", "overlapping pairs among spheres in a CSV file or a scene", make_pairs_command},
      CommandEntry{"compare", "whether two PNG pictures show the same, for screenshot tests", make_compare_command},
      CommandEntry{"bench", "time per step by method, backend, threads and number of spheres", make_bench_command},
#if BALLPIT_HAS_LABORATORY
      CommandEntry{"lab", "experiments: tables, charts and one report of what methods cost and get right",
                   make_lab_command},
#endif
      CommandEntry{"list", "scenes, methods, backends, overlays, colours, themes, observables, experiments",
                   make_list_command},
      CommandEntry{"doctor", "what this machine offers", make_doctor_command},
};

/// Replaces line breaks and other control characters, which could disturb the terminal.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return text;
}

int fail(int status, const std::exception& error) {
  std::cerr << "ballpit: " << on_one_line(error.what()) << "\n";
  return status;
}

/// Throws RunError if a summary could not be written, to a full disk or a closed pipe.
void flush_output() {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return;
  throw RunError("standard output", std::string("cannot write: ") + std::strerror(errno));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string command = argc < 2 ? "" : argv[1];  // named by errors that name no other place
  set_up_heap();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is reported as a full disk is
  try {
    run_command_line(argc, argv, kCommands);
    flush_output();
    return 0;
  } catch (const UserError& error) {
    return fail(2, error);
  } catch (const RunError& error) {
    return fail(1, error);
  } catch (const std::bad_alloc&) {
    return fail(1,
                RunError(command, "out of memory", "fewer spheres (--count) or a smaller picture (--size) need less"));
  } catch (const std::exception& error) {
    return fail(1, RunError(command, error.what()));
  }
}
