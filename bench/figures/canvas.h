#pragma once

#include <string>
#include <string_view>

#include "arcway/vec2.h"

namespace arcway::internal::figures {

/// An SVG drawing in units of its own, y up. Its white background reads the same on light and dark pages. The caption
/// stands below, broken into lines at '\n'.
class Canvas {
 public:
  /// A drawing of the box from `min` to `max`.
  /// @param scale  pixels a unit of each axis.
  Canvas(const Vec2& min, const Vec2& max, const Vec2& scale);

  // What is added later lies above. Widths are in pixels.
  void line(const Vec2& a, const Vec2& b, std::string_view color, double width = 2.0, std::string_view dash = {});
  void polygon(const std::string& points, std::string_view fill, std::string_view stroke, double opacity = 1.0);
  void curve(const std::string& points, std::string_view color, double width = 2.5, std::string_view dash = {});
  void dot(const Vec2& p, std::string_view color);
  void circle(const Vec2& center, double radius, std::string_view color, std::string_view dash = {});
  void text(const Vec2& p, std::string_view text, std::string_view anchor = "middle",
            std::string_view color = "#1d2126");
  /// An element of the caller's own, in pixels with y down: see `at`.
  void element(std::string_view text) { body_ += text; }
  /// A point as the text "x,y " in pixels, of which `polygon` and `curve` take several in a row.
  [[nodiscard]] std::string at(const Vec2& p) const;
  /// A point in pixels, y down.
  [[nodiscard]] Vec2 pixels(const Vec2& p) const { return place(p); }
  /// The drawing as SVG.
  [[nodiscard]] std::string str(std::string_view title, std::string_view caption) const;

 private:
  [[nodiscard]] Vec2 place(const Vec2& p) const;
  Vec2 min_, max_, scale_;
  std::string body_;
};

}  // namespace arcway::internal::figures
