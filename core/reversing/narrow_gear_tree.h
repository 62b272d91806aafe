#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_set>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/attach/roadmap.h"
#include "core/collision/contact_reach.h"
#include "core/model/side_radii.h"
#include "core/search/tree_open_list.h"
#include "core/search/tree_path.h"

namespace arcway::internal {

/// What a gear change costs in a tree, how many there may be, and how finely the tree tells poses apart.
struct NarrowGearTreeOptions {
  double gear_change;              ///< cost of a gear change, with the time to stop and set off [s]
  std::size_t max_cusps;           ///< largest number of gear changes from the root to a pose
  double fineness;                 ///< size of cells, 1 for the largest
  Gear forwards = Gear::kForward;  ///< in which motions that lead forwards from the root are driven, see ContactReach
};

/// A tree of poses that a vehicle reaches from a pose in both gears, by lines and by arcs of several radii. Each motion
/// goes up to contact, half as far, or by a step.
///
/// Each cell over position, heading and gear keeps its first pose. Cells are as large as what the vehicle can do where
/// the motion to the pose began. Let q be the longest motion to and fro on one line or circle there, and t the largest
/// turn to and fro. One move turns the body by at most t and shifts it aside by about q t. Cells are therefore a share
/// of q long, of q t wide and of t in heading.
///
/// Cells lie in the frame of the root. A query that is moved or turned has the same tree, up to rounding. Lengths of
/// motions come from the edges near by, and the sweep query remains to be asked.
class NarrowGearTree {
 public:
  struct Node {
    Pose pose;
    PathSegment motion;    ///< from the parent; of zero length for the root
    std::uint32_t parent;  ///< kRoot for the root itself
    std::uint32_t cusps;   ///< gear changes from the root
    double cost;           ///< approximate time from the root plus the cost of gear changes [s]
  };
  static constexpr std::uint32_t kRoot = 0;

  /// @param map  must outlive the tree.
  /// @param vehicle  that of the map; with its gears swapped for a tree that leads to its root.
  /// @param remaining  estimate of the cost from a pose on [s]; the most promising pose is expanded first.
  NarrowGearTree(const Roadmap& map, const Vehicle& vehicle, const Pose& root, const NarrowGearTreeOptions& options,
                 std::function<double(const Pose&)> remaining);

  /// Expands the most promising pose that has not been expanded: adds the poses it reaches. None if all have been.
  /// O(edges near by).
  std::optional<std::uint32_t> expand();

  /// Whether the pose expanded last has room for a motion that starts there. Constant time for a line or an arc of the
  /// smallest radius, else O(edges near by).
  [[nodiscard]] bool has_room(const PathSegment& motion) const;

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  /// The path from the root to a node.
  [[nodiscard]] Path path_from_root(std::uint32_t node) const { return internal::path_from_root(nodes_, node); }
  /// The path from a node back to the root.
  [[nodiscard]] Path path_to_root(std::uint32_t node) const { return internal::path_to_root(nodes_, node); }

  /// Number of edges that motions were compared with, as a measure of cost.
  [[nodiscard]] std::uint64_t edges_compared() const { return contact_.edges_compared(); }

 private:
  // The size of a cell: the largest one times powers of two.
  struct Cell {
    double along, aside, turn;  // [m], [m], [rad]
  };
  void add(std::uint32_t from, const Cell& cell, const PathSegment& motion);
  [[nodiscard]] double longest(double curvature) const;
  [[nodiscard]] Cell cell_where(double way, double turn) const;
  [[nodiscard]] std::uint64_t key_of(const Pose& pose, const Cell& cell) const;

  Vehicle vehicle_;
  NarrowGearTreeOptions options_;
  std::function<double(const Pose&)> remaining_;
  SideRadii radii_;  // the smallest ones
  double size_;      // the larger one of the smaller radius and the length of the body [m]
  double far_line_;  // the longest line [m]
  Cell largest_;
  ContactReach contact_;
  std::array<std::array<double, 2>, 3> rooms_{};  // of motions from the last pose: right, straight, left, by gear [m]
  std::vector<Node> nodes_;
  std::unordered_set<std::uint64_t> cells_;
  TreeOpenList open_;  // by largest cells
};

}  // namespace arcway::internal
