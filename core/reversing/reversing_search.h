#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/reversing/gear_search.h"
#include "core/search/forward_search.h"

namespace arcway::internal {

struct ReversingQuery {
  Pose start, goal;  ///< that differ
  double distance;   ///< that no path of the vehicle falls below, as travel_time_lower_bound takes it [m]
  double cutoff;     ///< cost of a path that is known, driven forwards; only cheaper ones are of interest [s]
  std::size_t max_cusps = std::numeric_limits<std::size_t>::max();  ///< of paths of interest
};

/// Poses near one end, behind a motion in the other gear, by which that end joins the roadmap.
struct GearAttachments {
  double cells = 0.0;               ///< of the grid that tells poses apart, in a turning radius
  std::size_t most = 0;             ///< beside the end itself; 0: the end alone
  std::size_t most_expansions = 0;  ///< of the tree that finds them
};

/// The cheapest path of a vehicle that may drive backwards, in travel time and a cost of each change of gear. Steps may
/// be left out, and each looks for what is cheaper than the paths known so far. The number of trials is limited, so
/// that no path proves nothing.
class ReversingSearch {
 public:
  /// All arguments but the query must outlive this.
  ReversingSearch(const Roadmap& map, const ReversingQuery& query, const SearchOptions& options,
                  ArrivalSearch& arrivals);

  /// By the roadmap, driven backwards all the way.
  FoundPath join_backwards();
  /// By the roadmap, driven either way between poses that motions in both gears reach from start and goal. Poses are
  /// left out if the lower bounds say that no path by way of them is cheaper.
  FoundPath join_between(const GearAttachments& wanted);
  /// By Reeds-Shepp words and trees in both gears all the way, see search_gears.
  FoundPath grow_gear_trees(std::size_t poses);
  /// By trees for narrow ways, see search_narrow_gears.
  FoundPath grow_narrow_gear_trees(std::size_t poses);

  /// The cheapest path found so far, if any.
  [[nodiscard]] const std::optional<Path>& path() const { return path_; }
  /// Cost of the cheapest path that is known, found here or not; infinite where there is none [s].
  [[nodiscard]] double cost() const { return cost_; }

 private:
  void join(const GearAttachments& wanted, Gear gear, FoundPath& found);
  // Whether the cheapest path between these poses, if any, changes gear seldom enough.
  bool join(std::span<const Attachment> starts, std::span<const Attachment> goals, Gear gear, FoundPath& found);
  [[nodiscard]] std::vector<Attachment> attachments(Direction direction, const GearAttachments& wanted,
                                                    Gear gear) const;
  // From rest to rest by a way of at least this length.
  [[nodiscard]] double least_cost(const Pose& from, const Pose& to, double length) const;
  [[nodiscard]] GearSearchOptions gear_options(std::size_t poses) const;
  FoundPath taken(const GearSearchResult& gears);
  // Keeps the path if it is the cheapest. Returns whether it changes gear seldom enough.
  bool offer(const Path& path);

  const Roadmap& map_;
  ReversingQuery query_;
  const SearchOptions& options_;
  ArrivalSearch& arrivals_;
  std::optional<Path> path_;
  double cost_;
};

}  // namespace arcway::internal
