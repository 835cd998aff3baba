// SPDX-License-Identifier: MIT
// What CLI11 finds wrong with a command line, said as all other errors are: option, what was found, what is
// allowed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace ballpit {

/// One line for a failure to parse the arguments of a command; `app` is the whole program's.
std::string describe_parse_error(const CLI::ParseError& error, const CLI::App& app);

/// CLI11 asks for "a subcommand" where it finds a word that is none; this says which word, and what there is.
/// Throws UserError unless the first argument is one of `names`, or asks for help or the version.
void check_command(int argc, char** argv, const std::vector<std::string_view>& names);

/// `text` without line breaks and other control characters, which would break the line or the terminal.
std::string on_one_line(std::string text);

}  // namespace ballpit
