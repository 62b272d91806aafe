#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "arcway/process_group.h"
#include "bench/cli/arguments.h"
#include "bench/cli/help_files.h"
#include "bench/cli/standard_streams.h"
#include "datasets/io/nearest_word.h"
#include "datasets/io/shortened.h"
#ifdef ARCWAY_WITH_MPI
#include "accel/mpi/mpi_process_group.h"
#endif

namespace {

#ifdef ARCWAY_WITH_MPI
constexpr const char* kName = "arcway_mpi";
#else
constexpr const char* kName = "arcway";
#endif
constexpr std::size_t kMostOfMessage = 10'000;  ///< bytes printed of an error: two paths of the longest, and a sentence
constexpr const char* kDescription = "Time-optimal smooth paths for car-like robots on polygon maps.";
constexpr const char* kFooter =
    "Units: meters, seconds, radians counter-clockwise from +x (or degrees: 90deg).\n"
    "Exit codes: 0 solved, valid or done; 1 no path, not valid, refused, or above a limit of report --gate;\n"
    "2 bad input or usage; 130 a batch or bench that a signal ended, whose finished part is kept.";

/// @throws std::system_error if that fails, as on a disk that is full.
void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot write standard output");
}

/// An empty value is most likely that of a variable which a script has not set.
/// @throws arcway::internal::cli::UsageError naming the option.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands())
    for (const CLI::Option* option : command->get_options())
      for (const std::string& value : option->results())
        if (value.empty()) throw arcway::internal::cli::UsageError(option->get_name() + ": its value is empty");
}

/// Standard input is read once, so that two arguments cannot both be it. Of outputs, any number may be "-".
/// @throws arcway::internal::cli::UsageError naming the second one.
void refuse_repeated_input(const CLI::App& app) {
  const CLI::Option* first = nullptr;
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options()) {
      const std::string name = option->get_name();
      const bool is_input = option->get_positional() || name == "--path" || name == "--robot" || name == "--add" ||
                            (name == "--queries" && command->get_name() != "generate");
      for (const std::string& value : option->results()) {
        if (!is_input || value != "-" || name == "OUT") continue;
        if (first != nullptr)
          throw arcway::internal::cli::UsageError(first->get_name() + " and " + name +
                                                  ": both are standard input, which can be read only once");
        first = option;
      }
    }
  }
}

/// `arcway help plan` as `arcway plan --help`, and `arcway help` as `arcway --help`.
/// @throws arcway::internal::cli::UsageError for help of a command that there is not.
std::vector<std::string> arguments_of(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty() || arguments[0] != "help" || arguments.size() > 2) return arguments;
  if (arguments.size() == 2 && arguments[1].starts_with("-")) return arguments;
  arguments.erase(arguments.begin());
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (!arguments.empty() && std::ranges::find(names, arguments[0]) == names.end()) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string_view nearest = arcway::internal::nearest_word(arguments[0], known);
    throw arcway::internal::cli::UsageError("help: no command " + arcway::internal::cli::in_quotes(arguments[0]) +
                                            (nearest.empty() ? "" : "; did you mean " + std::string(nearest) + "?"));
  }
  arguments.emplace_back("--help");
  return arguments;
}

/// What was meant by words that are neither subcommands nor options; empty if nothing near.
std::string meant_instead(const CLI::App& app) {
  const bool in_command = !app.get_subcommands().empty();
  const CLI::App& command = in_command ? *app.get_subcommands().front() : app;
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  if (!in_command)
    for (const CLI::App* subcommand : app.get_subcommands(nullptr)) known.push_back(subcommand->get_name());
  const std::vector<std::string_view> words(known.begin(), known.end());
  for (const std::string& word : app.remaining(true))
    if (const std::string_view nearest = arcway::internal::nearest_word(word.substr(0, word.find('=')), words);
        !nearest.empty())
      return "Did you mean " + std::string(nearest) + "?\n";
  return "";
}

int run(int argc, char** argv, const arcway::ProcessGroup& process_group) {
  using namespace arcway::internal::cli;
  CLI::App app(kDescription, kName);
  app.footer(kFooter);
  app.set_version_flag("--version", std::string(kName) + " " ARCWAY_VERSION);
  app.require_subcommand(0, 1);  // an unknown one is then named in the message, none at all is checked below
  Action action;
  add_plan_command(app, action, process_group);
  add_prepare_command(app, action, process_group);
#ifndef ARCWAY_WITH_MPI
  add_change_command(app, action);
  add_graph_command(app, action);
  add_generate_command(app, action);
  add_validate_command(app, action);
  add_convert_command(app, action);
  add_doctor_command(app, action);
  add_bench_command(app, action);
  add_report_command(app, action);
  add_figures_command(app, action);
#endif
  add_help_command(app, action);
  for (CLI::App* command : app.get_subcommands(nullptr))
    command->add_flag_callback("-q,--quiet", set_quiet, "Print nothing but errors, and what - asks for");
  try {
    std::vector<std::string> arguments = arguments_of(app, argc, argv);
    std::ranges::reverse(arguments);  // as CLI11 takes them
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    const int code = app.exit(error, out, err);
    if (process_group.rank() > 0) return code == 0 ? kExitSolved : kExitBadInput;
    if (code != 0) {
      std::fprintf(stderr, "%s: %s%s", kName, arcway::internal::shortened(err.str(), kMostOfMessage).c_str(),
                   meant_instead(app).c_str());
      return kExitBadInput;
    }
    print(out.str());
    return kExitSolved;
  }
  refuse_empty_values(app);
  refuse_repeated_input(app);
  if (!action) throw UsageError("a subcommand is required; --help names them");
  std::string text;
  const int code = action(text);
  if (process_group.rank() > 0 || is_quiet()) return code;
  text = with_stream_names(std::move(text));
  if (writes_data_to_standard_output()) {
    std::fputs(text.c_str(), stderr);
  } else {
    print(text);
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file above the limit of sizes is an error as any other
#ifdef ARCWAY_WITH_MPI
  const arcway::internal::MpiProcessGroup process_group;
#else
  const arcway::SingleProcess process_group;
#endif
  try {
    return run(argc, argv, process_group);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: out of memory\n", kName);
  } catch (const std::exception& error) {
    const std::string message = arcway::internal::cli::with_stream_names(error.what());
    std::fprintf(stderr, "%s: %s\n", kName, arcway::internal::shortened(message, kMostOfMessage).c_str());
  }
#ifdef ARCWAY_WITH_MPI
  process_group.abort(arcway::internal::cli::kExitBadInput);  // the others would wait for this process
#else
  return arcway::internal::cli::kExitBadInput;
#endif
}
