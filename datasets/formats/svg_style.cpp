#include "datasets/formats/svg_style.h"

#include <algorithm>
#include <utility>

namespace arcway::internal::detail {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string without_comments(std::string_view css) {
  std::string text;
  while (true) {
    const std::size_t begin = css.find("/*");
    text += css.substr(0, begin);
    if (begin == std::string_view::npos) return text;
    const std::size_t end = css.find("*/", begin + 2);
    if (end == std::string_view::npos) return text;
    css.remove_prefix(end + 2);
    text += ' ';
  }
}

// From the opening brace to the one that closes it, or to the end.
std::size_t end_of_block(std::string_view css, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < css.size(); ++at) {
    if (css[at] == '{') ++depth;
    if (css[at] == '}' && --depth == 0) return at;
  }
  return css.size();
}

bool has_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    words = trimmed(words);
    const std::size_t end = std::min(words.find_first_of(kBlanks), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(end);
  }
  return false;
}

struct Declaration {
  std::string_view property, value;
  bool important = false;
};

// Calls `take` with every declaration of "display: none; fill: red".
template <class Take>
void for_declarations(std::string_view text, Take take) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    Declaration found{trimmed(one.substr(0, colon)), trimmed(one.substr(colon + 1))};
    if (const std::size_t mark = found.value.find('!'); mark != std::string_view::npos) {
      found.important = trimmed(found.value.substr(mark + 1)) == "important";
      found.value = trimmed(found.value.substr(0, mark));
    }
    take(found);
  }
}

bool may_hide(std::string_view property) { return property == "display" || property == "visibility"; }

}  // namespace

SvgStyle::SvgStyle(const pugi::xml_node& root) {
  const auto is_style = [](const pugi::xml_node& node) { return local_name(node) == "style"; };
  for (pugi::xml_node node = root; node;) {
    if (is_style(node)) {
      std::string css;
      for (const pugi::xml_node& part : node.children()) css += part.value();
      read_sheet(without_comments(css));
    }
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node != root && !node.next_sibling()) node = node.parent();
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
  std::ranges::stable_sort(rules_, {}, [](const Rule& rule) { return std::pair(rule.important, rule.specificity); });
}

void SvgStyle::read_sheet(std::string_view css) {
  while (true) {
    css = trimmed(css);
    const std::size_t open = css.find('{');
    if (css.starts_with('@')) {
      const std::size_t end = css.find(';');
      if (end < open) {  // as @import and @charset
        css.remove_prefix(end + 1);
        continue;
      }
    }
    if (open == std::string_view::npos) return;
    const std::size_t close = end_of_block(css, open);
    const std::string_view head = trimmed(css.substr(0, open)), body = css.substr(open + 1, close - open - 1);
    if (!head.starts_with('@')) {
      read_rule(head, body);
    } else if (head.starts_with("@media") && head.find("print") == std::string_view::npos) {
      read_sheet(body);
    }
    css.remove_prefix(std::min(close + 1, css.size()));
  }
}

void SvgStyle::read_rule(std::string_view selectors, std::string_view declarations) {
  for_declarations(declarations, [&](const Declaration& found) {
    if (!may_hide(found.property)) return;
    for (std::string_view rest = selectors; !rest.empty();) {
      const std::size_t end = std::min(rest.find(','), rest.size());
      const std::string_view one = trimmed(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      Rule rule{{}, 0, std::string(found.property), std::string(found.value), found.important};
      if (read_selector(one, rule)) {
        rules_.push_back(std::move(rule));
      } else {
        unknown_.emplace_back(one);
      }
    }
  });
}

bool SvgStyle::read_selector(std::string_view text, Rule& rule) {
  constexpr int kId = 10000, kClass = 100, kType = 1;  // weights that no number of lighter ones makes up for
  bool child = false;
  while (!(text = trimmed(text)).empty()) {
    if (text.front() == '>') {
      if (rule.compounds.empty() || std::exchange(child, true)) return false;
      text.remove_prefix(1);
      continue;
    }
    Compound& compound = rule.compounds.emplace_back();
    compound.child = std::exchange(child, false);
    const std::size_t end = std::min(text.find_first_of(" \t\r\n\f>"), text.size());
    std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    while (!word.empty()) {
      const char mark = word.front();
      const std::size_t from = mark == '.' || mark == '#' ? 1 : 0;
      const std::string_view name = word.substr(from, word.find_first_of(".#", from) - from);
      if (name.empty() || name.find_first_of("[]:+~()\"'\\|") != std::string_view::npos) return false;
      word.remove_prefix(from + name.size());
      if (mark == '.') {
        compound.classes.emplace_back(name);
        rule.specificity += kClass;
      } else if (mark == '#') {
        compound.id = name;
        rule.specificity += kId;
      } else if (name != "*") {
        compound.type = name;
        rule.specificity += kType;
      }
    }
  }
  return !rule.compounds.empty() && !child;
}

bool SvgStyle::is(const Compound& compound, const pugi::xml_node& node) {
  if (!compound.type.empty() && compound.type != local_name(node)) return false;
  if (!compound.id.empty() && compound.id != node.attribute("id").value()) return false;
  const std::string_view classes = node.attribute("class").value();
  return std::ranges::all_of(compound.classes, [&](const std::string& name) { return has_word(classes, name); });
}

bool SvgStyle::matches(const std::vector<Compound>& compounds, const pugi::xml_node& node) {
  if (!is(compounds.back(), node)) return false;
  std::vector<pugi::xml_node> chain;  // from the root
  for (pugi::xml_node above = node; above.type() == pugi::node_element; above = above.parent()) chain.push_back(above);
  std::ranges::reverse(chain);
  // Whether compounds 0 to i match with the last of them at the parent, or at any element above.
  std::vector<char> at_parent(compounds.size(), 0), above(compounds.size(), 0);
  for (const pugi::xml_node& element : chain) {
    std::vector<char> here(compounds.size(), 0);
    for (std::size_t i = 0; i < compounds.size(); ++i)
      here[i] = (i == 0 || (compounds[i].child ? at_parent : above)[i - 1] != 0) && is(compounds[i], element) ? 1 : 0;
    for (std::size_t i = 0; i < compounds.size(); ++i) above[i] = above[i] != 0 || here[i] != 0 ? 1 : 0;
    at_parent = std::move(here);
  }
  return at_parent.back() != 0;
}

std::string_view SvgStyle::value_of(const pugi::xml_node& node, std::string_view property) const {
  std::string_view value = trimmed(node.attribute(std::string(property).c_str()).value());
  bool inline_wins = true;
  for (const Rule& rule : rules_) {
    if (rule.property != property || !matches(rule.compounds, node)) continue;
    value = rule.value;
    if (rule.important) inline_wins = false;
  }
  for_declarations(node.attribute("style").value(), [&](const Declaration& found) {
    if (found.property == property && (inline_wins || found.important)) value = found.value;
  });
  return value;
}

SvgStyle::Display SvgStyle::display(const pugi::xml_node& node) const {
  return value_of(node, "display") == "none" ? Display::kNone : Display::kShown;
}

bool SvgStyle::visible(const pugi::xml_node& node, bool inherited) const {
  const std::string_view value = value_of(node, "visibility");
  if (value == "hidden" || value == "collapse") return false;
  return value == "visible" || value == "initial" ? true : inherited;
}

}  // namespace arcway::internal::detail
