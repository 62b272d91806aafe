#include "core/reversing/narrow_gear_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "core/collision/motion_free.h"
#include "core/collision/path_cost.h"
#include "core/model/body_size.h"
#include "core/model/side_radii.h"
#include "core/motion/gear_words.h"
#include "core/reversing/narrow_gear_tree.h"
#include "core/search/near_poses.h"
#include "core/search/path_ends.h"
#include "core/search/route_field.h"

namespace arcway::internal {

namespace {

// One pass. Each is finer than the passes before, which found nothing.
struct Pass {
  double fineness;  // size of the trees' cells, 1 for the largest
  double share;     // share of the search's poses that the pass may expand
};
constexpr std::array<Pass, 3> kPasses{{{1.0, 0.4}, {0.5, 0.3}, {0.25, 0.3}}};
// Largest number of edges compared with motions in a pass, for each of its poses; some 100 ns each. Of 232 driven
// worlds it makes one plan slower, by 6 %. The one that took longest, 6.1 s, takes 4.1 s.
constexpr std::uint64_t kEdges = 1000;
constexpr std::size_t kFieldCells = 50'000;  // cells of the grid for the estimate of the rest of the route
// Distance within which poses of the other tree are joined, in lengths of the body.
constexpr double kJoinDistance = 1.0;
constexpr std::size_t kNearest = 2;       // number of poses of the other tree that a new pose is joined to
constexpr std::size_t kJoiningWords = 6;  // number of words tried to each: the shortest that have room at the new pose
// Poses expanded after the first path, beyond as many as it took. With 500, plans of 180 driven worlds are as fast in
// the mean.
constexpr std::size_t kExpandedAfter = 100;

class NarrowGearSearch {
 public:
  NarrowGearSearch(const Roadmap& map, const Pose& start, const Pose& goal, const GearSearchOptions& options,
                   GearSearchResult& result)
      : map_(map),
        roots_{start, goal},
        options_(options),
        result_(result),
        radii_(map.vehicle),
        fields_{field(kGoalEnd), field(kStartEnd)} {
    result_.cost = options.cutoff;
  }

  void run() {
    for (const Pass& pass : kPasses) {
      grow(pass);
      if (result_.path || result_.interrupted) return;
    }
  }

 private:
  struct Side {
    NarrowGearTree tree;
    NearPoses near;
  };

  [[nodiscard]] RouteField field(std::size_t to) const {
    return {map_, {roots_[kStartEnd], roots_[to], kFieldCells, options_.avoided}, options_.clock};
  }

  [[nodiscard]] Side side(std::size_t at, double fineness) const {
    const Vehicle& vehicle = map_.vehicle;
    const double stopping = vehicle.top_speed() / vehicle.max_acceleration();
    const auto remaining = [this, at](const Pose& from) {
      const double way =
          std::max(fields_[at](from), reeds_shepp_distance(from, roots_[other_end(at)], radii_.smaller()));
      return options_.rest_weight * way / map_.vehicle.top_speed();
    };
    return {{map_,
             at == kStartEnd ? vehicle : vehicle.with_gears_swapped(),
             roots_[at],
             {options_.cusp_cost + stopping, options_.max_cusps, fineness,
              at == kStartEnd ? Gear::kForward : Gear::kReverse},
             remaining},
            NearPoses(kJoinDistance * body_length(vehicle))};
  }

  bool interrupted() {
    result_.interrupted = result_.interrupted || options_.clock.is_over();
    return result_.interrupted;
  }

  void grow(const Pass& pass) {
    std::array<Side, 2> sides{side(kStartEnd, pass.fineness), side(kGoalEnd, pass.fineness)};
    auto most = static_cast<std::size_t>(pass.share * static_cast<double>(options_.max_poses));
    const std::uint64_t most_edges = kEdges * most;
    const auto edges = [&] { return sides[kStartEnd].tree.edges_compared() + sides[kGoalEnd].tree.edges_compared(); };
    for (std::size_t i = 0; i < most && edges() < most_edges && !interrupted(); ++i) {
      const std::size_t at = i % 2;
      const auto node = sides[at].tree.expand();
      if (!node) return;  // finer cells may lead further
      ++result_.poses;
      const bool first = !result_.path;
      join(sides, at, *node);
      if (first && result_.path) most = std::min(most, 2 * (i + 1) + kExpandedAfter);
    }
  }

