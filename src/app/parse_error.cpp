// SPDX-License-Identifier: MIT
#include "app/parse_error.h"

#include <algorithm>

#include "core/error.h"

namespace ballpit {

namespace {

/// "SECONDS (time step: 1e-12 to 10)".
std::string allowed_by(const CLI::Option& option) {
  return option.get_type_name() + " (" + option.get_description() + ")";
}

std::string describe_extra(const CLI::App& command) {
  const std::vector<std::string> extras = command.remaining(true);
  const std::string found = extras.empty() ? "more than it takes" : extras.front();
  if (!found.starts_with('-')) {
    std::string allowed = "options alone";
    for (const std::string argument : {"SCENE", "FILE"}) {
      if (command.get_option_no_throw(argument) != nullptr) allowed = "one " + argument + " and options";
    }
    return command.get_name() + ": found " + found + ", allowed " + allowed;
  }
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
  }
  return command.get_name() + ": found unknown option " + found + ", allowed " + join(names);
}

/// An option that has too few or too many values: CLI11's message starts with its name, a flag's without
/// dashes.
std::string describe_mismatch(const std::string& message, const CLI::App& command) {
  const std::string first = message.substr(0, message.find_first_of(": "));
  const std::string name = first.starts_with('-') ? first : "--" + first;
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr) return message;
  if (option->get_items_expected_max() == 0) return name + ": found a value, allowed none";
  if (option->count() > 1) return name + ": found " + std::to_string(option->count()) + " values, allowed one";
  return name + ": found nothing, allowed " + allowed_by(*option);
}

std::string describe_required(const std::string& message, const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    return option->get_name() + ": found nothing, allowed " + allowed_by(*option);
  }
  return message;
}

}  // namespace

std::string describe_parse_error(const CLI::ParseError& error, const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) text = describe_extra(command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) text = describe_mismatch(text, command);
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) text = describe_required(text, command);
  return text + "; see `ballpit " + (chosen.empty() ? "" : command.get_name() + " ") + "--help`";
}

void check_command(int argc, char** argv, const std::vector<std::string_view>& names) {
  const std::string_view found = argc < 2 ? "" : argv[1];
  if (found.starts_with("-h") || found.starts_with("--help") || found.starts_with("--version")) return;
  if (std::find(names.begin(), names.end(), found) != names.end()) return;
  throw UserError("command: found " + (found.empty() ? "nothing" : std::string(found)) + ", allowed " + join(names) +
                  ", --help, --version");
}

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return text;
}

}  // namespace ballpit
