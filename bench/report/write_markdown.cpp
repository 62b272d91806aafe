#include <algorithm>
#include <sstream>
#include <string>

#include "arcway/datasets/file_io.h"
#include "bench/report/document.h"
#include "bench/report/findings.h"
#include "bench/report/markup.h"
#include "bench/report/peer_sections.h"
#include "bench/report/strategy_sections.h"
#include "bench/report/vehicle_sections.h"

namespace arcway::internal::report {
namespace {

std::string row_text(const std::vector<std::string>& row) {
  std::string text = "|";
  for (const std::string& cell : row) {
    text += " ";
    for (const char c : with_superscripts(cell)) text += c == '|' ? std::string("\\|") : std::string(1, c);
    text += " |";
  }
  return text + "\n";
}

Table named_table(const std::string& name, const Inputs& inputs, const std::string& place) {
  const auto peers = [&]() -> const PeerResults& {
    if (!inputs.peers) throw FormatError(place + ": the table \"" + name + "\" needs a file of arcway_peers");
    return *inputs.peers;
  };
  if (name == "vehicles") return vehicles_section(inputs.results, studies_of(inputs.results)).table;
  if (name == "cost") return cost_section(studies_of(inputs.results)).table;
  if (name == "ablation") return ablation_section(inputs.results).table;
  if (name == "strategy") return strategy_section(inputs.results).table;
  if (name == "moves") return moves_section(inputs.results).table;
  if (name == "gear moves") return gear_moves_section(inputs.results).table;
  if (name == "duels") return duels_section(peers()).table;
  if (name == "claims") return claims_section(peers()).table;
  if (name == "losses") return losses_section(peers()).table;
  if (name == "planners") return planners_section(peers()).table;
  throw FormatError(place + ": there is no table \"" + name + "\"");
}

}  // namespace

std::string to_markdown(const Table& table) {
  std::string text = row_text(table.header) + "|";
  for (std::size_t i = 0; i < table.header.size(); ++i) text += i >= table.numbers_from ? "---:|" : "---|";
  text += "\n";
  for (const auto& row : table.rows) text += row_text(row);
  return text;
}

std::string to_markdown(const Document& document) {
  std::string text = "# " + document.title + "\n\n" + document.subtitle + "\n\n" + with_superscripts(document.lead) +
                     "\n\n## Findings\n\n";
  for (const std::string& sentence : document.summary) text += "- " + with_superscripts(sentence) + "\n";
  for (const Section& section : document.sections) {
    text += "\n## " + section.title + "\n";
    for (const std::string& paragraph : section.paragraphs) text += "\n" + with_superscripts(paragraph) + "\n";
    if (!section.table.rows.empty()) text += "\n" + to_markdown(section.table);
    if (!section.code.empty()) text += "\n```\n" + section.code + "```\n";
  }
  return text;
}

std::string with_tables(const std::string& markdown, const Inputs& inputs, const std::string& name) {
  constexpr std::string_view kBegin = "<!-- table ", kClose = " -->", kEnd = "<!-- end of table -->";
  std::istringstream lines(markdown);
  std::string result, line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    result += line + "\n";
    if (!line.starts_with(kBegin) || !line.ends_with(kClose)) continue;
    const std::string place = name + ":" + std::to_string(number);
    const std::string table = line.substr(kBegin.size(), line.size() - kBegin.size() - kClose.size());
    result += to_markdown(without_fillers(named_table(table, inputs, place)));
    while (line != kEnd) {
      if (!std::getline(lines, line))
        throw FormatError(place + ": the table has no line \"" + std::string(kEnd) + "\"");
      ++number;
    }
    result += line + "\n";
  }
  return result;
}

}  // namespace arcway::internal::report
