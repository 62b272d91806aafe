#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/attach/attachment_links.h"
#include "core/attach/search_context.h"
#include "core/collision/clearance_cost.h"
#include "core/motion/speed_tree.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// The times of the paths of one search: its speed tree, extended by arcs, lines and connections of attachments. Beside
/// them, what driving close to obstacles has cost up to each joint. That depends on no speed, so that it only shifts
/// the time at every speed.
class SearchTimes {
 public:
  /// Begins a search: forgets the one before or, with a warm start, continues it.
  void begin(const SearchContext& context, bool warm_start);

  void reserve(std::size_t joints) { speeds_.reserve(joints); }
  void warm_up(std::size_t joints) { speeds_.warm_up(joints); }
  [[nodiscard]] const SpeedTree& speeds() const { return speeds_; }
  /// Forgets the joints added last.
  void truncate(std::size_t size);

  /// What driving close to obstacles has cost up to a joint [s]; 0 without a preference.
  [[nodiscard]] double clearance_cost(std::uint32_t joint) const {
    return clearance_ == nullptr ? 0.0 : clearance_costs_[joint];
  }

  /// Adds the connection of a start attachment; returns the joint at its end.
  std::uint32_t add_connection(const AttachmentCircle& from);
  /// An arc from a joint of the tree, and the line after it, which leads to the next circle.
  struct Drive {
    std::uint32_t joint;  ///< at the begin of the arc
    double arc;           ///< length [m]
    double radius;        ///< of the arc [m]
    double line;          ///< length [m]
    double next_radius;   ///< of the next circle [m]
  };
  /// Whether zones limit speeds, or clearance is preferred. Costs then depend on places: see `add_segment`.
  [[nodiscard]] bool depends_on_places() const { return zones_ != nullptr || clearance_ != nullptr; }
  /// Adds a segment behind a joint, with the limits of the vehicle and of zones, and what driving close on it costs;
  /// returns the joint at its end. Where a limit falls, a joint without length slows the vehicle first. Precondition:
  /// depends_on_places().
  /// @param next_limit  on what follows; 0 to stop [m/s].
  std::uint32_t add_segment(std::uint32_t joint, const PathSegment& segment, double next_limit);
  /// Adds a turn on a circle of the graph likewise.
  std::uint32_t add_turn(std::uint32_t joint, std::uint32_t circle, const PathSegment& arc, double next_limit);
  /// What driving close costs in a turn on a circle of the graph [s].
  [[nodiscard]] double turn_cost(std::uint32_t circle, double heading, double turn) const;
  /// Where turns on a circle of a start cost something.
  [[nodiscard]] std::vector<ClearanceCost::CloseHeadings> close_headings(const TurnCircle& circle) const;
  /// Adds a drive; returns the joint at its end.
  std::uint32_t add_drive(const Drive& drive);
  /// The joint of add_drive, without adding it. Its time includes what driving close has cost up to the drive, but not
  /// on it: a lower bound where costs depend on places.
  [[nodiscard]] SpeedTree::Joint drive(const Drive& drive) const;
  /// The exact time of a complete path [s]: from a joint by an arc, a link to a goal's circle, and what follows.
  /// Infinity if it cannot end at the goal's speed.
  double time_to_goal(std::uint32_t joint, double arc, double radius, const AttachmentLink& link,
                      const AttachmentCircle& to);
  /// A link to a goal, and what driving close costs from its line on [s]: found here if negative.
  struct LinkToGoal {
    const AttachmentLink& link;
    const AttachmentCircle& to;
    double& close_cost;
  };
  /// The exact cost of a complete path that depends on places: its time with the limits of zones, and that of driving
  /// close [s]. Infinity as above.
  /// @param arc  on the last circle of the graph, `circle`.
  double time_to_goal(std::uint32_t joint, std::uint32_t circle, const PathSegment& arc, const LinkToGoal& goal);

 private:
  // A segment as far as speeds depend on it.
  struct Stretch {
    double length;
    double limit;
    Gear gear;
  };
  [[nodiscard]] Stretch stretch_of(const PathSegment& segment) const;
  std::uint32_t add_parts(std::uint32_t joint, const PathSegment& segment, double next_limit, double clearance_cost);
  std::uint32_t add_stretch(std::uint32_t joint, const Stretch& stretch, const Stretch& next);
  // Whether what driving close costs on a path is added.
  enum class CloseCost { kCounts, kIsKnown };
  std::uint32_t add_path(std::uint32_t joint, std::span<const PathSegment> path, double next_limit, CloseCost cost);
  std::uint32_t add_stop(std::uint32_t joint);
  double cost_at_goal(std::uint32_t joint, std::size_t size);

  const SearchContext* context_ = nullptr;
  const SpeedZones* zones_ = nullptr;
  const ClearanceCost* clearance_ = nullptr;
  double line_speed_ = 0.0;
  SpeedTree speeds_;
  std::vector<double> clearance_costs_;     // by joint, from the start on [s]; empty without a preference
  std::vector<SpeedZones::Stretch> parts_;  // of a segment
  Path last_;                               // from the last circle of the graph to the goal
};

}  // namespace arcway::internal
