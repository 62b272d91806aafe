#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/datasets/filter_mask.h"
#include "core/base/shortest_text.h"
#include "datasets/io/json_text.h"

namespace arcway {

using namespace internal;
namespace {

// Share of a cell that an area may reach into it and leave it free. Coordinates in cells are rounded to some 1e-11, and
// areas that end at borders of cells should not grow each time that they are written and read.
constexpr double kTouch = 1e-9;
// Values of cells: 0 is free.
constexpr std::uint8_t kLowest = 1, kHighest = 100;
constexpr double kWhite = 255.0;
// Share by which a limit of the mask may be above that of its zone.
constexpr double kRounding = 1e-12;

// Cells that areas touch, and their values. Row 0 is the lowest one.
class Raster {
 public:
  Raster(const Box& box, const FilterMaskWriteOptions& options) : resolution_(options.resolution) {
    const Vec2 first = (box.min / resolution_).array().floor(), last = (box.max / resolution_).array().ceil();
    first_ = first;
    const Vec2 size = (last - first).cwiseMax(1.0);
    if (!(size.x() * size.y() <= static_cast<double>(options.max_cells)))
      throw std::invalid_argument("filter mask: " + shortest_text(size.x()) + " x " + shortest_text(size.y()) +
                                  " cells of " + shortest_text(resolution_) + " m, at most " +
                                  std::to_string(options.max_cells) + " fit; give a resolution of at least " +
                                  rounded_text(least_resolution(box, options.max_cells)) + " m");
    width_ = static_cast<std::size_t>(size.x());
    height_ = static_cast<std::size_t>(size.y());
    values_.assign(width_ * height_, 0);
  }

  [[nodiscard]] Vec2 origin() const { return resolution_ * first_; }

  // Sets all cells that an area reaches into.
  void fill(const Polygon& area, std::uint8_t value) {
    std::vector<Ring> rings{in_cells(area.outer)};
    for (const Ring& hole : area.holes) rings.push_back(in_cells(hole));
    Box box;
    for (const Vec2& p : rings.front()) box.extend(p);
    const auto row_of = [this](double y) {
      return static_cast<std::size_t>(std::clamp(y, 0.0, static_cast<double>(height_)));
    };
    for (std::size_t row = row_of(std::floor(box.min.y())); row < row_of(std::ceil(box.max.y())); ++row) {
      fill_touched(rings, row, value);
      fill_covered(rings, row, value);
    }
  }

  // As binary PGM, white where there is no zone and black at the highest value.
  [[nodiscard]] std::string to_pgm() const {
    std::string pgm = "P5\n" + std::to_string(width_) + " " + std::to_string(height_) + "\n255\n";
    for (std::size_t row = height_; row-- > 0;)
      for (std::size_t i = row * width_; i < (row + 1) * width_; ++i)
        pgm += static_cast<char>(static_cast<std::uint8_t>(std::round(kWhite * (1.0 - values_[i] / 100.0))));
    return pgm;
  }

 private:
  static double least_resolution(const Box& box, std::size_t max_cells) {
    const Vec2 size = box.max - box.min;
    // A cell more in each direction, as borders of cells lie at multiples of the resolution.
    return std::sqrt(size.x() * size.y() / static_cast<double>(max_cells)) * (1.0 + 1e-3) +
           2.0 * size.maxCoeff() / static_cast<double>(max_cells);
  }

  [[nodiscard]] Ring in_cells(const Ring& ring) const {
    Ring result;
    for (const Vec2& p : ring) result.push_back(p / resolution_ - first_);
    return result;
  }

  // Cells [first, last) of a row.
  void fill_row(std::size_t row, double first, double last, std::uint8_t value) {
    const auto column = [this](double x) { return static_cast<std::size_t>(std::clamp(x, 0.0, 1.0 * width())); };
    for (std::size_t x = column(first); x < column(last); ++x) values_[row * width_ + x] = value;
  }
  [[nodiscard]] double width() const { return static_cast<double>(width_); }

  // Cells of a row that an edge leads through.
  void fill_touched(const std::vector<Ring>& rings, std::size_t row, std::uint8_t value) {
    const double low = static_cast<double>(row) + kTouch, high = static_cast<double>(row) + 1.0 - kTouch;
    for (const Ring& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        if (a.y() > b.y()) std::swap(a, b);
        if (b.y() < low || a.y() > high) continue;
        const auto at = [&](double y) { return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()); };
        const double x0 = a.y() >= low ? a.x() : at(low), x1 = b.y() <= high ? b.x() : at(high);
        fill_row(row, std::floor(std::min(x0, x1) + kTouch), std::ceil(std::max(x0, x1) - kTouch), value);
      }
  }

