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
#include "core/model/side_radii.h"
#include "core/motion/speed_tree.h"
#include "core/search/tree_path.h"

namespace arcway::internal {

/// How finely a tree tells poses apart, which motions it tries, and what gear changes cost.
struct GearTreeOptions {
  double cells;            ///< number of cells in a turning radius, and of headings in a radian
  bool halves;             ///< whether motions that an obstacle ends early are also made half as long
  double cusp_cost = 0.0;  ///< cost of a gear change, beside the time for it [s]
  std::size_t max_cusps =
      std::numeric_limits<std::size_t>::max();  ///< largest number of gear changes from the root to a pose
  const OneWayZones* one_way_zones = nullptr;   ///< null: none; must outlive the tree
  Gear forwards = Gear::kForward;  ///< in which motions that lead forwards from the root are driven, see ContactReach
};

/// A tree of poses that free motions in both gears reach from a pose: lines, and arcs of the smallest radius of either
/// side. Some motions have a fixed length; others go as far as they are free. Lengths come from the edges near by, and
/// the sweep query remains to be asked. A grid over position, heading and gear keeps the cheapest pose of each cell; if
/// gear changes are limited, one for each number of them. As the number of motions is limited, a missing pose proves
/// nothing. What can be driven from the root can be driven back to it in the other gear, in the same time if the
/// vehicle's gears are swapped.
class GearTree {
 public:
  struct Node {
    Pose pose;
    PathSegment motion;    ///< from the parent; of zero length for the root
    std::uint32_t parent;  ///< kRoot for the root itself
    std::uint32_t joint;   ///< joint of the speed tree at the pose
    std::uint32_t cusps;   ///< gear changes from the root
    double cost;           ///< least time to pass here plus the cost of gear changes [s]
  };
  static constexpr std::uint32_t kRoot = 0;

  /// @param outlines  of the world; must outlive the tree.
  /// @param remaining  estimate of the cost from a pose on [s]; the most promising pose is expanded first.
  GearTree(const Pose& root, const Vehicle& vehicle, const Outlines& outlines, const GearTreeOptions& options,
           std::function<double(const Pose&)> remaining);

  /// Expands the most promising pose that has not been expanded: adds the poses it reaches. None if all have been.
  /// O(edges near by).
  std::optional<std::uint32_t> expand();

  /// Whether the pose expanded last has room for a motion that starts there. Constant time for a line or an arc of the
  /// smallest radius, else O(edges near by). For motions longer than any of the tree, whether it has room for the
  /// tree's longest.
  [[nodiscard]] bool has_room(const PathSegment& motion) const;

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  /// The least estimate of poses not yet expanded [s]; infinity if there are none.
  [[nodiscard]] double least_estimate() const;
  /// The path from the root to a node.
  [[nodiscard]] Path path_from_root(std::uint32_t node) const { return internal::path_from_root(nodes_, node); }
  /// The path from a node back to the root.
  [[nodiscard]] Path path_to_root(std::uint32_t node) const { return internal::path_to_root(nodes_, node); }

 private:
  void add_line(std::uint32_t from, Gear gear);
  void add_arcs(std::uint32_t from, Side side, Gear gear);
  void add(std::uint32_t from, const PathSegment& motion);
  [[nodiscard]] double room(double curvature, Gear gear) const;
  [[nodiscard]] std::uint64_t cell_of(const Pose& pose, Gear gear, std::uint32_t cusps) const;

  Vehicle vehicle_;
  GearTreeOptions options_;
  std::function<double(const Pose&)> remaining_;
  SideRadii radii_;
  double radius_;  // the smaller one [m]
  ContactReach contact_;
  std::array<std::array<double, 2>, 3> rooms_{};  // lengths of motions from the last pose: by curvature, by gear [m]
  SpeedTree speeds_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::uint32_t> cells_;
  using Waiting = std::pair<double, std::uint32_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> open_;
};

}  // namespace arcway::internal
