#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_set>
#include <vector>

#include "arcway/path.h"
#include "core/attach/attachment_links.h"
#include "core/attach/roadmap.h"
#include "core/collision/contact_reach.h"
#include "core/model/side_radii.h"
#include "core/search/effort.h"
#include "core/search/tree_open_list.h"

namespace arcway::internal {

/// A tree of poses that a vehicle which does not reverse reaches from a start, or from which it reaches a goal. Motions
/// are lines and arcs of any radius, each as long as the room or a share of it. Where obstacles end motions early, the
/// curvatures that lead furthest are found by halving. A tree then follows a narrow bend in few motions.
///
/// Each cell of a grid over position and heading keeps its first pose. The grid lies in the frame of the root, and is
/// finer where obstacles are nearer. A query that is moved or turned has the same tree, up to rounding. Lengths of
/// motions come from the edges near by, and the sweep query remains to be asked.
class ForwardTree {
 public:
  struct Node {
    Pose pose;
    PathSegment motion;    ///< between the parent and this, driven forwards; of zero length for the root
    std::uint32_t parent;  ///< kRoot for the root itself
    double length;         ///< of the path between the root and this [m]
  };
  static constexpr std::uint32_t kRoot = 0;

  /// @param map  must outlive the tree.
  /// @param pass  says how finely poses and curvatures are told apart.
  /// @param remaining  estimate of the rest of the route from a pose [m]; the most promising pose is expanded first.
  ForwardTree(const Roadmap& map, const Pose& root, Direction direction, const TreePass& pass,
              std::function<double(const Pose&)> remaining);

  /// Expands the most promising pose that has not been expanded: adds the poses it reaches. None if all have been.
  /// O(edges near by).
  std::optional<std::uint32_t> expand();

  /// The room of the pose expanded last for a motion of a curvature, up to longest_motion() [m].
  [[nodiscard]] double room(double curvature) const { return contact_(curvature, gear_); }
  [[nodiscard]] double longest_motion() const { return far_; }

  /// Number of edges that motions were compared with, as a measure of cost.
  [[nodiscard]] std::uint64_t edges_compared() const { return contact_.edges_compared(); }

  /// The largest distance of a pose from the root [m].
  [[nodiscard]] double extent() const { return extent_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  /// The path from the start to a node, or from a node to the goal.
  [[nodiscard]] Path connection(std::uint32_t node) const;

 private:
  // A curvature, and how far it leads.
  struct Ray {
    double curvature;
    double reach;
    bool first;  // looked at from every pose
  };

  void look_around(const Pose& pose);
  void halve_steps();
  [[nodiscard]] bool leads_furthest(std::size_t ray) const;
  [[nodiscard]] Ray ray(double curvature, bool first) const;
  void add(std::uint32_t from, double curvature, double length);
  [[nodiscard]] std::uint64_t cell_of(const Pose& pose, int level) const;
  [[nodiscard]] int level_of(const Pose& pose) const;

  const Roadmap* map_;
  Direction direction_;
  Gear gear_;  // in which the tree grows away from its root
  std::function<double(const Pose&)> remaining_;
  SideRadii radii_;
  double body_length_;
  double far_;  // the longest motion [m]
  double extent_ = 0.0;
  double coarsest_;  // size of the largest cells [m]
  int halvings_;
  int levels_;  // of smaller cells, each half as large
  ContactReach contact_;
  std::vector<Ray> rays_, halved_;  // by curvature
  std::vector<Node> nodes_;
  std::unordered_set<std::uint64_t> cells_;
  TreeOpenList open_;  // by coarse cells
};

}  // namespace arcway::internal
