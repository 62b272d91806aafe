#include "bench/cli/added_maps.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/model/pose_text.h"

namespace arcway::internal::cli {
namespace {

// Longest edge of any obstacle [m].
double longest_edge(const MapFile& map) {
  double longest = 0.0;
  for (const Polygon& polygon : map.obstacles)
    for (std::size_t i = 0; i < polygon.outer.size(); ++i)
      longest = std::max(longest, (polygon.outer[(i + 1) % polygon.outer.size()] - polygon.outer[i]).norm());
  return longest;
}

// Degrees by what the file says, or by their looks: then with edges that no obstacle in meters has.
void refuse_degrees(const std::string& file, const LoadedMap& added, const MapFile& map, const std::string& prepared) {
  constexpr double kShortestEdge = 0.01;  // 1 cm; as degrees more than 1 km
  const bool stated = added.frame == CoordinateFrame::kDegrees;
  const bool looks = added.frame == CoordinateFrame::kUnstated && looks_like_degrees(added.world.box()) &&
                     longest_edge(map) < kShortestEdge;
  if (stated || looks)
    throw UsageError("--add: " + file + (stated ? " has" : " seems to have") +
                     " degrees of longitude and latitude, near " + shortest_text(added.world.box().min) + ", and " +
                     prepared + " is in meters; put both into one file and prepare it with --lonlat" +
                     ", or use --planar if they are meters");
}

}  // namespace

std::vector<Polygon> added_obstacles(const AddedMaps& maps, LoadedMap& map, OutputFiles& files) {
  if (maps.reading.lonlat && !maps.names.empty())
    throw UsageError("--add: --lonlat projects each map around its own middle; put them into one file");
  std::vector<Polygon> added;
  for (const std::string& file : maps.names) {
    const LoadedMap more = load_map(file, maps.reading);
    files.protect(more.files);
    MapFile polygons = to_map_file(more.world);
    refuse_degrees(file, more, polygons, maps.added_to);
    added.insert(added.end(), std::move_iterator(polygons.obstacles.begin()),
                 std::move_iterator(polygons.obstacles.end()));
    map.notes.insert(map.notes.end(), more.notes.begin(), more.notes.end());
    map.warnings.insert(map.warnings.end(), more.warnings.begin(), more.warnings.end());
    std::string left_out;
    for (const auto& [has, what] : {std::pair{more.world.has_bounds(), "bounds"},
                                    {more.start.has_value(), "start"},
                                    {more.goal.has_value(), "goal"}})
      if (has) left_out += (left_out.empty() ? "" : ", ") + std::string(what);
    if (!left_out.empty())
      map.warnings.push_back(file + ": its " + left_out + " are left out; only obstacles are added");
  }
  return added;
}

}  // namespace arcway::internal::cli
