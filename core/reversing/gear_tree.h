#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/collision/contact_reach.h"
#include "core/model/outlines.h"
#include "core/motion/speed_tree.h"
#include "core/search/tree_path.h"

namespace arcway::internal {

/// How a tree tells poses apart, and how many it makes.
struct GearTreeGrid {
  double cells;  ///< in a turning radius; headings are told apart as finely
  bool halves;   ///< motions that an obstacle ends early are made half as long, too
  std::size_t max_cusps = std::numeric_limits<std::size_t>::max();  ///< of the way to a pose
};

/// Poses that free motions in both gears reach from a pose: arcs of the smallest radius to either side and lines, some
/// of a fixed length, some as far as they are free. Motions are computed from the edges near by, and remain to be
/// checked by the sweep query; their number is limited, so a missing pose proves nothing. At most one pose for each
/// cell of a grid over position, heading and gear is kept, the cheapest; where cusps are limited, one for each number
/// of them. What can be driven from the root can be driven to it the other way, in the same time if the vehicle's gears
/// are swapped.
class GearTree {
 public:
  struct Node {
    Pose pose;
    PathSegment motion;    ///< from the parent; of zero length for the root
    std::uint32_t parent;  ///< kRoot for the root itself
    std::uint32_t joint;   ///< in the speed tree
    std::uint32_t cusps;   ///< of the way from the root
    double cost;           ///< least time to pass here, and the cost of all cusps [s]
  };
  static constexpr std::uint32_t kRoot = 0;

  /// @param outlines   of the world; must outlive the tree.
  /// @param cusp_cost  of a change of gear, beside the time for it [s].
  /// @param remaining  estimate of the cost from a pose on, by which poses take their turn [s].
  GearTree(const Pose& root, const Vehicle& vehicle, const Outlines& outlines, double cusp_cost,
           const GearTreeGrid& grid, std::function<double(const Pose&)> remaining);

  /// Adds the poses reached from the most promising one that had no turn yet; none if all had. O(edges near by).
  std::optional<std::uint32_t> expand();

  /// Whether the pose that had its turn last leads as far as this motion, which starts there: a line or an arc of the
  /// smallest radius. Of longer motions than any of the tree, whether it leads as far as those.
  [[nodiscard]] bool has_room(const PathSegment& motion) const;

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  /// Least estimate of what has not had its turn [s]; infinity if there is nothing.
  [[nodiscard]] double least_estimate() const;
  /// The way from the root to a node.
  [[nodiscard]] Path path_from_root(std::uint32_t node) const { return internal::path_from_root(nodes_, node); }
  /// The same way back.
  [[nodiscard]] Path path_to_root(std::uint32_t node) const { return internal::path_to_root(nodes_, node); }

 private:
  void add_line(std::uint32_t from, Gear gear);
  void add_arcs(std::uint32_t from, Side side, Gear gear);
  void add(std::uint32_t from, const PathSegment& motion);
  [[nodiscard]] double room(double curvature, Gear gear) const;
  [[nodiscard]] std::uint64_t cell_of(const Pose& pose, Gear gear, std::uint32_t cusps) const;

  Vehicle vehicle_;
  double cusp_cost_;
  GearTreeGrid grid_;
  std::function<double(const Pose&)> remaining_;
  double radius_;
  ContactReach contact_;
  std::array<std::array<double, 2>, 3> rooms_{};  // lengths of motions from the last pose: by curvature, by gear [m]
  SpeedTree speeds_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::uint32_t> cells_;
  using Waiting = std::pair<double, std::uint32_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> open_;
};

}  // namespace arcway::internal
