#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace arcway::internal::detail {

/// Whether elements of an SVG drawing are shown: `display` and `visibility`, as attributes, in `style`, or by the rules
/// of <style> elements [SVG 1.1, sections 6 and 11.5]. Selectors of types, classes, ids and *, with descendants and
/// children, are understood; the media are those of a screen.
class SvgStyle {
 public:
  /// Reads all <style> elements below the root.
  explicit SvgStyle(const pugi::xml_node& root);

  enum class Display { kShown, kNone };
  /// Value of `display` of an element. With kNone, none of its contents is shown, whatever their own value.
  [[nodiscard]] Display display(const pugi::xml_node& node) const;
  /// Value of `visibility` of an element, whose parent's is `inherited`.
  [[nodiscard]] bool visible(const pugi::xml_node& node, bool inherited) const;
  /// Selectors that may hide something and are not understood.
  [[nodiscard]] const std::vector<std::string>& unknown_selectors() const { return unknown_; }

 private:
  /// One element's part of a selector: "g.hidden#walls".
  struct Compound {
    std::string type, id;  // empty: any
    std::vector<std::string> classes;
    bool child = false;  // a child of the compound before; else any descendant
  };
  struct Rule {
    std::vector<Compound> compounds;  // the last one is the element's
    int specificity = 0;
    std::string property, value;
    bool important = false;
  };

  void read_sheet(std::string_view css);
  void read_rule(std::string_view selectors, std::string_view declarations);
  static bool read_selector(std::string_view text, Rule& rule);
  static bool is(const Compound& compound, const pugi::xml_node& node);
  /// Whether a selector matches an element. O(compounds * depth of the element).
  static bool matches(const std::vector<Compound>& compounds, const pugi::xml_node& node);
  /// The value that wins the cascade; empty if nothing sets the property.
  [[nodiscard]] std::string_view value_of(const pugi::xml_node& node, std::string_view property) const;

  std::vector<Rule> rules_;  // by rising weight
  std::vector<std::string> unknown_;
};

}  // namespace arcway::internal::detail
