#include "datasets/pictures/zone_style.h"

#include <array>
#include <variant>
#include <vector>

#include "arcway/angle.h"
#include "core/model/pose_text.h"
#include "datasets/io/markup_text.h"

namespace arcway::internal {
namespace {

constexpr double kHatch = 9.0;        // between lines of a hatching [px]
constexpr double kHatchLine = 1.6;    // their width [px]
constexpr double kArrow = 16.0;       // length of an arrow of a zone's direction [px]
constexpr double kArrowHead = 4.0;    // half the width of its head [px]
constexpr double kArrowAlong = 26.0;  // from arrow to arrow, along and aside [px]
constexpr double kArrowAside = 14.0;

// The angle of the lines that hatch a role [degrees]: each has its own.
double slant_of(const Zone& zone) {
  if (std::holds_alternative<KeepOut>(zone.rule)) return 45.0;
  return std::holds_alternative<SpeedLimit>(zone.rule) ? -45.0 : 0.0;
}

// A pattern's cell [px], turned by an angle [degrees], with a path in it.
struct Cell {
  double width, height, turned;
  std::string path;
};

std::string pattern(const Cell& cell, const Zone& zone, const std::string& id, double scale) {
  return "<pattern id=\"" + id + "\" patternUnits=\"userSpaceOnUse\" width=\"" + shortest_text(cell.width / scale) +
         "\" height=\"" + shortest_text(cell.height / scale) + "\" patternTransform=\"rotate(" +
         rounded_text(cell.turned) + ")\"><path fill=\"none\" d=\"" + cell.path + "\" stroke=\"" +
         std::string(zone_color(zone)) + "\" stroke-width=\"" + shortest_text(kHatchLine / scale) + "\"/></pattern>\n";
}

}  // namespace

// Colors of Okabe and Ito: vermilion for zones to stay out of, orange for those to drive slowly in. Purple for those to
// drive in one direction, sky blue for those to keep a distance in.
std::string_view zone_color(const Zone& zone) {
  constexpr std::array<std::string_view, std::variant_size_v<ZoneRule>> kColors{"#d55e00", "#e69f00", "#cc79a7",
                                                                                "#56b4e9"};
  return kColors[zone.rule.index()];
}

std::string zone_pattern(const Zone& zone, const std::string& id, double scale) {
  const auto text = [scale](double pixels) { return shortest_text(pixels / scale); };
  const auto* way = std::get_if<OneWay>(&zone.rule);
  if (way == nullptr) return pattern({kHatch, kHatch, slant_of(zone), "M0 0V" + text(kHatch)}, zone, id, scale);
  const std::string middle = text(0.5 * kArrowAside), back = text(kArrow - kArrowHead);
  const std::string arrow = "M0 " + middle + "H" + text(kArrow) + "M" + back + " " +
                            text(0.5 * kArrowAside - kArrowHead) + "L" + text(kArrow) + " " + middle + "L" + back +
                            " " + text(0.5 * kArrowAside + kArrowHead);
  return pattern({kArrowAlong, kArrowAside, way->heading * 180.0 / kPi, arrow}, zone, id, scale);
}

std::string legend_text(const Zone& zone, std::size_t index) {
  std::string text = zone.name.empty() ? "zone " + std::to_string(index) : zone.name;
  if (const auto* limit = std::get_if<SpeedLimit>(&zone.rule))
    return text + " " + rounded_text(limit->max_speed) + " m/s";
  if (const auto* way = std::get_if<OneWay>(&zone.rule))
    return text + " " + rounded_text(way->heading) + " \u00B1 " + rounded_text(way->tolerance) + " rad";
  if (const auto* clear = std::get_if<KeepClear>(&zone.rule))
    return text + " " + rounded_text(clear->distance) + " m, " + rounded_text(clear->cost) + " s/m";
  const std::vector<std::string>& vehicles = std::get<KeepOut>(zone.rule).vehicles;
  for (std::size_t i = 0; i < vehicles.size(); ++i) text += (i == 0 ? " for " : " and ") + vehicles[i];
  return text;
}

}  // namespace arcway::internal
