#include "datasets/pictures/svg_text.h"

#include <charconv>
#include <cmath>

namespace arcway::internal {

void append(std::string& out, double value, double parts) {
  const double rounded = std::round(value * parts);
  char buffer[32];
  const char* end = std::to_chars(buffer, buffer + sizeof buffer, rounded == 0.0 ? 0.0 : rounded / parts).ptr;
  out.append(static_cast<const char*>(buffer), end);
}

void append(std::string& out, const Vec2& p) {
  append(out, p.x());
  out += ' ';
  append(out, p.y());
}

std::string open_layer(const std::string& id, const std::string& attributes) {
  return "<g id=\"" + id + "\" " + attributes + R"( inkscape:groupmode="layer" inkscape:label=")" + id + "\">\n";
}

std::string square(std::string_view color) { return "<tspan fill=\"" + std::string(color) + "\">\u25A0</tspan> "; }

}  // namespace arcway::internal
