#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/datasets/occupancy_grid.h"
#include "arcway/path.h"
#include "datasets/formats/gray_image.h"

namespace arcway::internal {

/// What the YAML file of ROS's map_server says of an image.
struct RosMap {
  std::string image;         ///< path, relative to the YAML file's folder
  double resolution = 0.05;  ///< size of a pixel [m]
  Pose origin;               ///< pose of the lower left corner of the lower left pixel
  bool negate = false;       ///< white is occupied
  double occupied_thresh = 0.65, free_thresh = 0.196;
  enum class Mode { kTrinary, kScale, kRaw } mode = Mode::kTrinary;
  std::vector<std::string> unread_keys;  ///< keys of the file that are not known here
};

/// Reads the YAML file: image, resolution, origin, negate, occupied_thresh and free_thresh are required; mode is not.
/// @throws FormatError, "map.yaml: line 3: resolution: expected a number above 0, found "x"".
RosMap read_ros_map(std::string_view yaml, std::string_view name);

/// Cells of an image, as the present map_server reads them. With occ = 1 - gray / white, or gray / white if
/// negated: occupied from occupied_thresh on, free up to free_thresh, unknown between (in mode scale as well) and where
/// the image is transparent. In mode raw the gray of 255 is the occupancy in percent: 0 is free, 100 occupied, all else
/// unknown.
/// @param name      of the map, for warnings.
/// @param warnings  is added to if unknown gray (205 of 255) reads as free or the map is turned.
OccupancyGrid to_grid(const RosMap& map, const GrayImage& image, std::string_view name,
                      std::vector<std::string>& warnings);

/// The occupancy of each pixel in percent, as the present map_server publishes it: 0 to 100, -1 unknown. Row 0 is the
/// lowest one. In mode scale, values between the thresholds are spread over 0 to 100. Other modes are those of to_grid,
/// but mode raw keeps all values up to 100.
std::vector<std::int8_t> to_percents(const RosMap& map, const GrayImage& image);

/// Says which keys of a file were not read, and whether the map is turned.
/// @param warnings  is added to.
void warn_of_keys(const RosMap& map, std::string_view name, std::vector<std::string>& warnings);

}  // namespace arcway::internal
