#pragma once

#include <array>
#include <optional>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/model/outlines.h"
#include "core/search/body_contact.h"
#include "core/search/hinge_step.h"

namespace arcway::internal {

/// Where a body on a path touches edges of the world, and how deep, by the curvatures and the lengths of all motions.
/// Lengths are in lengths of the body: part 2 i of a step is the change of the curvature of motion i, part 2 i + 1 that
/// of its length.
class PathContacts {
 public:
  /// @param outlines  must outlive this.
  PathContacts(const Outlines& outlines, const Footprint& body);

  /// Length of the body [m].
  [[nodiscard]] double unit() const { return unit_; }

  /// Looks along a path: for each motion and edge, the contacts that are deepest around, found between steps of the
  /// path by golden sections. The last three residuals are the way from the goal, times `kEndWeight`. O(steps x edges
  /// near by + contacts x motions).
  /// @param motions  not empty; each begins where the one before ends.
  void look_along(const std::vector<PathSegment>& motions, const Pose& goal);

  static constexpr double kEndWeight = 100.0;
  [[nodiscard]] const LinearResiduals& residuals() const { return residuals_; }
  /// Depth of the deepest contact, 0 if there is none [body lengths].
  [[nodiscard]] double deepest() const { return deepest_; }
  /// How far the path ends from the goal: the largest of the three components [body lengths or rad].
  [[nodiscard]] double off_goal() const { return off_goal_; }
  /// Sum of the squares of all residuals that count.
  [[nodiscard]] double square_sum() const { return square_sum_; }

  /// How the end of a path moves: gradients of its place and heading, as above.
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic> end_gradients(const std::vector<PathSegment>& motions) const;

 private:
  struct Step {
    double at;  // along a motion [m]
    Vec2 place, ahead;
  };
  // A motion's end, and how that moves as the curvature grows.
  struct End {
    Vec2 place, ahead, by_curvature;
  };

  void look_along_motion(std::size_t i);
  void find_edges(const PathSegment& motion);
  void look_at(std::size_t i, const LineSegment& edge);
  [[nodiscard]] std::size_t steps_far_from(const Step& step, const LineSegment& edge) const;
  [[nodiscard]] static Step step_at(const PathSegment& motion, double at);
  [[nodiscard]] static End end_at(const PathSegment& motion, const Step& step);
  [[nodiscard]] std::optional<BodyContact> contact(const PathSegment& motion, const Step& step,
                                                   const LineSegment& edge) const;
  [[nodiscard]] double depth(const PathSegment& motion, const Step& step, const LineSegment& edge) const;
  [[nodiscard]] Step deepest(const PathSegment& motion, const LineSegment& edge, double low, double high) const;
  void add_contact(std::size_t i, const Step& step, const BodyContact& contact);
  void add_end(const Pose& goal);
  [[nodiscard]] std::array<double, 2> by_motion(const PathSegment& motion, double length, const End& end,
                                                const Vec2& place, const Vec2& by_place, double by_turn) const;

  const Outlines* outlines_;
  Footprint body_;
  double unit_;    // length of the body [m]
  double around_;  // radius of the circle around the reference point that holds the body [m]
  double deepest_ = 0.0, off_goal_ = 0.0, square_sum_ = 0.0;
  std::vector<PathSegment> motions_;
  std::vector<End> ends_;           // by motion
  std::vector<LineSegment> edges_;  // near one motion
  std::vector<Step> steps_;         // of one motion
  std::vector<double> values_, gradients_;
  LinearResiduals residuals_;
};

}  // namespace arcway::internal
