// SPDX-License-Identifier: MIT
// The commands. Each declares its options and runs, in a file of its own: command_render.cpp and so on.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

namespace ballpit {

class CommandOptions;

class Command {
 public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  virtual void add_options(CommandOptions& command) = 0;

  /// Runs with the options that were read. Throws UserError or RunError.
  virtual void run() = 0;
};

struct CommandEntry {
  std::string_view name;
  std::string_view help;
  std::unique_ptr<Command> (*create)();
};

std::unique_ptr<Command> make_show_command();
std::unique_ptr<Command> make_render_command();
std::unique_ptr<Command> make_simulate_command();
std::unique_ptr<Command> make_pairs_command();
std::unique_ptr<Command> make_bench_command();
std::unique_ptr<Command> make_lab_command();
std::unique_ptr<Command> make_list_command();
std::unique_ptr<Command> make_doctor_command();

}  // namespace ballpit
