#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "arcway/datasets/map_file.h"
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

struct FilterMaskWriteOptions {
  FilterMaskType type = FilterMaskType::kKeepOut;  ///< kKeepOut, or kSpeed
  double resolution = 0.05;                        ///< side of a cell [m], > 0
  /// Name of the robot: keep-outs for others are left out. Empty: all keep-outs are written.
  std::string vehicle = {};
  std::size_t max_cells = 100'000'000;  ///< larger masks are refused
};

/// Texts of the files of a mask.
struct FilterMaskFiles {
  std::string mask;         ///< NAME.yaml, for Nav2's map_server
  std::string image;        ///< NAME.pgm, binary
  std::string parameters;   ///< of Nav2's filter_mask_server and costmap_filter_info_server, YAML
  std::size_t zones;        ///< that were written
  double base, multiplier;  ///< a value v limits the speed to base + multiplier * v [m/s]
};

/// Writes the keep-outs of a map, or its speed limits, as a mask of Nav2's costmap filters that covers the map. Corners
/// of cells lie at multiples of the resolution. Zones grow to whole cells, and never shrink: a cell that a zone reaches
/// into by more than a billionth of its side is the zone's.
///
/// - Keep-outs have the value 100. No cell has another one but 0.
/// - Speed limits have values from 1 to 100, by base + multiplier * value: 1 for the lowest limit, 100 for the highest.
///   Those between are rounded down to a step. A cell has the lowest limit of the zones that reach into it.
///
/// Other zones are left out. read_filter_mask gives back zones of whole cells.
/// @param name  of the files, without ending.
/// @throws std::invalid_argument if the mask has too many cells, naming the least resolution that fits, or the
///   resolution or the type is none of these.
ARCWAY_API FilterMaskFiles to_filter_mask(const MapFile& map, const std::string& name,
                                          const FilterMaskWriteOptions& options);

}  // namespace arcway
