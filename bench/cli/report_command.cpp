#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/cli/arguments.h"
#include "bench/report/document.h"
#include "datasets/file_io.h"

namespace arcway::cli {
namespace {

struct ReportArguments {
  std::vector<std::string> files;
  std::string out;
};

int report(const ReportArguments& arguments, std::string& out) {
  if (arguments.files.size() > 2) throw UsageError("report: one file of results, or two to compare");
  std::vector<report::Results> results;
  for (const std::string& file : arguments.files) {
    results.push_back(report::read_results(read_file(file), std::filesystem::path(file).filename().string()));
    if (results.back().measurements.empty()) throw UsageError("report: " + file + " has no benchmarks");
  }
  const report::Document document = report::make_document(results);
  const std::filesystem::path folder = arguments.out;
  std::filesystem::create_directories(folder);
  OutputFiles files;
  files.add((folder / "report.html").string(), to_html(document));
  files.add((folder / "report.md").string(), to_markdown(document));
  files.add((folder / "report.csv").string(), to_csv(results.back()));
  files.write();
  for (const std::string& sentence : document.summary) out += "- " + sentence + "\n";
  out += files.summary();
  return kExitSolved;
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("report", "Turn results of arcway_bench into a report");
  const auto arguments = std::make_shared<ReportArguments>();
  command->add_option("results", arguments->files, "Google Benchmark's JSON; a second file is compared with the first")
      ->required();
  command->add_option("--out", arguments->out, "Folder for report.html, report.md and report.csv")->required();
  command->callback(
      [&action, arguments] { action = [arguments](std::string& out) { return report(*arguments, out); }; });
}

}  // namespace arcway::cli
