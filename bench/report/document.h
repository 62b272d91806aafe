#pragma once

#include <string>
#include <vector>

#include "bench/report/results.h"

namespace arcway::report {

/// A table of texts; the same content for all formats. Columns from `numbers_from` on are aligned to the right.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t numbers_from = 1;
};

/// A heading with what stands below it: plots for HTML, tables for both.
struct Section {
  std::string title;
  std::vector<std::string> paragraphs;
  std::string figure;  ///< HTML
  Table table;
};

struct Document {
  std::string title;
  std::vector<std::string> summary;
  std::vector<Section> sections;
};

/// The report of one file; of two, the second one's with the changes since the first.
/// @param results  one or two, at least one measurement each.
Document make_document(const std::vector<Results>& results);

/// One page without references to anything outside: styles, plots and script within.
std::string to_html(const Document& document);
std::string to_markdown(const Document& document);
/// `name,repetitions,wall_median_s,wall_min_s,wall_max_s,cpu_median_s,error`, a line a benchmark.
std::string to_csv(const Results& results);

}  // namespace arcway::report
