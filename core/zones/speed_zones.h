#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/world.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// The speed limits of a map's zones along motions of F. Immutable and thread-safe.
///
/// A segment is cut where F crosses the edge of a zone. Its stretches between two crossings are decided by their
/// middles, never by counting crossings. A point on the border is in the zone. Limits hold kCapMargin of the map's size
/// longer than the zone lasts, so that a checker that rounds otherwise finds no excess. A segment that ends within
/// twice that has the limit to its end: parts of a segment that are cut again get no other limits.
class SpeedZones {
 public:
  /// Null if no zone of the world limits the speed.
  static std::shared_ptr<const SpeedZones> of(const World& world);
  /// @param zones  those that limit no speed are left out.
  explicit SpeedZones(std::span<const Zone> zones);

  /// A part of a segment with one limit.
  struct Stretch {
    double length;  ///< [m], > 0 unless the segment has no length
    double cap;     ///< [m/s]; infinity outside of all zones
  };
  /// The stretches of a segment, in its order. Their lengths add up to its length. Neighbors have different caps.
  /// O(log n + edges whose boxes meet that of the segment).
  void cut(const PathSegment& segment, std::vector<Stretch>& stretches) const;

  /// The lowest limit of the zones that a point lies in [m/s]; infinity in none.
  [[nodiscard]] double cap_at(const Vec2& point) const;
  /// A disc about a point, in which one limit holds everywhere.
  struct Disc {
    double cap;     ///< [m/s]; infinity if the point lies in no zone
    double radius;  ///< [m]
  };
  /// The disc up to the border of the zone whose limit is the lowest at a point.
  [[nodiscard]] Disc disc_around(const Vec2& point) const;
  /// The zone with that limit, among those given; kNone if there is none.
  [[nodiscard]] std::uint32_t zone_at(const Vec2& point) const;

 private:
  struct Limit {
    std::uint32_t first, last;  // of its edges
    double speed;
    std::uint32_t zone;
  };
  [[nodiscard]] const Limit* lowest_at(const Vec2& point) const;
  void add_ring(const Ring& ring);

  std::vector<LineSegment> edges_;  // zone by zone
  std::vector<Limit> limits_;
  BoxTree edge_tree_, zone_tree_;
  double margin_ = 0.0;  // by which limits hold longer than their zones [m]
};

/// A path cut at the borders of zones, and the limit on each of its segments.
struct CappedPath {
  std::vector<PathSegment> segments;
  std::vector<double> caps;          ///< [m/s]; infinity outside of all zones
  std::vector<std::uint32_t> first;  ///< by segment of the path: its first one here; then their number
};
/// Cuts a path.
void cut(std::span<const PathSegment> path, const SpeedZones& zones, CappedPath& capped);

}  // namespace arcway::internal
