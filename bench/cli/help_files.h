#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "bench/cli/arguments.h"

namespace arcway::internal::cli {

/// `arcway help --man`, `--bash` and `--zsh` print what is installed beside the tool. `arcway help COMMAND` is replaced
/// by `arcway COMMAND --help` before the command line is read.
void add_help_command(CLI::App& app, Action& action);

/// A manual page in section 1 of all commands and their options.
std::string man_page(const CLI::App& app);
/// A file for bash-completion: subcommands, options, files.
std::string bash_completion(const CLI::App& app);
/// A function _NAME for zsh.
std::string zsh_completion(const CLI::App& app);

}  // namespace arcway::internal::cli
