#include <string>

#include "bench/report/document.h"

namespace arcway::report {

std::string to_markdown(const Document& document) {
  const auto row_text = [](const std::vector<std::string>& row) {
    std::string text = "|";
    for (const std::string& cell : row) {
      text += " ";
      for (const char c : cell) text += c == '|' ? std::string("\\|") : std::string(1, c);
      text += " |";
    }
    return text + "\n";
  };
  std::string text = "# " + document.title + "\n\n";
  for (const std::string& sentence : document.summary) text += "- " + sentence + "\n";
  for (const Section& section : document.sections) {
    text += "\n## " + section.title + "\n";
    for (const std::string& paragraph : section.paragraphs) text += "\n" + paragraph + "\n";
    if (section.table.rows.empty()) continue;
    text += "\n" + row_text(section.table.header) + "|";
    for (std::size_t i = 0; i < section.table.header.size(); ++i)
      text += i >= section.table.numbers_from ? "---:|" : "---|";
    text += "\n";
    for (const auto& row : section.table.rows) text += row_text(row);
  }
  return text;
}

}  // namespace arcway::report
