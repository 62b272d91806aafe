#pragma once

#include <array>
#include <optional>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/validate/edge_grid.h"

namespace arcway::internal {

/// Collision and clearance of a motion for the validator, segment by segment. A line is decided by the rectangle that
/// the body sweeps. Where the body is no rectangle, it is decided by the parallelogram that an edge sweeps, seen from
/// the body. An arc is bisected until bounds on the distance between body and edges prove it free. No decision is
/// shared with the planner. O(edges near by) a segment, more near contact. World and grid must outlive the use.
class MotionCheck {
 public:
  /// @param grid  of the world's edges.
  MotionCheck(const World& world, const EdgeGrid& grid, const Vehicle& vehicle);

  struct Hit {
    ObstacleId region;
    double arc_length;  ///< [m]
    VertexId edge;      ///< none: the body is inside
  };

  /// The first contact found with an obstacle, and with the bounds, if any. Lowers `clearance`.
  std::vector<Hit> check(const PathSegment& segment);

  [[nodiscard]] double clearance() const;

  /// An axis-parallel rectangle in a frame of the body.
  struct Rectangle {
    double x0, x1, y0, y1;
    [[nodiscard]] double distance_to(const Vec2& p) const;
    /// A lower bound on the distance to an axis-parallel box: the distance along one axis.
    [[nodiscard]] double gap_to(const Box& box) const;
  };
  /// The ends of an edge in a frame of the body.
  struct Ends {
    Vec2 a, b;
  };
  /// An interval of an arc, and an edge that is not proved to stay off the body during it.
  struct Interval {
    double lower;  ///< lower bound on their distance [m]
    double s0, s1;
    VertexId edge;
    Ends before, middle, after;  ///< the edge in the body's frame
    bool operator<(const Interval& other) const {
      return lower > other.lower;
    }  ///< the lowest bound is on top of a queue
  };

 private:
  void set_precision();
  [[nodiscard]] double body_distance(const Pose& pose) const;
  [[nodiscard]] std::optional<ObstacleId> swallowing(const Pose& pose) const;
  [[nodiscard]] std::optional<ObstacleId> region_around(const Vec2& p) const;
  [[nodiscard]] double distance_to_body(const Vec2& a, const Vec2& b) const;
  [[nodiscard]] double hull_to_body(const std::array<Vec2, 4>& hull) const;
  [[nodiscard]] double driven_to(const Ends& ends, const PathSegment& line) const;
  void read_footprint(const VehicleParameters& parameters);
  [[nodiscard]] bool is_near_last_end(const Pose& pose) const;
  template <typename Visit>
  void for_near(const Box& swept, const Visit& visit) const;
  void add_hit(std::vector<Hit>& hits, const Hit& hit) const;
  void check_line(const PathSegment& line, std::vector<Hit>& hits);
  [[nodiscard]] double travel_per_meter(double curvature) const;
  double lower_bound_of(double curvature, const Interval& interval, double travel, bool& contact);
  [[nodiscard]] bool proved(double lower) const;
  void check_arc(const PathSegment& arc, std::vector<Hit>& hits);

  const World& world_;
  const EdgeGrid& grid_;
  Rectangle body_{};  ///< the body, or around it
  std::vector<std::vector<Vec2>>
      parts_;                       ///< the rings of the body in its frame, either way around; none: the rectangle
  std::vector<Vec2> inner_points_;  ///< one in each ring, or the middle of the rectangle
  double reach_ = 0.0;              ///< of the body from F
  std::optional<Pose> last_end_;    ///< of the segment before
  double largest_ = 0.0;            ///< coordinate of the map, and of the path so far
  double largest_heading_ = 0.0;    ///< of the path so far
  double rounding_ = 0.0;           ///< of a distance
  double shortest_travel_ = 0.0, tolerance_ = 0.0;
  double upper_;  ///< clearance that occurs on the path [m]
  double lower_;  ///< proved lower bound so far [m]
};

}  // namespace arcway::internal
