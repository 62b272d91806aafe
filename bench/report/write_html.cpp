#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/markup.h"
#include "bench/report/words.h"

namespace arcway::internal::report {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1d2126; --soft: #5b6470; --line: #d4d9df; --ground: #fff; --panel: #f5f7f9;
  --link: #0b62a8; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8eaed; --soft: #a5adb8; --line: #3c434c; --ground: #16191d; --panel: #1f2329; --link: #6cb6f5; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 1rem; font: 16px/1.5 system-ui, sans-serif; color: var(--ink);
  background: var(--ground); overflow-wrap: break-word; }
a { color: var(--link); }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .6rem 0 .2rem; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .5rem; }
sup { line-height: 0; font-size: .75em; }
.subtitle { color: var(--soft); font-size: .9rem; margin: 0 0 1rem; } .lead { font-size: 1.1rem; max-width: 62rem; }
.summary { background: var(--panel); border-left: 4px solid #0072b2; padding: .6rem 1rem .6rem 2rem; margin: 0; }
.summary li { margin: .35rem 0; }
.gallery { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); gap: 1.5rem 2.5rem;
  margin: 1.2rem 0; }
figure { margin: 0; max-width: 46rem; min-width: 0; } .plot { width: 100%; height: auto; display: block; }
.picture svg { width: 100%; height: auto; max-height: 40rem; display: block; border: 1px solid var(--line); }
figcaption { color: var(--soft); font-size: .9rem; }
.plot text { font-size: 15px; fill: var(--soft); } .grid { stroke: var(--line); } .noisy { fill: var(--ground); }
.level { stroke: var(--ink); stroke-width: 1.5; }
.linear, body.linear-axes .log { display: none; } body.linear-axes .linear { display: inline; }
.legend { list-style: none; padding: 0; margin: .3rem 0 .4rem; display: flex; flex-wrap: wrap; gap: .1rem 1.2rem;
  font-size: .9rem; }
.key { width: 36px; height: 14px; vertical-align: middle; }
nav ul { list-style: none; padding: 0; margin: 0; display: grid; gap: .15rem 2rem;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 21rem), 1fr)); }
.scroll { overflow-x: auto; margin: .6rem 0; } details > summary { cursor: pointer; }
details.section { border-top: 1px solid var(--line); padding: .35rem 0; } details.section[open] { padding-bottom: 1.2rem; }
details.section h2 { display: inline; font-size: 1rem; font-weight: 600; }
table { border-collapse: collapse; font-size: .85rem; } th, td { padding: .2rem .5rem; border-bottom: 1px solid var(--line);
  text-align: left; vertical-align: top; min-width: 3rem; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
td:first-child { min-width: 7rem; } th { vertical-align: bottom; }
pre { background: var(--panel); padding: .6rem 1rem; overflow-x: auto; font-size: .85rem; }
button { font: inherit; padding: .3rem .8rem; color: var(--ink); background: var(--panel); border: 1px solid var(--line);
  border-radius: 4px; cursor: pointer; }
#tip { position: fixed; display: none; max-width: 20rem; padding: .3rem .6rem; font-size: .85rem; color: var(--ground);
  background: var(--ink); border-radius: 4px; pointer-events: none; z-index: 1; }
.print-only { display: none; }
@media (max-width: 500px) { body { padding: .6rem; font-size: 15px; } .lead { font-size: 1rem; }
  .plot text { font-size: 19px; } }
@media print { :root { color-scheme: light; --ink: #1d2126; --soft: #5b6470; --line: #d4d9df; --ground: #fff; --panel: #f5f7f9; }
  html { font-size: 12px; } @page { size: A4; margin: 14mm; }
  button, nav, details:not([open]), #tip { display: none; } .print-only { display: block; }
  figure, .summary li, tr, pre { break-inside: avoid; } h1, h2, thead, p { break-after: avoid; } p, li { orphans: 3; widows: 3; }
  .scroll { overflow: visible; } pre { white-space: pre-wrap; } body { max-width: none; padding: 0; font-size: 9.5pt; } h2 { margin: 1.2rem 0 .3rem; }
  .picture svg { max-height: 56mm; } .gallery { grid-template-columns: 1fr 1fr; gap: .8rem; } .legend, figcaption { font-size: 7.5pt; }
  table { font-size: 6.5pt; width: 100%; } th, td { padding: .1rem .2rem; min-width: 0; } td:first-child { min-width: 0; } }
)";

constexpr const char* kScript = R"(
const button = document.getElementById('axes'), tip = document.getElementById('tip');
if (button) button.onclick = () => {
  const linear = document.body.classList.toggle('linear-axes');
  button.textContent = linear ? 'Logarithmic axes' : 'Linear axes';
};
const show = (mark, x, y) => {
  tip.textContent = mark.dataset.tip;
  tip.style.display = 'block';
  tip.style.left = Math.max(4, Math.min(x + 12, innerWidth - tip.offsetWidth - 4)) + 'px';
  tip.style.top = Math.max(4, y - tip.offsetHeight - 10) + 'px';
};
document.addEventListener('pointerover', e => {
  const mark = e.target.closest('[data-tip]');
  if (mark) show(mark, e.clientX, e.clientY); else tip.style.display = 'none';
});
document.addEventListener('focusin', e => {
  if (!e.target.dataset.tip) return;
  const box = e.target.getBoundingClientRect();
  show(e.target, box.right, box.top);
});
document.addEventListener('focusout', () => tip.style.display = 'none');
)";

constexpr const char *kFindings = "Findings in short", *kFigures = "Further plots", *kFolded = "Every measurement";

