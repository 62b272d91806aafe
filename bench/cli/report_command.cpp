#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/report_files.h"
#include "bench/cli/report_pictures.h"
#include "bench/report/document.h"
#include "bench/report/gate.h"
#include "core/base/shortest_text.h"

namespace arcway::internal::cli {
namespace {

struct ReportArguments {
  std::vector<std::string> files, tables;
  std::string out;
  bool gate = false;
  std::string gate_counts, gate_times;
};

report::Inputs read_inputs(const std::vector<std::string>& files) {
  std::vector<report::Results> results;
  report::Inputs inputs;
  for (const std::string& file : files) {
    const std::string text = read_file(file), name = std::filesystem::path(file).filename().string();
    if (report::is_peer_results(text)) {
      if (inputs.peers) throw UsageError("report: " + file + " is the second file of arcway_peers");
      inputs.peers = report::read_peer_results(text, name);
      continue;
    }
    results.push_back(report::read_results(text, name));
    if (results.back().measurements.empty()) throw UsageError("report: " + file + " has no benchmarks");
  }
  if (results.empty() || results.size() > 2)
    throw UsageError("report: one file of arcway_bench, or two to compare; got " + std::to_string(results.size()));
  if (results.size() == 2) inputs.before = std::move(results.front());
  inputs.results = std::move(results.back());
  return inputs;
}

/// Reads a share as a percentage: "5%".
double parse_percent(std::string_view text, std::string_view what) {
  if (!text.ends_with('%'))
    throw UsageError(std::string(what) + ": expected a percentage such as 5%, got " + in_quotes(text));
  const double percent = parse_number(text.substr(0, text.size() - 1), what);
  if (percent < 0.0) throw UsageError(std::string(what) + ": at least 0%, got " + in_quotes(text));
  return 0.01 * percent;
}

report::GateLimits gate_limits(const ReportArguments& arguments) {
  report::GateLimits limits;
  for (const auto& [option, text] :
       {std::pair{"--gate-counts", &arguments.gate_counts}, {"--gate-times", &arguments.gate_times}})
    if (!arguments.gate && !text->empty()) throw UsageError(std::string(option) + ": only with --gate");
  if (!arguments.gate_counts.empty()) limits.counts = parse_percent(arguments.gate_counts, "--gate-counts");
  if (!arguments.gate_times.empty()) limits.times = parse_number(arguments.gate_times, "--gate-times");
  if (limits.times < 1.0)
    throw UsageError("--gate-times: a factor of at least 1, got " + in_quotes(arguments.gate_times));
  return limits;
}

int report(const ReportArguments& arguments, std::string& out) {
  const report::GateLimits limits = gate_limits(arguments);
  if (arguments.out.empty() && arguments.tables.empty() && !arguments.gate)
    throw UsageError("report: nothing to write; use --out DIR, --tables F.md or --gate");
  report::Inputs inputs = read_inputs(arguments.files);
  if (arguments.gate && !inputs.before) throw UsageError("--gate: needs two files of arcway_bench, OLD and NEW");
  std::vector<std::string> targets = arguments.tables;
  const ReportFiles names(arguments.out);
  if (!arguments.out.empty()) {
    make_folders(arguments.out);
    for (const std::string& name : names.all()) targets.push_back(name);
  }
  OutputFiles files(targets, arguments.files);
  if (!arguments.out.empty()) {
    inputs.pictures = report_pictures(inputs);
    out += add_report(files, names, inputs);
  }
  for (const std::string& file : arguments.tables) files.add(file, with_tables(read_file(file), inputs, file));
  files.write();
  out += files.summary();
  if (!arguments.gate) return kExitSolved;
  const report::GateFindings findings = report::compare_for_gate(*inputs.before, inputs.results, limits);
  out += report::gate_text(findings, *inputs.before, inputs.results, limits);
  return findings.passed() ? kExitSolved : kExitNoPath;
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("report", "Turn results of arcway_bench into a report");
  const auto arguments = std::make_shared<ReportArguments>();
  command
      ->add_option("results", arguments->files,
                   "JSON of arcway_bench, an earlier one first to compare with, and of arcway_peers")
      ->required();
  command->add_option("--out", arguments->out, "Folder for report.html, report.md and report.csv");
  command->add_option("--tables", arguments->tables,
                      "Markdown files whose tables between <!-- table NAME --> and "
                      "<!-- end of table --> are made anew");
  const report::GateLimits defaults;
  command->add_flag("--gate", arguments->gate,
                    "Exit with 1 if the later file of two has a count or a time that rose beyond its limit, or a "
                    "benchmark that fails now; prints a table of them");
  command
      ->add_option("--gate-counts", arguments->gate_counts,
                   "How much edges, links, expansions, trials, steps, poses, allocations and instructions may rise")
      ->type_name("P%")
      ->default_str(shortest_text(100.0 * defaults.counts) + "%");
  command
      ->add_option("--gate-times", arguments->gate_times,
                   "How often as long the fastest repetition may take, in processor time; longer fails where p < 0.01 "
                   "(Mann-Whitney). Times of different processors are not compared")
      ->type_name("FACTOR")
      ->default_str(shortest_text(defaults.times));
  command->callback(
      [&action, arguments] { action = [arguments](std::string& out) { return report(*arguments, out); }; });
}

}  // namespace arcway::internal::cli
