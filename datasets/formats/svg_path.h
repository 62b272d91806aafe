#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "arcway/closed_spline.h"

namespace arcway::internal::detail {

/// Numbers and words of an SVG attribute, between blanks and commas.
class SvgAttribute {
 public:
  explicit SvgAttribute(std::string_view text) : text_(text) {}
  bool at_end();
  [[nodiscard]] char peek() const { return text_.front(); }
  char letter();
  std::optional<double> number();
  /// What stands before c, which is passed over.
  std::string_view until(char c);

 private:
  std::string_view text_;
};

/// A subpath: where it begins, and its lines and curves. A line from a to b is the cubic a, a, b, b.
struct SvgSubpath {
  Vec2 first;
  std::vector<CubicBezier> pieces;
  bool curved = false;  ///< whether it has curves
};

/// Reads the data of a path, all commands of SVG 1.1. Quadratic curves are cubics; arcs of ellipses become cubics that
/// leave them by less than 2^-29 of their radius.
/// @throws std::invalid_argument naming the command.
std::vector<SvgSubpath> read_svg_path(std::string_view data);

}  // namespace arcway::internal::detail
