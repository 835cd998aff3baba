// SPDX-License-Identifier: MIT
// The options that a command declares, and the parsing of a command line. CLI11 splits the words and prints the help;
// values are read by our own code. Only command_line.cpp includes CLI11, which takes seconds to compile.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "show/parse.h"

namespace CLI {
class App;
}

namespace ballpit {

struct CommandEntry;

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
  explicit CommandOptions(CLI::App* command);
  ~CommandOptions();

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
  struct Declared;

  CLI::App* command_;
  std::vector<std::unique_ptr<Declared>> options_;
};

/// Parses the command line and runs the command that it names. Throws UserError if the command line is wrong, and what
/// the command throws.
void run_command_line(int argc, char** argv, std::span<const CommandEntry> commands);

}  // namespace ballpit
