#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/world.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// A circle that F drives on, described as if it drove forwards.
struct DrivenCircle {
  Vec2 center;    ///< [m]
  double radius;  ///< [m], > 0
  Side side;      ///< kLeft: counter-clockwise
  Gear gear;      ///< kReverse: driven the other way round, with the same headings of the body
};

/// The one-way zones of a map, and which motions of F they forbid. Immutable and thread-safe.
///
/// F is in a zone where it is deeper inside than kBorder. The places where a line or a circle has that depth are
/// computed, and each part between two of them is decided by its middle, never by counting crossings. Directions up to
/// kSameDirection beyond the tolerance are allowed. So rounding forbids no lane along a border, nor one of tolerance 0.
class OneWayZones {
 public:
  static constexpr double kBorder = 1e-6;         ///< [m]; a hundredth of what the validator leaves out
  static constexpr double kSameDirection = 1e-9;  ///< [rad]; a thousandth of the validator's tolerance

  /// Null if no zone of the world forbids a direction.
  static std::shared_ptr<const OneWayZones> of(const World& world);
  /// @param zones  those that forbid no direction are left out.
  explicit OneWayZones(std::span<const Zone> zones);

  /// Whether a line is driven against no zone.
  /// @param from  of F, driven forwards.
  /// @param gear  kReverse: driven the other way, with the same heading of the body.
  [[nodiscard]] bool allows_line(const Pose& from, double length, Gear gear) const;
  /// Whether a circle may meet a zone: false only if it is driven against none. O(log zones) where that is so.
  [[nodiscard]] bool are_near(const Vec2& center, double radius) const;
  /// Appends the headings of the body at which a circle is driven against a zone. None if `are_near` is false.
  /// O(zones near by * their edges), or times the edges once more for zones that the circle crosses.
  void append_forbidden(const DrivenCircle& circle, std::vector<HeadingInterval>& forbidden) const;
  /// How far a motion leads until it is driven against a zone [m]; its length if it is not.
  /// @param driven  the gear in which it is driven: not its own where it is followed back from its end.
  [[nodiscard]] double allowed_length(const PathSegment& motion, Gear driven) const;
  /// The zone, among those given, that forbids F to leave or to reach a pose in a gear; kNone if there is none.
  [[nodiscard]] std::uint32_t zone_against(const Pose& pose, Gear gear) const;

  /// The zones that forbid a direction, among those given, ascending.
  [[nodiscard]] std::vector<std::uint32_t> zones() const;

 private:
  struct Area {
    std::uint32_t first, last;  // of its edges
    double heading, most;       // directions up to `most` to either side are allowed
    std::uint32_t zone;

    [[nodiscard]] bool allows(double direction) const;
  };
  void add_ring(const Ring& ring);
  [[nodiscard]] std::span<const LineSegment> edges_of(const Area& area) const;
  [[nodiscard]] bool has_inside(const Area& area, const Vec2& p) const;
  void find_forbidden(const Area& area, const DrivenCircle& circle, std::vector<HeadingInterval>& forbidden) const;
  [[nodiscard]] std::optional<double> entry(const Area& area, const Pose& from, double length) const;

  std::vector<LineSegment> edges_;  // area by area
  std::vector<Area> areas_;
  BoxTree tree_;  // of the areas
};

}  // namespace arcway::internal
