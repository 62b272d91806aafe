#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/zone.h"

namespace arcway {

/// What the values of a filter mask mean, as nav2_msgs/CostmapFilterInfo says it.
enum class FilterMaskType {
  kKeepOut = 0,       ///< cells of 100 are keep-outs
  kSpeedPercent = 1,  ///< a value v limits the speed to base + multiplier * v percent of the robot's top speed
  kSpeed = 2          ///< a value v limits the speed to base + multiplier * v [m/s]
};

struct FilterMaskOptions {
  FilterMaskType type = FilterMaskType::kKeepOut;
  double base = 0.0, multiplier = 1.0;  ///< of speed limits
  double max_speed = 0.0;               ///< the robot's top speed, for kSpeedPercent [m/s]
  /// Zones may grow by this many cells where that saves corners, as GridOptions::tolerance says.
  double tolerance = 0.0;
  std::size_t max_cells = 100'000'000;  ///< larger masks are refused
};

/// The zones of a filter mask.
struct FilterMask {
  std::vector<Zone> zones;
  std::vector<std::string> warnings, notes;
  std::vector<std::filesystem::path> files;  ///< that were read
};

/// Reads a mask of Nav2's costmap filters: an image in PGM or PNG and the YAML file that names it, as of a map. Cells
/// of one value become the polygons of zones, which have the name of the YAML file. Values are those of the occupancy
/// grid that map_server publishes: 0 to 100 in mode scale or raw, 0 and 100 in mode trinary.
///
/// | value | keep-out | speed limit |
/// |---|---|---|
/// | 0 | no zone | no zone |
/// | 1 to 99 | no zone, with a warning: a cost in Nav2 | limit by base and multiplier |
/// | 100 | zone | limit by base and multiplier |
/// | unknown | no zone | no zone, with a warning: Nav2 calls it invalid |
///
/// Limits that Nav2 takes as none, with a warning, are no zones here: percents outside of 0 to 100, speeds below 0, and
/// a limit of 0.
/// @throws FileError if a file cannot be read, FormatError naming file, line and value.
/// @throws std::invalid_argument if a number of the options is out of its range.
ARCWAY_API FilterMask read_filter_mask(const std::filesystem::path& yaml, const FilterMaskOptions& options);

}  // namespace arcway
