#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/report_pictures.h"
#include "bench/report/document.h"

namespace arcway::internal::cli {
namespace {

constexpr const char *kHtml = "report.html", *kMarkdown = "report.md", *kCsv = "report.csv";

struct ReportArguments {
  std::vector<std::string> files, tables;
  std::string out;
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

int report(const ReportArguments& arguments, std::string& out) {
  if (arguments.out.empty() && arguments.tables.empty())
    throw UsageError("report: nothing to write; use --out DIR or --tables F.md");
  report::Inputs inputs = read_inputs(arguments.files);
  std::vector<std::string> targets = arguments.tables;
  const auto in_folder = [&](const char* name) { return (std::filesystem::path(arguments.out) / name).string(); };
  if (!arguments.out.empty()) {
    make_folders(arguments.out);
    for (const char* name : {kHtml, kMarkdown, kCsv}) targets.push_back(in_folder(name));
  }
  OutputFiles files(targets, arguments.files);
  if (!arguments.out.empty()) {
    inputs.pictures = report_pictures(inputs);
    const report::Document document = report::make_document(inputs);
    files.add(in_folder(kHtml), to_html(document));
    files.add(in_folder(kMarkdown), to_markdown(document));
    files.add(in_folder(kCsv), to_csv(inputs.results));
    out += document.lead + "\n";
  }
  for (const std::string& file : arguments.tables) files.add(file, with_tables(read_file(file), inputs, file));
  files.write();
  out += files.summary();
  return kExitSolved;
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
  command->callback(
      [&action, arguments] { action = [arguments](std::string& out) { return report(*arguments, out); }; });
}

}  // namespace arcway::internal::cli
