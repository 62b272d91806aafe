#include "bench/figures/canvas.h"

#include <algorithm>
#include <cstdio>

namespace arcway::internal::figures {
namespace {

constexpr double kBorder = 30.0;
constexpr double kLine = 22.0;  // height of a line of text

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string dashed(std::string_view dash) {
  return dash.empty() ? std::string() : " stroke-dasharray=\"" + std::string(dash) + "\"";
}

}  // namespace

Canvas::Canvas(const Vec2& min, const Vec2& max, const Vec2& scale) : min_(min), max_(max), scale_(scale) {}

Vec2 Canvas::place(const Vec2& p) const {
  return {kBorder + (p.x() - min_.x()) * scale_.x(), kBorder + (max_.y() - p.y()) * scale_.y()};
}

std::string Canvas::at(const Vec2& p) const { return number(place(p).x()) + "," + number(place(p).y()) + " "; }

void Canvas::line(const Vec2& a, const Vec2& b, std::string_view color, double width, std::string_view dash) {
  curve(at(a) + at(b), color, width, dash);
}

void Canvas::polygon(const std::string& points, std::string_view fill, std::string_view stroke, double opacity) {
  body_ += "<polygon points=\"" + points + "\" fill=\"" + std::string(fill) + "\" stroke=\"" + std::string(stroke) +
           "\" stroke-width=\"1.5\" fill-opacity=\"" + number(opacity) + "\"/>\n";
}

void Canvas::curve(const std::string& points, std::string_view color, double width, std::string_view dash) {
  body_ += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + std::string(color) + "\" stroke-width=\"" +
           number(width) + "\"" + dashed(dash) + "/>\n";
}

void Canvas::dot(const Vec2& p, std::string_view color) {
  body_ += "<circle cx=\"" + number(place(p).x()) + "\" cy=\"" + number(place(p).y()) + "\" r=\"5\" fill=\"" +
           std::string(color) + "\"/>\n";
}

void Canvas::circle(const Vec2& center, double radius, std::string_view color, std::string_view dash) {
  body_ += "<circle cx=\"" + number(place(center).x()) + "\" cy=\"" + number(place(center).y()) + "\" r=\"" +
           number(radius * scale_.x()) + "\" fill=\"none\" stroke=\"" + std::string(color) + "\" stroke-width=\"2\"" +
           dashed(dash) + "/>\n";
}

void Canvas::text(const Vec2& p, std::string_view text, std::string_view anchor, std::string_view color) {
  body_ += "<text x=\"" + number(place(p).x()) + "\" y=\"" + number(place(p).y()) + "\" text-anchor=\"" +
           std::string(anchor) + "\" fill=\"" + std::string(color) + "\">" + std::string(text) + "</text>\n";
}

std::string Canvas::str(std::string_view title, std::string_view caption) const {
  std::string lines;
  const Vec2 corner = place({max_.x(), min_.y()});
  double y = corner.y() + kBorder;
  for (std::size_t from = 0; from <= caption.size();) {
    const std::size_t to = std::min(caption.find('\n', from), caption.size());
    lines += "<text x=\"" + number(kBorder) + "\" y=\"" + number(y) + "\" fill=\"#1d2126\">" +
             std::string(caption.substr(from, to - from)) + "</text>\n";
    y += kLine;
    from = to + 1;
  }
  const std::string width = number(corner.x() + kBorder), height = number(y);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + " " + height + "\" width=\"" + width +
         "\" height=\"" + height + "\" font-family=\"sans-serif\" font-size=\"16\">\n<title>" + std::string(title) +
         "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + body_ + lines + "</svg>\n";
}

}  // namespace arcway::internal::figures
