#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/report/peer_results.h"
#include "bench/report/results.h"

namespace arcway::internal::report {

/// A table of texts; the same content for all formats. Columns from `numbers_from` on are aligned to the right.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t numbers_from = 1;
};

/// A heading with what stands below it, in this order.
struct Section {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<std::string> figures;  ///< HTML
  Table table;
  std::string code = {};  ///< shown as it is
  bool folded = false;    ///< the page shows its title alone until asked for more; not printed
};

/// What a report is made from.
struct Inputs {
  Results results;
  std::optional<Results> before;           ///< an earlier run, to compare with
  std::optional<PeerResults> peers;        ///< what arcway_peers found
  std::vector<std::string> pictures = {};  ///< of plans, HTML; the results have no paths
};

struct Document {
  std::string title;
  std::string subtitle;               ///< what was measured where: files, commits, machines
  std::string lead;                   ///< for a stranger
  std::vector<std::string> pictures;  ///< of plans, HTML
  std::vector<std::string> plots;     ///< at most two to look at first, HTML
  std::vector<std::string> summary;   ///< sentences that start with what they are about and a colon
  std::vector<std::string> figures;   ///< further plots, HTML
  std::vector<Section> sections;
};

/// The table without the columns that have nothing but dashes. The first column stays.
Table without_fillers(Table table);

/// The report: a first page for a stranger, then findings and tables, then everything.
/// @param inputs  at least one measurement in `results`.
Document make_document(const Inputs& inputs);

/// One page without references to anything outside: styles, plots and script within.
std::string to_html(const Document& document);
std::string to_markdown(const Document& document);
std::string to_markdown(const Table& table);
/// `name,repetitions,wall_median_s,wall_min_s,wall_max_s,cpu_median_s,noise,error`, a line a benchmark.
std::string to_csv(const Results& results);

/// A Markdown text with its tables made anew: what stands between lines `<!-- table NAME -->` and `<!-- end of table
/// -->`. Names: "vehicles", "cost", "ablation", "strategy", "moves", "gear moves", "duels", "claims", "losses",
/// "planners".
/// @throws FormatError for an unknown name or an end that is missing, naming `name` and the line.
std::string with_tables(const std::string& markdown, const Inputs& inputs, const std::string& name);

}  // namespace arcway::internal::report
