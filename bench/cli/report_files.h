#pragma once

#include <string>
#include <vector>

#include "bench/cli/output_files.h"
#include "bench/report/document.h"

namespace arcway::internal::cli {

/// The files of a report in a folder.
struct ReportFiles {
  explicit ReportFiles(const std::string& folder);
  [[nodiscard]] std::vector<std::string> all() const { return {html, markdown, csv}; }
  std::string html, markdown, csv;
};

/// Makes a report and adds its files. Returns its first paragraph.
std::string add_report(OutputFiles& files, const ReportFiles& names, const report::Inputs& inputs);

}  // namespace arcway::internal::cli
