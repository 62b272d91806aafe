#include "core/reversing/gear_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/collision/motion_free.h"
#include "core/collision/path_cost.h"
#include "core/model/side_radii.h"
#include "core/motion/reeds_shepp.h"
#include "core/reversing/gear_tree.h"
#include "core/search/path_ends.h"

namespace arcway::internal {

namespace {

// Weight of the lower bound in a pose's estimate: a little more than 1, to reach the goal soon.
constexpr double kGreed = 1.5;
constexpr double kCells = 4.0;          // cells of the trees' grids in a turning radius
constexpr double kMostCells = 4096.0;   // finest grid
constexpr double kFiner = 4.0;          // ratio of cells from one grid to the next finer one
constexpr std::size_t kWordsTried = 8;  // words tried from a pose: the cheapest ones that have room there
// Poses tried after the first path, beyond as many as it took. With a third of those, plans of 180 driven worlds are as
// fast in the mean, but a parking plan is slower by 4 %. With 50, one of 40 with 2 mm of room is slower, by 28 %.
constexpr std::size_t kPosesAfter = 150;

class GearSearch {
 public:
  GearSearch(const GearQuery& query, const GearSearchOptions& options, GearSearchResult& result)
      : vehicle_(query.vehicle),
        sweep_(query.sweep),
        outlines_(query.outlines),
        one_way_zones_(query.one_way_zones),
        options_(options),
        result_(result),
        body_(query.vehicle.body(0.5 * query.vehicle.safety_margin())),
        radii_(query.vehicle),
        roots_{query.start, query.goal},
        trees_{tree(kStartEnd), tree(kGoalEnd)} {
    result_.cost = options.cutoff;
  }

  void run() {
    std::size_t limit = options_.max_poses;
    for (std::size_t turn = 0; result_.poses < limit; ++turn) {
      if (options_.clock.is_over()) {
        result_.interrupted = true;
        break;
      }
      const double least = std::min(trees_[kStartEnd].least_estimate(), trees_[kGoalEnd].least_estimate());
      if (std::isfinite(result_.cost) && least >= kGreed * result_.cost) break;
      const std::size_t at = turn % 2;
      const auto node = trees_[at].expand();
      if (!node) {
        if (cells_[at] >= kMostCells) break;
        // The room is so narrow that the vehicle's few motions end in the same cells.
        cells_[at] *= kFiner;
        trees_[at] = tree(at);
        continue;
      }
      ++result_.poses;
      const bool first = !result_.path;
      join(at, *node);
      if (first && result_.path) limit = std::min(limit, 2 * result_.poses + kPosesAfter);
    }
  }

 private:
  [[nodiscard]] GearTree tree(std::size_t at) const {
    return {roots_[at],
            at == kStartEnd ? vehicle_ : vehicle_.with_gears_swapped(),
            outlines_,
            {cells_[at], cells_[at] == kCells, options_.cusp_cost, options_.max_cusps, one_way_zones_,
             at == kStartEnd ? Gear::kForward : Gear::kReverse},
            [this, to = roots_[other_end(at)]](const Pose& from) { return far(from, to); }};
  }

  // Estimate of the cost between two poses [s].
  [[nodiscard]] double far(const Pose& from, const Pose& to) const {
    return kGreed * reeds_shepp_distance(from, to, radii_.smaller()) / vehicle_.top_speed();
  }

  // A word from a pose to the other root, with the cost of the path by way of it [s].
  struct Shot {
    double estimate;
    std::size_t word;
  };

  // Joins a new pose to the root of the other tree.
  void join(std::size_t at, std::uint32_t node) {
    const Pose& pose = trees_[at][node].pose;
    const Pose& root = roots_[other_end(at)];
    const Pose& from = at == kStartEnd ? pose : root;
    const Pose& to = at == kStartEnd ? root : pose;
    const ReedsSheppWords words(from, to, radii_.larger());
    const double cost = trees_[at][node].cost, top_speed = vehicle_.top_speed();
    shots_.clear();
    for (std::size_t word = 0; word < kReedsSheppWords; ++word) {
      const double estimate = cost + words.length(word, (result_.cost - cost) * top_speed) / top_speed;
      if (estimate < result_.cost) shots_.push_back({estimate, word});
    }
    std::sort(shots_.begin(), shots_.end(), [](const Shot& a, const Shot& b) {
      return a.estimate != b.estimate ? a.estimate < b.estimate : a.word < b.word;
    });
    std::size_t tried = 0;
    for (const auto& [estimate, word] : shots_) {
      if (estimate >= result_.cost) return;
      const auto middle = words.path(word);
      if (!middle->empty() && !trees_[at].has_room(at == kStartEnd ? middle->front() : middle->back().reversed()))
        continue;
      if (++tried > kWordsTried) return;
      take(at, node, *middle);
    }
  }

  // Keeps the path by way of a word between a node of one tree and the other root, if it is cheaper and free.
  void take(std::size_t at, std::uint32_t node, const Path& word) {
    Path path = at == kStartEnd ? trees_[kStartEnd].path_from_root(node) : word;
    const Path rest = at == kStartEnd ? word : trees_[kGoalEnd].path_to_root(node);
    path.insert(path.end(), rest.begin(), rest.end());
    if (cusps_of(path) > options_.max_cusps) return;
    const double cost =
        path_cost(path, vehicle_, {{}, options_.speed_zones, options_.clearance_cost, options_.cusp_cost});
    if (cost >= result_.cost || !is_free(word) || !is_free(path)) return;
    result_.cost = cost;
    result_.path = std::move(path);
  }

  bool is_free(const Path& motion) {
    for (const PathSegment& s : motion) ++(s.is_line() ? result_.straights_checked : result_.turns_checked);
    return motion_free(sweep_, body_, motion);
  }

  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  const Outlines& outlines_;
  const OneWayZones* one_way_zones_;
  const GearSearchOptions& options_;
  GearSearchResult& result_;
  Body body_;
  SideRadii radii_;
  std::array<Pose, 2> roots_;
  std::array<double, 2> cells_{kCells, kCells};
  std::array<GearTree, 2> trees_;
  std::vector<Shot> shots_;  // memory of join
};

}  // namespace

GearSearchResult search_gears(const GearQuery& query, const GearSearchOptions& options) {
  GearSearchResult result;
  GearSearch(query, options, result).run();
  return result;
}

}  // namespace arcway::internal
