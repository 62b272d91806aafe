#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/reversing/gear_search.h"
#include "core/search/forward_search.h"

namespace arcway::internal {

/// What a search in both gears is to find.
struct ReversingQuery {
  Pose start, goal;  ///< two different poses
  double distance;   ///< lower bound of the length of all paths, as travel_time_lower_bound takes it [m]
  double cutoff;     ///< cost of a known path, driven forwards; only cheaper ones are wanted [s]
  std::size_t max_cusps = std::numeric_limits<std::size_t>::max();  ///< largest number of gear changes of a path
};

/// How many poses near one end join the roadmap. A motion in the other gear leads from the end to each of them.
struct GearAttachments {
  double cells = 0.0;               ///< number of cells in a turning radius, of the grid that tells poses apart
  std::size_t most = 0;             ///< largest number of poses beside the end itself; 0: the end alone
  std::size_t most_expansions = 0;  ///< largest number of expansions of the tree that finds the poses
};

/// Finds the cheapest path of a vehicle that may drive backwards, between the end speeds of the options. The cost is
/// the travel time, plus a cost of each gear change and that of driving close to obstacles. Each step searches for a
/// path that is cheaper than those known so far. Steps may be left out. As the number of trials is limited, finding no
/// path proves nothing.
///
/// Paths with gear changes are searched from rest to rest: from where a moving start can have stopped, to where the way
/// to a moving goal can begin. Both ways are parts of the path, which need not stop between them and the rest.
class ReversingSearch {
 public:
  /// All arguments but the query must outlive this.
  /// @param backwards  the roadmap for paths driven backwards, see PlannerMaps::in.
  ReversingSearch(const Roadmap& map, const Roadmap& backwards, const ReversingQuery& query,
                  const SearchOptions& options, ArrivalSearch& arrivals);

  /// Searches the roadmap for a path that is driven backwards all the way.
  FoundPath join_backwards();
  /// Searches the roadmap, in each gear, for a path between poses that motions in both gears reach from start and goal.
  /// Poses are left out if lower bounds say that no path through them is cheaper.
  FoundPath join_between(const GearAttachments& wanted);
  /// Searches by Reeds-Shepp words and trees in both gears, without the roadmap: search_gears.
  FoundPath grow_gear_trees(std::size_t poses);
  /// Searches by trees in both gears for narrow places: search_narrow_gears.
  FoundPath grow_narrow_gear_trees(std::size_t poses);

  /// How trees of a slim body grow.
  struct SlimTrees {
    const Roadmap& map;  ///< of the slim body
    std::size_t poses;
    double rest_weight;                  ///< see GearSearchOptions
    double most;                         ///< cost of its path that is worth it [s]
    std::span<const Path> avoided = {};  ///< see GearSearchOptions
  };
  /// Makes a path of a slim body, from rest to rest, one of the body itself; nothing if none is found.
  using Widen = std::function<std::optional<Path>(const Path& path, const Pose& goal)>;
  /// Searches by trees for narrow places, for a slim body, and makes its path one of the body itself.
  FoundPath grow_slim_gear_trees(const SlimTrees& slim, const Widen& widened);

  /// The whole path over one from rest to rest, where the speeds at the ends are not 0.
  [[nodiscard]] Path between_stops(const Path& path) const;

  /// Says what a path costs that is known from elsewhere: only cheaper ones are searched from now on.
  void cut_off(double cost) { cost_ = std::min(cost_, cost); }

  /// The cheapest path found so far, if any.
  [[nodiscard]] const std::optional<Path>& path() const { return path_; }
  /// Number of paths found so far, each cheaper than those before.
  [[nodiscard]] std::size_t found() const { return found_; }
  /// Cost of the cheapest path that is known, found here or not; infinite where there is none [s].
  [[nodiscard]] double cost() const { return cost_; }

 private:
  class EndTree;
  struct EndTrees;
  void join(const GearAttachments& wanted, Gear gear, EndTrees& trees, FoundPath& found);
  // Searches between given poses. False if the cheapest path changes gear too often.
  bool join(std::span<const Attachment> starts, std::span<const Attachment> goals, Gear gear, FoundPath& found);
  // @param trees  of the end at which the attachments are.
  [[nodiscard]] std::vector<Attachment> attachments(Direction direction, const GearAttachments& wanted, Gear gear,
                                                    EndTree& trees) const;
  [[nodiscard]] EndTree end_tree(bool at_start, const GearAttachments& wanted) const;
  // Searches with options; a path found is driven in their gear.
  std::optional<Path> search(std::span<const Attachment> starts, std::span<const Attachment> goals,
                             const SearchOptions& options, FoundPath& found);
  // How the backward path between the ends themselves may begin or end, driven forwards.
  [[nodiscard]] std::vector<Attachment> end_alone(Direction direction) const;
  // Least cost from rest to rest of a path of at least this length.
  [[nodiscard]] double least_cost(const Pose& from, const Pose& to, double length) const;
  [[nodiscard]] GearSearchOptions gear_options(std::size_t poses) const;
  FoundPath taken(const GearSearchResult& gears);
  // Keeps the path if it is the cheapest. Returns whether it changes gear seldom enough.
  bool offer(const Path& path);

  // The roadmap for what is driven in a gear, described as if driven forwards.
  [[nodiscard]] const Roadmap& map_in(Gear gear) const { return gear == Gear::kForward ? map_ : backwards_; }

  const Roadmap& map_;
  const Roadmap& backwards_;
  ReversingQuery query_;   // between the stops, if an end moves
  SearchOptions options_;  // likewise, from rest to rest
  EndSpeeds ends_;
  Pose start_, goal_;
  Path before_, after_;  // from the start to its stop, and from that of the goal to the goal
  bool has_stops_ = true;
  ArrivalSearch& arrivals_;
  std::optional<Path> path_;
  std::size_t found_ = 0;
  double cost_;
};

}  // namespace arcway::internal