  // Joins a new pose to the root of the other tree and to its poses near by.
  void join(std::array<Side, 2>& sides, std::size_t at, std::uint32_t node) {
    const Pose pose = sides[at].tree[node].pose;
    near_.clear();
    sides[other_end(at)].near.visit(pose, [&](const NearPoses::Entry& entry) {
      near_.push_back({(entry.pose.position() - pose.position()).norm() +
                           radii_.smaller() * std::abs(wrap_signed(entry.pose.heading - pose.heading)),
                       entry.node});
    });
    const std::size_t few = std::min(near_.size(), kNearest);
    std::partial_sort(near_.begin(), near_.begin() + static_cast<std::ptrdiff_t>(few), near_.end());
    near_.resize(few);
    near_.push_back({0.0, NarrowGearTree::kRoot});
    for (const NearPose& n : near_) connect(sides, at, node, n.node);
    sides[at].near.add(node, pose);
  }

  // Joins two nodes by a word.
  // @param node   of the tree `at`, which expanded it last.
  // @param other  of the other tree.
  void connect(const std::array<Side, 2>& sides, std::size_t at, std::uint32_t node, std::uint32_t other) {
    const Pose& from = sides[kStartEnd].tree[at == kStartEnd ? node : other].pose;
    const Pose& to = sides[kGoalEnd].tree[at == kStartEnd ? other : node].pose;
    const double ends = sides[at].tree[node].cost + sides[other_end(at)].tree[other].cost;
    const GearWords gear_words(from, to, radii_);
    const double longest = (result_.cost - ends) * map_.vehicle.top_speed();
    words_.clear();
    for (std::size_t word = 0; word < kGearWords; ++word) {
      const double length = gear_words.length(word, longest);
      if (std::isfinite(length) && ends + length / map_.vehicle.top_speed() < result_.cost)
        words_.emplace_back(length, word);
    }
    std::sort(words_.begin(), words_.end());
    std::size_t tried = 0;
    for (const auto& [length, word] : words_) {
      const Path between = *gear_words.path(word);
      if (between.empty()) continue;
      if (!sides[at].tree.has_room(at == kStartEnd ? between.front() : between.back().reversed())) continue;
      if (++tried > kJoiningWords) return;
      if (!motion_free(*map_.queries.sweep, map_.body, between)) continue;
      Path path = sides[kStartEnd].tree.path_from_root(at == kStartEnd ? node : other);
      path.insert(path.end(), between.begin(), between.end());
      const Path rest = sides[kGoalEnd].tree.path_to_root(at == kStartEnd ? other : node);
      path.insert(path.end(), rest.begin(), rest.end());
      if (take(std::move(path))) return;
    }
  }

  // Keeps a path if it is the cheapest and free.
  bool take(Path&& path) {
    if (cusps_of(path) > options_.max_cusps) return false;
    const double cost =
        path_cost(path, map_.vehicle, {{}, options_.speed_zones, options_.clearance_cost, options_.cusp_cost});
    if (cost >= result_.cost || !motion_free(*map_.queries.sweep, map_.body, path)) return false;
    result_.cost = cost;
    result_.path = std::move(path);
    return true;
  }

  const Roadmap& map_;
  std::array<Pose, 2> roots_;
  const GearSearchOptions& options_;
  GearSearchResult& result_;
  SideRadii radii_;
  std::array<RouteField, 2> fields_;                   // by end: routes to the other one
  std::vector<NearPose> near_;                         // memory of join
  std::vector<std::pair<double, std::size_t>> words_;  // memory of connect
};

}  // namespace

GearSearchResult search_narrow_gears(const Roadmap& map, const Pose& start, const Pose& goal,
                                     const GearSearchOptions& options) {
  GearSearchResult result;
  NarrowGearSearch(map, start, goal, options, result).run();
  return result;
}

}  // namespace arcway::internal
