// SPDX-License-Identifier: MIT
#include "cli/command_line.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "version.h"

namespace ballpit {

namespace {

/// "SECONDS (time step: 1e-12 to 10)".
std::string allowed_by(const CLI::Option& option) {
  return option.get_type_name() + " (" + option.get_description() + ")";
}

/// "see `ballpit simulate --help`".
std::string see_help(const CLI::App& command) {
  return "see `ballpit " + (command.get_parent() ? command.get_name() + " " : "") + "--help`";
}

UserError extra_words(const CLI::App& command) {
  const std::vector<std::string> extras = command.remaining(true);
  const std::string found = extras.empty() ? "more than it takes" : extras.front();
  if (!found.starts_with('-')) {
    std::string allowed = "options alone";
    for (const std::string argument : {"SCENE", "FILE"}) {
      if (command.get_option_no_throw(argument) != nullptr) allowed = "one " + argument + " and options";
    }
    if (command.get_option_no_throw("B") != nullptr) allowed = "A, B and options";
    return UserError(command.get_name(), found, allowed, see_help(command));
  }
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
  }
  return UserError(command.get_name(), "unknown option " + found, join(names), see_help(command));
}

/// Any other failure of the parsing.
UserError other_failure(const std::string& message, const CLI::App& command) {
  return UserError(command.get_name(), "what cannot be parsed (" + message + ")", "a command and its options",
                   see_help(command));
}

/// An option with too few or too many values. CLI11's message starts with its name, a flag's without dashes.
UserError value_mismatch(const std::string& message, const CLI::App& command) {
  const std::string first = message.substr(0, message.find_first_of(": "));
  const std::string name = first.starts_with('-') ? first : "--" + first;
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr) return other_failure(message, command);
  if (option->get_items_expected_max() == 0) return UserError(name, "a value", "none", see_help(command));
  if (option->count() > 1)
    return UserError(name, std::to_string(option->count()) + " values", "one", see_help(command));
  return UserError(name, "nothing", allowed_by(*option), see_help(command));
}

UserError missing_option(const std::string& message, const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    return UserError(option->get_name(), "nothing", allowed_by(*option), see_help(command));
  }
  return other_failure(message, command);
}

/// A failure to parse the arguments of a command, in our form.
UserError user_error(const CLI::ParseError& error, const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return extra_words(command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return value_mismatch(error.what(), command);
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing_option(error.what(), command);
  return other_failure(error.what(), command);
}

/// Throws UserError for a word that is no command. CLI11 would not name the word, nor the commands.
void check_command(int argc, char** argv, std::span<const CommandEntry> commands) {
  const std::string_view found = argc < 2 ? "" : argv[1];
  if (found.starts_with("-h") || found.starts_with("--help") || found.starts_with("--version")) return;
  std::vector<std::string_view> names;
  for (const CommandEntry& entry : commands) names.push_back(entry.name);
  if (std::find(names.begin(), names.end(), found) != names.end()) return;
  throw UserError("command", found, join(names) + ", --help, --version");
}

}  // namespace

void CommandOptions::add(const OptionText& option, std::function<void(const std::string&)> read) {
  CLI::Option* declared = command_->add_option(option.name, CLI::callback_t(), option.help);
  declared->required(option.is_required)->type_name(option.type.empty() ? "TEXT" : option.type);
  if (!option.preset.empty()) declared->default_str(option.preset);
  if (!option.group.empty()) declared->group(option.group);
  options_.emplace_back(declared, std::move(read));
}

void CommandOptions::add_flag(const std::string& name, bool& value, const std::string& help) {
  command_->add_flag(name, value, help)->disable_flag_override();
}

void CommandOptions::add_path(const OptionText& option, std::string& path) {
  add(option, [&path, name = option.name](const std::string& text) {
    if (text.empty()) throw UserError(name, "nothing", "a path");
    path = text;
  });
}

void CommandOptions::read() const {
  for (const auto& [option, read] : options_) {
    if (option->count() > 0) read(option->results().front());
  }
}

void run_command_line(int argc, char** argv, std::span<const CommandEntry> entries) {
  CLI::App app("Ballpit visualizes fast collision-detection algorithms on bouncing spheres.", "ballpit");
  app.set_version_flag("--version", std::string("ballpit ") + kVersion);
  app.require_subcommand(1);
  for (const CommandEntry& entry : entries) {
    CLI::App* command = app.add_subcommand(std::string(entry.name), std::string(entry.help));
    CommandOptions options(command);
    const std::function<void()> run = entry.make(options);
    command->final_callback([options, run] {
      options.read();
      run();
    });
  }
  check_command(argc, argv, entries);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw user_error(error, app);
    app.exit(error);  // prints --help or --version
  }
}

}  // namespace ballpit
