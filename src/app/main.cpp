// SPDX-License-Identifier: MIT
// The command line: one command, one run, one exit status. 0 done, 1 failed while running, 2 the user's input is wrong.
#include <algorithm>
#include <array>
#include <iostream>
#include <new>

#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "core/error.h"
#include "version.h"

using namespace ballpit;

namespace {

constexpr std::array kCommands{
    CommandEntry{"render", "draw a scene into PNG frames, without a window or a display", make_render_command},
    CommandEntry{"simulate", "no pictures: final state and summary", make_simulate_command},
    CommandEntry{"list", "scenes, methods, backends, overlays, themes", make_list_command},
    CommandEntry{"doctor", "what this machine offers", make_doctor_command},
};

/// CLI11's message on one line, with where to read on.
std::string describe_parse_error(const CLI::ParseError& error, const CLI::App& app) {
  std::string text = error.what();
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  const auto chosen = app.get_subcommands();
  return text + "; see `ballpit " + (chosen.empty() ? "" : chosen.front()->get_name() + " ") + "--help`";
}

/// CLI11 asks for "a subcommand" where it finds a word that is none; this says which word, and what there is.
void check_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string_view> names;
  for (const CommandEntry& entry : kCommands) names.push_back(entry.name);
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  throw UserError("command: found " + std::string(argv[1]) + ", allowed " + join(names));
}

int fail(int status, const std::string& message) {
  std::cerr << "ballpit: " << message << "\n";
  return status;
}

int run(int argc, char** argv) {
  CLI::App app("Ballpit shows how fast collision detection works, on bouncing spheres.", "ballpit");
  app.set_version_flag("--version", std::string("ballpit ") + kVersion);
  app.require_subcommand(1);
  std::vector<std::unique_ptr<Command>> commands;
  for (const CommandEntry& entry : kCommands) {
    commands.push_back(entry.create());
    Command* command = commands.back().get();
    CLI::App* sub = app.add_subcommand(std::string(entry.name), std::string(entry.help));
    command->add_options(*sub);
    sub->final_callback([command] { command->run(); });
  }
  check_command(argc, argv);
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
  try {
    return run(argc, argv);
  } catch (const UserError& error) {
    return fail(2, error.what());
  } catch (const std::bad_alloc&) {
    return fail(1, "out of memory; fewer spheres (--count) need less");
  } catch (const std::exception& error) {
    return fail(1, error.what());
  }
}