/// A cell of numbers breaks behind dashes, crosses, slashes and commas alone, not between a number and its unit.
std::string unbroken(const std::string& cell) {
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const bool breaks = text.ends_with("–") || text.ends_with("×") || text.ends_with('/') || text.ends_with(',');
    text += cell[i] == ' ' && !breaks ? std::string("\u00a0") : std::string(1, cell[i]);
  }
  return text;
}

/// A note in a column of numbers would make the column as wide as itself.
bool is_note(const std::string& text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 && text.find('^') == std::string::npos;
}

std::string table_html(const Table& table) {
  const auto row_html = [&](const std::vector<std::string>& row, const std::string& cell) {
    std::string html = "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool is_number = i >= table.numbers_from && cell == "td" && !is_note(row[i]);
      html += "<" + cell + (i >= table.numbers_from ? " class=\"n\">" : ">") +
              with_superscripts(escaped(is_number ? unbroken(row[i]) : row[i])) + "</" + cell + ">";
    }
    return html + "</tr>\n";
  };
  std::string html = "<div class=\"scroll\"><table><thead>" + row_html(table.header, "th") + "</thead><tbody>\n";
  for (const auto& row : table.rows) html += row_html(row, "td");
  return html + "</tbody></table></div>\n";
}

/// A text of the report in the page.
std::string text_html(const std::string& text) { return with_superscripts(escaped(text)); }

/// What the sentence is about in bold.
std::string sentence_html(const std::string& sentence) {
  const std::size_t colon = sentence.find(": ");
  if (colon == std::string::npos) return text_html(sentence);
  return "<b>" + text_html(sentence.substr(0, colon)) + ":</b> " + text_html(sentence.substr(colon + 2));
}

/// What stands between backquotes as code.
std::string paragraph_html(const std::string& paragraph) {
  std::string html = "<p>" + text_html(paragraph) + "</p>\n";
  bool open = false;
  for (std::size_t at = 0; (at = html.find('`', at)) != std::string::npos; open = !open)
    html.replace(at, 1, open ? "</code>" : "<code>");
  return html;
}

std::string heading_html(const std::string& title) {
  return "<h2 id=\"" + anchor_of(title) + "\">" + escaped(title) + "</h2>";
}

/// Lines stay lines.
std::string code_html(const std::string& code) {
  std::istringstream lines(code);
  std::string html, line;
  while (std::getline(lines, line)) html += escaped(line) + "\n";
  return html;
}

std::string section_html(const Section& section) {
  const std::string heading = heading_html(section.title);
  std::string html =
      section.folded ? "<details class=\"section\"><summary>" + heading + "</summary>\n" : heading + "\n";
  for (const std::string& paragraph : section.paragraphs) html += paragraph_html(paragraph);
  for (const std::string& figure : section.figures) html += figure;
  if (!section.table.rows.empty()) html += table_html(section.table);
  if (!section.code.empty()) html += "<pre>" + code_html(section.code) + "</pre>\n";
  return html + (section.folded ? "</details>\n" : "");
}

std::string gallery_html(const std::vector<std::string>& figures) {
  if (figures.empty()) return {};
  std::string html = "<div class=\"gallery\">\n";
  for (const std::string& figure : figures) html += figure + "\n";
  return html + "</div>\n";
}

std::string links_html(const Document& document) {
  std::string html = "<nav><h2>What follows</h2>\n<ul>\n";
  const auto add = [&](const std::string& title) {
    html += "<li><a href=\"#" + anchor_of(title) + "\">" + escaped(title) + "</a></li>\n";
  };
  add(kFindings);
  if (!document.figures.empty()) add(kFigures);
  for (const Section& section : document.sections)
    if (!section.folded) add(section.title);
  if (std::ranges::any_of(document.sections, &Section::folded)) add(kFolded);
  return html + "</ul></nav>\n";
}

std::string first_page_html(const Document& document) {
  std::string html = "<h1>" + escaped(document.title) + "</h1>\n<p class=\"subtitle\">" + escaped(document.subtitle) +
                     "</p>\n<p class=\"lead\">" + text_html(document.lead) + "</p>\n" +
                     gallery_html(document.pictures) + gallery_html(document.plots);
  if (!document.plots.empty()) html += "<p><button id=\"axes\" type=\"button\">Linear axes</button></p>\n";
  return html + links_html(document);
}

/// What a printed copy lacks.
std::string unprinted_html(const Document& document) {
  const auto folded = std::ranges::count(document.sections, true, &Section::folded);
  if (folded == 0) return {};
  return "<p class=\"print-only\">Not printed: " + std::to_string(folded) +
         " folded sections with every measurement. Open them in the page to print them.</p>\n";
}

}  // namespace

std::string to_html(const Document& document) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><link rel=\"icon\" "
      "href=\"data:,\"><title>" +
      escaped(document.title) + "</title><style>" + kStyle + "</style></head><body>\n" + first_page_html(document) +
      heading_html(kFindings) + "\n<ul class=\"summary\">\n";
  for (const std::string& sentence : document.summary) html += "<li>" + sentence_html(sentence) + "</li>\n";
  html += "</ul>\n";
  if (!document.figures.empty()) html += heading_html(kFigures) + "\n" + gallery_html(document.figures);
  bool has_folded = false;
  for (const Section& section : document.sections) {
    if (section.folded && !has_folded) html += heading_html(kFolded);
    has_folded = has_folded || section.folded;
    html += section_html(section);
  }
  return html + unprinted_html(document) + "<div id=\"tip\" role=\"status\"></div>\n<script>" + kScript +
         "</script>\n</body></html>\n";
}

}  // namespace arcway::internal::report
