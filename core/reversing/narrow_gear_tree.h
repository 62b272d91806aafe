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
#include "core/search/tree_open_list.h"
#include "core/search/tree_path.h"

namespace arcway::internal {

/// What a change of gear costs in a tree, and how many there may be.
struct TreeGears {
  double change;          ///< cost of a change, the time to stop and set off included [s]
  std::size_t max_cusps;  ///< of the way to a pose
};

/// Poses that a vehicle reaches from a pose in both gears: a tree of lines and of arcs of several radii, each up to
/// contact, half of that, or a step.
///
/// At most one pose for each cell over position, heading and gear is kept, the first that comes. Cells are as large as
/// what the vehicle can do where the motion to the pose began. Let q be the longest way to and fro on one line or
/// circle there, and t the largest turn to and fro. One move turns the body by t at most and shifts it aside by about q
/// t. So cells are a share of q long, of q t wide and of t in heading. The frame is that of the root and the cell's
/// heading, so that a query that is moved or turned has the same tree, up to rounding. Motions are computed from the
/// edges near by, and remain to be checked by the sweep query.
class NarrowGearTree {
 public:
  struct Node {
    Pose pose;
    PathSegment motion;    ///< from the parent; of zero length for the root
    std::uint32_t parent;  ///< kRoot for the root itself
    std::uint32_t cusps;   ///< of the way from the root
    double cost;           ///< about the time of that way with the costs of its changes of gear [s]
  };
  static constexpr std::uint32_t kRoot = 0;

  /// @param map        must outlive the tree.
  /// @param vehicle    that of the map, its gears swapped for a tree that leads to its root.
  /// @param fineness   size of cells, 1 for the largest.
  /// @param remaining  estimate of the cost from a pose on, by which poses take their turn [s].
  NarrowGearTree(const Roadmap& map, const Vehicle& vehicle, const Pose& root, const TreeGears& gears, double fineness,
                 std::function<double(const Pose&)> remaining);

  /// Adds the poses reached from the most promising one that had no turn yet; none if all had. O(edges near by).
  std::optional<std::uint32_t> expand();

  /// Whether the pose that had its turn last leads as far as this motion, which starts there: a line or an arc of the
  /// smallest radius. Constant time.
  [[nodiscard]] bool has_room(const PathSegment& motion) const;

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  /// The way from the root to a node.
  [[nodiscard]] Path path_from_root(std::uint32_t node) const { return internal::path_from_root(nodes_, node); }
  /// The same way back.
  [[nodiscard]] Path path_to_root(std::uint32_t node) const { return internal::path_to_root(nodes_, node); }

 private:
  // Sizes of a cell; powers of two of the largest.
  struct Cell {
    double along, aside, turn;  // [m], [m], [rad]
  };
  void add(std::uint32_t from, const Cell& cell, const PathSegment& motion);
  [[nodiscard]] double longest(double curvature) const;
  [[nodiscard]] Cell cell_where(double way, double turn) const;
  [[nodiscard]] std::uint64_t key_of(const Pose& pose, const Cell& cell) const;

  Vehicle vehicle_;
  TreeGears gears_;
  double fineness_;
  std::function<double(const Pose&)> remaining_;
  double radius_, size_;  // size_: of the body or the turn, whichever is larger [m]
  double far_line_;       // the longest line [m]
  Cell largest_;
  ContactReach contact_;
  std::array<std::array<double, 2>, 3> rooms_{};  // of motions from the last pose: right, straight, left, by gear [m]
  std::vector<Node> nodes_;
  std::unordered_set<std::uint64_t> cells_;
  TreeOpenList open_;  // by largest cells
};

}  // namespace arcway::internal
