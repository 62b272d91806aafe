#include "arcway/datasets/filter_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "arcway/datasets/map_file.h"
#include "arcway/datasets/occupancy_grid.h"
#include "core/base/shortest_text.h"
#include "datasets/formats/gray_image.h"
#include "datasets/formats/ros_map.h"
#include "datasets/grid/grid_map.h"
#include "datasets/io/input_files.h"

namespace arcway {

using namespace internal;
namespace {

constexpr std::int8_t kLethal = 100;

void require_options(const FilterMaskOptions& options) {
  const auto require = [](bool is_right, const char* what, double value, const char* limit) {
    if (!is_right)
      throw std::invalid_argument("filter mask: " + std::string(what) + " is " + shortest_text(value) + ", must be " +
                                  limit);
  };
  require(std::isfinite(options.base), "base", options.base, "finite");
  require(std::isfinite(options.multiplier), "multiplier", options.multiplier, "finite");
  const bool needs_speed = options.type == FilterMaskType::kSpeedPercent;
  require(!needs_speed || (options.max_speed > 0.0 && std::isfinite(options.max_speed)), "the robot's top speed",
          options.max_speed, "above 0 m/s, for limits in percent");
}

// The cells of a mask.
class Mask {
 public:
  Mask(const RosMap& map, const GrayImage& image) : percents_(to_percents(map, image)) {
    grid_.width = image.width;
    grid_.height = image.height;
    grid_.cell_size = map.resolution;
    grid_.origin = map.origin;
    for (const std::int8_t percent : percents_) ++(percent < 0 ? unknown_ : counts_[static_cast<std::size_t>(percent)]);
  }

  [[nodiscard]] std::size_t count(std::int8_t value) const { return counts_[static_cast<std::size_t>(value)]; }
  [[nodiscard]] std::size_t unknown() const { return unknown_; }
  [[nodiscard]] std::size_t size() const { return percents_.size(); }

  // The polygons that cells of one value cover.
  [[nodiscard]] std::vector<Polygon> areas_of(std::int8_t value, double tolerance) {
    grid_.cells.resize(percents_.size());
    std::ranges::transform(percents_, grid_.cells.begin(),
                           [value](std::int8_t p) { return p == value ? Cell::kOccupied : Cell::kFree; });
    return to_map_file(grid_, {.walled = false, .tolerance = tolerance}).obstacles;
  }

 private:
  std::vector<std::int8_t> percents_;
  OccupancyGrid grid_;
  std::array<std::size_t, kLethal + 1> counts_{};  // by value
  std::size_t unknown_ = 0;
};

// The limit of a value [m/s]. Nothing where Nav2 takes it as no limit; then `why` says so.
std::optional<double> limit_of(std::int8_t value, const FilterMaskOptions& options, std::string& why) {
  const bool is_percent = options.type == FilterMaskType::kSpeedPercent;
  const double limit = options.base + options.multiplier * value;
  const char* unit = is_percent ? " %" : " m/s";
  if (!(limit > 0.0) || (is_percent && limit > 100.0)) {
    why = "a limit of " + shortest_text(limit) + unit +
          ", which is none for Nav2: " + (is_percent ? "expected above 0 and up to 100 %" : "expected above 0 m/s") +
          "; check base and multiplier";
    return std::nullopt;
  }
  return is_percent ? limit * options.max_speed / 100.0 : limit;
}

}  // namespace

FilterMask read_filter_mask(const std::filesystem::path& yaml, const FilterMaskOptions& options) {
  require_options(options);
  const std::string file = yaml.string();
  const RosMap map = read_ros_map(read_expanded(yaml), file);
  const std::filesystem::path image_path = find_beside(yaml, map.image);
  Mask mask(map, read_gray_image(read_expanded(image_path), image_path.string(), options.max_cells));
  FilterMask result;
  result.files = {yaml, image_path};
  warn_of_keys(map, file, result.warnings);
  const auto warn = [&](std::size_t cells, const std::string& what, const std::string& why) {
    result.warnings.push_back(file + ": " + std::to_string(cells) + " of " + std::to_string(mask.size()) + " cells " +
                              what + " " + why);
  };
  const bool is_keep_out = options.type == FilterMaskType::kKeepOut;
  if (mask.unknown() > 0 && !is_keep_out)
    warn(mask.unknown(), "are unknown,", "which no speed mask may be: no limit there");
  for (std::int8_t value = 1; value <= kLethal; ++value) {
    if (mask.count(value) == 0) continue;
    const std::string what = "have the value " + std::to_string(value) + ",";
    std::string why = "a cost in Nav2 and no keep-out: no zone there";
    const std::optional<double> limit = is_keep_out ? std::nullopt : limit_of(value, options, why);
    if (is_keep_out ? value != kLethal : !limit) {
      warn(mask.count(value), what, why);
      continue;
    }
    const ZoneRule rule = is_keep_out ? ZoneRule(KeepOut{}) : ZoneRule(SpeedLimit{*limit});
    for (Polygon& area : mask.areas_of(value, options.tolerance))
      result.zones.push_back({std::move(area), rule, yaml.stem().string()});
  }
  result.notes.push_back(file + ": " + std::to_string(result.zones.size()) + " zones of a mask of " +
                         std::to_string(mask.size()) + " cells");
  return result;
}

}  // namespace arcway
