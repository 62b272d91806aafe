#include "datasets/formats/ros_map.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "arcway/datasets/file_io.h"
#include "core/base/shortest_text.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/io/nearest_word.h"
#include "datasets/io/number_text.h"
#include "datasets/io/shortened.h"

namespace arcway::internal {
namespace {

constexpr std::size_t kLargestFile = 1 << 16;  // a map has ten lines
// Keys of map_server, and keys of other YAML files that lie beside a map.
constexpr std::string_view kKeys[] = {"image",       "resolution", "origin",  "negate", "occupied_thresh",
                                      "free_thresh", "mode",       "version", "name"};

/// A node of the document and what it is called.
class Place {
 public:
  Place(YAML::Node node, std::string_view file, std::string key)
      : node_(std::move(node)), file_(file), key_(std::move(key)) {}

  [[nodiscard]] std::string text() const {
    if (!node_.IsScalar()) expected("one value");
    return node_.Scalar();
  }
  [[nodiscard]] double number() const {
    const std::optional<double> value = node_.IsScalar() ? read_number(node_.Scalar()) : std::nullopt;
    if (!value) expected("a number");
    return *value;
  }
  [[nodiscard]] double number_from(double least, const char* what) const {
    const double value = number();
    if (value < least) expected(what);
    return value;
  }
  [[nodiscard]] bool flag() const {
    const std::string value = text();
    for (const char* yes : {"1", "true", "True", "TRUE"})
      if (value == yes) return true;
    for (const char* no : {"0", "false", "False", "FALSE"})
      if (value == no) return false;
    expected("0, 1, true or false");
  }
  [[nodiscard]] std::array<double, 3> three_numbers() const {
    if (!node_.IsSequence() || node_.size() != 3) expected("three numbers [x, y, yaw]");
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i)
      values[i] = Place(node_[i], file_, key_ + "[" + std::to_string(i) + "]").number();
    return values;
  }
  [[noreturn]] void expected(const char* what) const {
    const std::string found = node_.IsScalar()     ? detail::quoted(node_.Scalar())
                              : node_.IsSequence() ? "a list of " + std::to_string(node_.size())
                              : node_.IsMap()      ? "a map"
                                                   : "nothing";
    throw FormatError(std::string(file_) + ": line " + std::to_string(node_.Mark().line + 1) + ": " + key_ +
                      ": expected " + what + ", found " + found);
  }

 private:
  YAML::Node node_;
  std::string_view file_;
  std::string key_;
};

RosMap parse(std::string_view yaml, std::string_view name) {
  const YAML::Node document = YAML::Load(std::string(yaml));
  if (!document.IsMap()) throw FormatError(std::string(name) + ": expected keys and values as image: map.pgm");
  const auto place = [&](const char* key) {
    const YAML::Node node = document[key];
    if (!node) {
      std::vector<std::string> keys;
      for (const auto& entry : document)
        if (entry.first.IsScalar()) keys.push_back(entry.first.Scalar());
      const std::vector<std::string_view> views(keys.begin(), keys.end());
      const std::string_view nearest = nearest_word(key, views);
      throw FormatError(std::string(name) + ": missing key \"" + key + "\"" +
                        (nearest.empty() ? "" : "; is it meant by " + detail::quoted(nearest) + "?"));
    }
    return Place(node, name, key);
  };
  RosMap map;
  map.image = place("image").text();
  map.resolution = place("resolution").number();
  if (!(map.resolution > 0.0)) place("resolution").expected("a number above 0");
  const auto [x, y, yaw] = place("origin").three_numbers();
  map.origin = {x, y, yaw};
  map.negate = place("negate").flag();
  map.occupied_thresh = place("occupied_thresh").number_from(0.0, "a number from 0");
  map.free_thresh = place("free_thresh").number_from(0.0, "a number from 0");
  if (document["mode"]) {
    const std::string mode = place("mode").text();
    if (mode == "trinary") {
      map.mode = RosMap::Mode::kTrinary;
    } else if (mode == "scale") {
      map.mode = RosMap::Mode::kScale;
    } else if (mode == "raw") {
      map.mode = RosMap::Mode::kRaw;
    } else {
      place("mode").expected("trinary, scale or raw");
    }
  }
  for (const auto& entry : document) {
    if (!entry.first.IsScalar()) continue;
    const std::string& key = entry.first.Scalar();
    if (std::ranges::find(kKeys, std::string_view(key)) == std::end(kKeys)) map.unread_keys.push_back(key);
  }
  return map;
}

Cell cell_of(const RosMap& map, double shade) {
  if (map.mode == RosMap::Mode::kRaw) {
    const double percent = std::round(shade * 255.0);
    return percent == 0.0 ? Cell::kFree : percent == 100.0 ? Cell::kOccupied : Cell::kUnknown;
  }
  const double occupancy = map.negate ? shade : 1.0 - shade;
  if (occupancy >= map.occupied_thresh) return Cell::kOccupied;
  return occupancy <= map.free_thresh ? Cell::kFree : Cell::kUnknown;
}

constexpr std::int8_t kUnknownPercent = -1;

std::int8_t percent_of(const RosMap& map, double shade) {
  if (map.mode == RosMap::Mode::kRaw) {
    const double value = std::round(shade * 255.0);
    return value <= 100.0 ? static_cast<std::int8_t>(value) : kUnknownPercent;
  }
  const double occupancy = map.negate ? shade : 1.0 - shade;
  if (occupancy >= map.occupied_thresh) return 100;
  if (occupancy <= map.free_thresh) return 0;
  if (map.mode == RosMap::Mode::kTrinary) return kUnknownPercent;
  const double share = (occupancy - map.free_thresh) / (map.occupied_thresh - map.free_thresh);
  return static_cast<std::int8_t>(std::round(100.0 * share));
}

}  // namespace

