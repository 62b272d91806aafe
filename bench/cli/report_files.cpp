#include "bench/cli/report_files.h"

#include <filesystem>

namespace arcway::internal::cli {

ReportFiles::ReportFiles(const std::string& folder)
    : html((std::filesystem::path(folder) / "report.html").string()),
      markdown((std::filesystem::path(folder) / "report.md").string()),
      csv((std::filesystem::path(folder) / "report.csv").string()) {}

std::string add_report(OutputFiles& files, const ReportFiles& names, const report::Inputs& inputs) {
  const report::Document document = report::make_document(inputs);
  files.add(names.html, to_html(document));
  files.add(names.markdown, to_markdown(document));
  files.add(names.csv, to_csv(inputs.results));
  return document.lead + "\n";
}

}  // namespace arcway::internal::cli
