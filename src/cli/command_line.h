// SPDX-License-Identifier: MIT
// The options that commands declare, and the parsing of a command line. Only command_line.cpp sees CLI11, which takes
// seconds to compile wherever it is included.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ballpit {

struct CommandEntry;

/// One declared option or argument.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}

  CommandOption* type_name(const std::string& name);  ///< of its value: "SECONDS"
  CommandOption* group(const std::string& heading);   ///< of --help
  CommandOption* required();
  CommandOption* shows_default();  ///< --help shows the value that the variable has now

  bool is_given() const;

 private:
  CLI::Option* option_;
};

/// The options of one command.
class CommandOptions {
 public:
  explicit CommandOptions(CLI::App* command) : command_(command) {}

  /// An option with a value, or an argument if `name` has no dashes. The variable must outlive the parsing.
  CommandOption* add_option(const std::string& name, std::string& value, const std::string& help);

  /// An option without a value.
  CommandOption* add_flag(const std::string& name, bool& value, const std::string& help);

 private:
  CLI::App* command_;
  std::vector<std::unique_ptr<CommandOption>> options_;
};

/// Parses the command line and runs the command that it names. Throws UserError where it is wrong, and what the
/// command throws.
void run_command_line(int argc, char** argv, std::span<const CommandEntry> commands);

}  // namespace ballpit
