#include <cctype>
#include <string>

#include "bench/report/document.h"
#include "bench/report/markup.h"

namespace arcway::internal::report {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1d2126; --soft: #5b6470; --line: #d4d9df; --ground: #fff; --panel: #f5f7f9; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8eaed; --soft: #a5adb8; --line: #3c434c; --ground: #16191d; --panel: #1f2329; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 1rem; font: 16px/1.5 system-ui, sans-serif; color: var(--ink);
  background: var(--ground); }
h1 { font-size: 1.5rem; line-height: 1.25; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .5rem; }
.summary { background: var(--panel); border-left: 4px solid #0072b2; padding: .6rem 1rem .6rem 2rem; margin: 0; }
.summary li { margin: .35rem 0; }
.gallery { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); gap: 1.5rem 2.5rem; }
figure { margin: 0; max-width: 46rem; } .plot { width: 100%; height: auto; display: block; }
figcaption { color: var(--soft); font-size: .9rem; }
.plot text { font-size: 15px; fill: var(--soft); } .grid { stroke: var(--line); }
.noisy { fill: var(--ground); }
.level { stroke: var(--ink); stroke-width: 1.5; }
.linear, body.linear-axes .log { display: none; } body.linear-axes .linear { display: inline; }
.legend { list-style: none; padding: 0; margin: .3rem 0 .4rem; display: flex; flex-wrap: wrap; gap: .1rem 1.2rem;
  font-size: .9rem; }
.key { width: 36px; height: 14px; vertical-align: middle; }
.scroll { overflow-x: auto; margin: .6rem 0; } details > summary { cursor: pointer; }
details.section { border-top: 1px solid var(--line); padding: .35rem 0; } details.section[open] { padding-bottom: 1.2rem; }
details.section h2 { display: inline; font-size: 1rem; font-weight: 600; }
table { border-collapse: collapse; font-size: .85rem; } th, td { padding: .2rem .6rem; border-bottom: 1px solid var(--line);
  text-align: left; vertical-align: top; } td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.note { white-space: normal; }
button { font: inherit; padding: .3rem .8rem; color: var(--ink); background: var(--panel); border: 1px solid var(--line);
  border-radius: 4px; cursor: pointer; }
#tip { position: fixed; display: none; max-width: 20rem; padding: .3rem .6rem; font-size: .85rem; color: var(--ground);
  background: var(--ink); border-radius: 4px; pointer-events: none; z-index: 1; }
@media (max-width: 500px) { body { padding: .6rem; font-size: 15px; } .plot text { font-size: 19px; } }
@media print { button { display: none; } figure, .summary, tr { break-inside: avoid; } h2 { break-after: avoid; }
  .scroll { overflow: visible; } body { max-width: none; padding: 0; font-size: 10pt; }
  .gallery { grid-template-columns: 1fr 1fr; gap: 1rem; } .legend, figcaption { font-size: 7.5pt; }
  table { font-size: 6.5pt; } th, td { padding: .1rem .3rem; } td.n, th.n { white-space: normal; } }
)";

constexpr const char* kScript = R"(
const button = document.getElementById('axes'), tip = document.getElementById('tip');
button.onclick = () => {
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
addEventListener('beforeprint', () => document.querySelectorAll('details').forEach(d => d.open = true));
)";

/// A note in a column of numbers would make the column as wide as itself.
bool is_note(const std::string& text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0;
}

std::string table_html(const Table& table) {
  const auto row_html = [&](const std::vector<std::string>& row, const std::string& cell) {
    std::string html = "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      html += "<" + cell +
              (i < table.numbers_from ? ">"
               : is_note(row[i])      ? " class=\"n note\">"
                                      : " class=\"n\">") +
              escaped(row[i]) + "</" + cell + ">";
    return html + "</tr>\n";
  };
  std::string html = "<div class=\"scroll\"><table><thead>" + row_html(table.header, "th") + "</thead><tbody>\n";
  for (const auto& row : table.rows) html += row_html(row, "td");
  return html + "</tbody></table></div>\n";
}

/// What the sentence is about in bold.
std::string sentence_html(const std::string& sentence) {
  const std::size_t colon = sentence.find(": ");
  if (colon == std::string::npos) return escaped(sentence);
  return "<b>" + escaped(sentence.substr(0, colon)) + ":</b> " + escaped(sentence.substr(colon + 2));
}

/// What stands between backquotes as code.
std::string paragraph_html(const std::string& paragraph) {
  std::string html = "<p>" + escaped(paragraph) + "</p>\n";
  bool open = false;
  for (std::size_t at = 0; (at = html.find('`', at)) != std::string::npos; open = !open)
    html.replace(at, 1, open ? "</code>" : "<code>");
  return html;
}

std::string section_html(const Section& section) {
  std::string html = section.folded
                         ? "<details class=\"section\"><summary><h2>" + escaped(section.title) + "</h2></summary>\n"
                         : "<h2>" + escaped(section.title) + "</h2>\n";
  for (const std::string& paragraph : section.paragraphs) html += paragraph_html(paragraph);
  for (const std::string& figure : section.figures) html += figure;
  if (!section.table.rows.empty()) html += table_html(section.table);
  return html + (section.folded ? "</details>\n" : "");
}

}  // namespace

std::string to_html(const Document& document) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><link rel=\"icon\" "
      "href=\"data:,\"><title>" +
      escaped(document.title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" + escaped(document.title) +
      "</h1>\n<ul class=\"summary\">\n";
  for (const std::string& sentence : document.summary) html += "<li>" + sentence_html(sentence) + "</li>\n";
  html += "</ul>\n<p><button id=\"axes\" type=\"button\">Linear axes</button></p>\n<div class=\"gallery\">\n";
  for (const std::string& figure : document.figures) html += figure + "\n";
  html += "</div>\n";
  for (const Section& section : document.sections) html += section_html(section);
  return html + "<div id=\"tip\" role=\"status\"></div>\n<script>" + kScript + "</script>\n</body></html>\n";
}

}  // namespace arcway::internal::report