RosMap read_ros_map(std::string_view yaml, std::string_view name) {
  if (yaml.size() > kLargestFile)
    throw FormatError(std::string(name) + ": " + std::to_string(yaml.size()) + " bytes are too many for a map's YAML");
  try {
    return parse(yaml, name);
  } catch (const YAML::Exception& error) {
    throw FormatError(std::string(name) + ": line " + std::to_string(error.mark.line + 1) + ": " +
                      shortened(error.msg, kMostOfParser));
  }
}

OccupancyGrid to_grid(const RosMap& map, const GrayImage& image, std::string_view name,
                      std::vector<std::string>& warnings) {
  // One decision for each value of gray.
  std::vector<Cell> cells(image.max_value + 1);
  for (std::uint32_t gray = 0; gray <= image.max_value; ++gray)
    cells[gray] = cell_of(map, static_cast<double>(gray) / image.max_value);

  OccupancyGrid grid;
  grid.width = image.width;
  grid.height = image.height;
  grid.cell_size = map.resolution;
  grid.origin = map.origin;
  grid.cells.reserve(image.samples.size());
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    const bool masked = !image.transparent.empty() && image.transparent[i] && map.mode != RosMap::Mode::kRaw;
    grid.cells.push_back(masked ? Cell::kUnknown : cells[image.samples[i]]);
  }
  flip_rows(grid);

  constexpr std::uint16_t kUnknownGray = 205;  // as the savers write it
  if (map.mode != RosMap::Mode::kRaw && image.max_value == 255 && cells[kUnknownGray] == Cell::kFree &&
      std::find(image.samples.begin(), image.samples.end(), kUnknownGray) != image.samples.end())
    warnings.push_back(std::string(name) +
                       ": gray 205, by which maps mark the unknown, reads as free with free_thresh " +
                       shortest_text(map.free_thresh) + "; 0.196 keeps it unknown");
  warn_of_keys(map, name, warnings);
  return grid;
}

std::vector<std::int8_t> to_percents(const RosMap& map, const GrayImage& image) {
  std::vector<std::int8_t> percents(image.max_value + 1);  // by gray
  for (std::uint32_t gray = 0; gray <= image.max_value; ++gray)
    percents[gray] = percent_of(map, static_cast<double>(gray) / image.max_value);
  std::vector<std::int8_t> rows;
  rows.reserve(image.samples.size());
  for (std::size_t y = image.height; y-- > 0;)
    for (std::size_t i = y * image.width; i < (y + 1) * image.width; ++i) {
      const bool masked = !image.transparent.empty() && image.transparent[i] && map.mode != RosMap::Mode::kRaw;
      rows.push_back(masked ? kUnknownPercent : percents[image.samples[i]]);
    }
  return rows;
}

void warn_of_keys(const RosMap& map, std::string_view name, std::vector<std::string>& warnings) {
  for (const std::string& key : map.unread_keys) {
    const std::string_view nearest = nearest_word(key, kKeys);
    warnings.push_back(std::string(name) + ": key " + detail::quoted(key) + " is not read" +
                       (nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?"));
  }
  if (map.origin.heading != 0.0)
    warnings.push_back(std::string(name) + ": the map is turned by " + shortest_text(map.origin.heading) +
                       " rad, which many programs ignore");
}

}  // namespace arcway::internal
