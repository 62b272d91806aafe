#pragma once

#include <string>
#include <vector>

#include "arcway/polygon.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"

namespace arcway::internal::cli {

/// Maps whose obstacles are added to another one.
struct AddedMaps {
  const std::vector<std::string>& names;
  const MapOptions& reading;
  const std::string& added_to;  ///< name of the other map, for messages
};

/// The obstacles of the maps to be added; what else these say goes to the warnings and notes of the map.
/// @param files  must replace none of what is read.
/// @throws UsageError for degrees, or with --lonlat.
std::vector<Polygon> added_obstacles(const AddedMaps& maps, LoadedMap& map, OutputFiles& files);

}  // namespace arcway::internal::cli
