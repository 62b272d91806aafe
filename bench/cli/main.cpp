#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>

#include "bench/cli/arguments.h"

namespace {

constexpr const char* kDescription = "Time-optimal smooth paths for car-like robots on polygon maps.";
constexpr const char* kFooter =
    "Units: metres, seconds, radians counter-clockwise from +x (or degrees: 90deg).\n"
    "Exit codes: 0 solved, 1 no path, 2 bad input or usage.";

int run(int argc, char** argv) {
  using namespace arcway::cli;
  CLI::App app(kDescription, "arcway");
  app.footer(kFooter);
  app.require_subcommand(1);
  Action action;
  add_plan_command(app, action);
  add_prepare_command(app, action);
  add_graph_command(app, action);
  add_generate_command(app, action);
  add_validate_command(app, action);
  add_convert_command(app, action);
  add_doctor_command(app, action);
  add_report_command(app, action);
  add_figures_command(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    const int code = app.exit(error, out, err);
    std::fputs(out.str().c_str(), code == 0 ? stdout : stderr);
    std::fputs(err.str().c_str(), stderr);
    return code == 0 ? kExitSolved : kExitBadInput;
  }
  std::string text;
  const int code = action(text);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return std::fflush(stdout) == 0 ? code : kExitBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("arcway: out of memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "arcway: %s\n", error.what());
  }
  return arcway::cli::kExitBadInput;
}