  // Cells of a row whose centers are inside.
  void fill_covered(const std::vector<Ring>& rings, std::size_t row, std::uint8_t value) {
    const double y = static_cast<double>(row) + 0.5;
    std::vector<double> crossings;
    for (const Ring& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if ((a.y() > y) != (b.y() > y)) crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
    std::ranges::sort(crossings);
    // The center of cell x lies at x + 0.5.
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      fill_row(row, std::ceil(crossings[i] - 0.5), std::floor(crossings[i + 1] - 0.5) + 1.0, value);
  }

  double resolution_;
  Vec2 first_;  // of the lower left cell, in cells
  std::size_t width_ = 0, height_ = 0;
  std::vector<std::uint8_t> values_;
};

// What a zone's cells become, if the mask has them.
std::optional<double> limit_of(const Zone& zone, const FilterMaskWriteOptions& options) {
  if (options.type == FilterMaskType::kSpeed) {
    const auto* limit = std::get_if<SpeedLimit>(&zone.rule);
    return limit == nullptr ? std::nullopt : std::optional(limit->max_speed);
  }
  const auto* keep_out = std::get_if<KeepOut>(&zone.rule);
  const bool is_wanted = keep_out != nullptr && (options.vehicle.empty() || keep_out->is_for(options.vehicle));
  return is_wanted ? std::optional(0.0) : std::nullopt;
}

// Steps of the limits from the lowest to the highest one.
struct Scale {
  Scale(double lowest, double highest)
      : multiplier((highest - lowest) / (kHighest - kLowest)), base(lowest - kLowest * multiplier) {}

  // The highest value whose limit is no higher, but for rounding.
  [[nodiscard]] std::uint8_t value_of(double limit) const {
    std::uint8_t value = kHighest;
    while (value > kLowest && base + multiplier * value > limit * (1.0 + kRounding)) --value;
    return value;
  }

  double multiplier, base;
};

Box box_of(const MapFile& map) {
  Box box;
  const auto add = [&box](const Ring& ring) {
    for (const Vec2& p : ring) box.extend(p);
  };
  if (map.bounds) add(*map.bounds);
  for (const Polygon& obstacle : map.obstacles) add(obstacle.outer);
  for (const Zone& zone : map.zones) add(zone.area.outer);
  if (box.empty()) box.extend(Vec2(0.0, 0.0));
  return box;
}

// A number that YAML takes for one with a fraction, as ROS parameters of that type must be.
std::string number_text(double value) {
  const std::string text = shortest_text(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string quoted(const std::string& text) {
  std::string result;
  detail::append_string(result, text);  // YAML takes strings of JSON
  return result;
}

std::string mask_yaml(const std::string& name, const Vec2& origin, double resolution) {
  return "image: " + quoted(name + ".pgm") + "\nmode: scale\nresolution: " + shortest_text(resolution) + "\norigin: [" +
         shortest_text(origin.x()) + ", " + shortest_text(origin.y()) +
         ", 0]\nnegate: 0\noccupied_thresh: 1.0\nfree_thresh: 0.0\n";
}

std::string parameters_yaml(const std::string& name, FilterMaskType type, const Scale& scale) {
  const std::string topic = type == FilterMaskType::kKeepOut ? "/keepout_filter" : "/speed_filter";
  return "filter_mask_server:\n  ros__parameters:\n    frame_id: map\n    topic_name: " + topic +
         "_mask\n    yaml_filename: " + quoted(name + ".yaml") +
         "\ncostmap_filter_info_server:\n  ros__parameters:\n    type: " + std::to_string(static_cast<int>(type)) +
         "\n    filter_info_topic: " + topic + "_info\n    mask_topic: " + topic +
         "_mask\n    base: " + number_text(scale.base) + "\n    multiplier: " + number_text(scale.multiplier) + "\n";
}

}  // namespace

FilterMaskFiles to_filter_mask(const MapFile& map, const std::string& name, const FilterMaskWriteOptions& options) {
  if (options.type == FilterMaskType::kSpeedPercent)
    throw std::invalid_argument("filter mask: limits are written in m/s, not in percent; the type is kSpeed");
  if (!(options.resolution > 0.0 && std::isfinite(options.resolution)))
    throw std::invalid_argument("filter mask: resolution is " + shortest_text(options.resolution) +
                                " m, must be above 0 and finite");
  std::vector<std::pair<double, const Polygon*>> areas;  // with their limits
  for (const Zone& zone : map.zones)
    if (const std::optional<double> limit = limit_of(zone, options)) areas.emplace_back(*limit, &zone.area);
  // The lowest limit comes last, and stays.
  std::ranges::stable_sort(areas, std::greater<>(), [](const auto& area) { return area.first; });
  const bool is_keep_out = options.type == FilterMaskType::kKeepOut;
  // Keep-outs have no limits; Nav2 does not read their base and multiplier.
  const Scale scale =
      is_keep_out || areas.empty() ? Scale(kLowest, kHighest) : Scale(areas.back().first, areas.front().first);
  Raster raster(box_of(map), options);
  for (const auto& [limit, area] : areas) raster.fill(*area, is_keep_out ? kHighest : scale.value_of(limit));
  return {.mask = mask_yaml(name, raster.origin(), options.resolution),
          .image = raster.to_pgm(),
          .parameters = parameters_yaml(name, options.type, scale),
          .zones = areas.size(),
          .base = scale.base,
          .multiplier = scale.multiplier};
}

}  // namespace arcway
