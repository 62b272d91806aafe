#include "core/search/find_reversing_path.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/path/speed_profile.h"
#include "core/search/gear_search.h"
#include "core/search/gear_tree.h"

namespace arcway {

namespace {

constexpr double kTerminalCells = 8.0;        // of the grid for poses by which an end joins the graph
constexpr std::size_t kMostTerminals = 48;    // of one end
constexpr std::size_t kMostExpansions = 200;  // for them
constexpr std::size_t kPosesBeside = 1500;    // tried all the way where a path is known
constexpr std::size_t kPosesAlone = 40000;    // and where none is

// Poses from which the graph is entered forwards behind a motion backwards, or the other way round for the goal; the
// end itself first.
std::vector<Terminal> terminals_of(const SearchMap& map, const Pose& end, Direction direction,
                                   const SearchOptions& options) {
  const bool from_start = direction == Direction::kFromStart;
  const bool swapped = from_start != (options.gear == Gear::kForward);  // a goal's tree is driven the other way
  GearTree tree(end, swapped ? map.vehicle.with_gears_swapped() : map.vehicle, *map.queries.sweep, options.cusp_cost,
                {kTerminalCells, true}, [](const Pose&) { return 0.0; });
  std::vector<Terminal> terminals{{end, {}}};
  for (std::size_t i = 0; i < kMostExpansions && terminals.size() < kMostTerminals && !options.interrupted(); ++i) {
    const auto node = tree.expand();
    if (!node) break;
    if (*node == GearTree::kRoot || tree[*node].motion.gear != (from_start ? Gear::kReverse : Gear::kForward)) continue;
    terminals.push_back({tree[*node].pose, from_start ? tree.path_from_root(*node) : tree.path_to_root(*node)});
  }
  return terminals;
}

class Finder {
 public:
  Finder(const SearchMap& map, const SearchOptions& options, double cutoff, FoundPath& found)
      : map_(map), options_(options), found_(found), search_(found.search), cost_(cutoff) {}

  // By the graph, driven forwards or backwards, with motions in both gears at both ends. What is driven backwards from
  // one pose to another is driven forwards the other way.
  void join_graph(const Pose& from, const Pose& to, Gear gear, SearchWorkspace& workspace) {
    if (search_.interrupted) return;
    const bool forward = gear == Gear::kForward;
    SearchOptions options = options_;
    options.gear = gear;
    const auto starts = terminals_of(map_, forward ? from : to, Direction::kFromStart, options);
    const auto goals = terminals_of(map_, forward ? to : from, Direction::kToGoal, options);
    SearchResult joined = search_arrivals(map_, starts, goals, options, workspace);
    search_.nodes_expanded += joined.nodes_expanded;
    search_.nodes_pushed += joined.nodes_pushed;
    count(joined.straights_checked, joined.turns_checked, starts.size() + goals.size(), joined.interrupted);
    if (joined.path) offer(forward ? *joined.path : reversed(*joined.path));
  }

  void search_all_the_way(const Pose& start, const Pose& goal) {
    if (search_.interrupted) return;
    const GearSearchResult gears = search_gears(start, goal, map_.vehicle, *map_.queries.sweep,
                                                {.cusp_cost = options_.cusp_cost,
                                                 .max_poses = std::isfinite(cost_) ? kPosesBeside : kPosesAlone,
                                                 .cutoff = cost_,
                                                 .stop = [this] { return options_.interrupted(); }});
    count(gears.straights_checked, gears.turns_checked, gears.poses, gears.interrupted);
    if (gears.path) offer(*gears.path);
  }

 private:
  void count(std::uint64_t straights, std::uint64_t turns, std::size_t poses, bool interrupted) {
    search_.straights_checked += straights;
    search_.turns_checked += turns;
    search_.interrupted = interrupted;
    found_.manoeuvre_poses += poses;
  }

  void offer(const Path& path) {
    const double cost = travel_cost(path, map_.vehicle, options_.cusp_cost);
    if (cost >= cost_) return;
    search_.path = path;
    cost_ = cost;
  }

  const SearchMap& map_;
  const SearchOptions& options_;
  FoundPath& found_;
  SearchResult& search_;
  double cost_;
};

}  // namespace

FoundPath find_reversing_path(const SearchMap& map, const Pose& start, const Pose& goal, double cutoff,
                              const SearchOptions& options, SearchWorkspace& workspace) {
  FoundPath found;
  Finder finder(map, options, cutoff, found);
  finder.join_graph(start, goal, Gear::kForward, workspace);
  finder.join_graph(start, goal, Gear::kReverse, workspace);
  finder.search_all_the_way(start, goal);
  return found;
}

}  // namespace arcway
