// SPDX-License-Identifier: MIT
// The commands, the options that they declare, and the parsing of a command line. CLI11 splits the words and prints the
// help; values are read by our own code. Only command_line.cpp includes CLI11, which takes seconds to compile.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "show/options.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ballpit {

/// An option or argument as --help describes it.
struct OptionText {
  std::string name;  ///< "--time"; an argument has no dashes: "SCENE"
  std::string type;  ///< of its value: "SECONDS"
  std::string help;
  std::string preset = {};  ///< the default; empty: --help shows none
  bool is_required = false;
  std::string group = {};  ///< heading in --help
};

/// The options of one command. Their variables must outlive the parsing.
class CommandOptions {
 public:
  explicit CommandOptions(CLI::App* command) : command_(command) {}

  /// `read` gets the value if the option is given. It throws UserError if the value is wrong.
  void add(const OptionText& option, std::function<void(const std::string& text)> read);

  /// An option without a value.
  void add_flag(const std::string& name, bool& value, const std::string& help);

  /// A path that is not empty.
  void add_path(const OptionText& option, std::string& path);

  /// A number, or an optional one. --help names the range, and the variable's value as the default.
  template <class Number, class T>
  void add_number(OptionText option, Number& value, const Range<T>& range) {
    if constexpr (std::is_arithmetic_v<Number>) option.preset = typed(value);
    option.help += ": " + text_of(range);
    add(option,
        [&value, range, name = option.name](const std::string& text) { value = parse_number(name, text, range); });
  }

  /// Reads the values that were given, in the order of the declarations.
  void read() const;

 private:
  CLI::App* command_;
  std::vector<std::pair<CLI::Option*, std::function<void(const std::string&)>>> options_;
};

/// Declares the options of a command and returns what runs it, which throws UserError or RunError. Each command has a
/// file of its own: command_render.cpp and so on.
using MakeCommand = std::function<void()>(CommandOptions& options);
MakeCommand make_show_command, make_lecture_command, make_render_command, make_simulate_command, make_choose_command,
    make_pairs_command, make_compare_command, make_bench_command, make_lab_command, make_list_command,
    make_doctor_command;

/// For a command with functions add_options() and run().
template <class Command>
std::function<void()> make_command(CommandOptions& options) {
  const auto command = std::make_shared<Command>();
  command->add_options(options);
  return [command] { command->run(); };
}

struct CommandEntry {
  std::string_view name, help;
  MakeCommand* make;
};

/// Parses the command line and runs the command that it names. Throws UserError if the command line is wrong, and what
/// the command throws.
void run_command_line(int argc, char** argv, std::span<const CommandEntry> commands);

}  // namespace ballpit
