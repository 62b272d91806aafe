#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arcway/clearance_preference.h"
#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/collision/close_lengths.h"
#include "core/model/outlines.h"
#include "core/zones/zone_area.h"

namespace arcway::internal {

/// What driving close to obstacles costs, by the preference of a planner and by the clearance zones of its map. Each of
/// them counts on its own: where several hold, their costs add up. It does not depend on speeds or gears. Exact as
/// CloseLengths are. Immutable; thread-safe.
class ClearanceCost {
 public:
  /// A cost of driving closer than a distance, everywhere or in a zone.
  struct Rule {
    CloseLengths close;
    double cost;                   ///< [s/m], >= 0
    std::uint32_t zone = kNone;    ///< among those of the world; kNone: everywhere
    std::optional<ZoneArea> area;  ///< of the zone

    /// What F drives close on a segment, in the zone if it is one's [m].
    [[nodiscard]] double close_length(const PathSegment& segment) const;
    /// Whether driving close on a segment, or a part of it, costs something.
    [[nodiscard]] bool counts_on(const PathSegment& segment) const;
    /// Whether a motion of F within a box may cost something.
    [[nodiscard]] bool may_count_in(const Box& box) const;
  };

  /// Null if neither the planner nor a zone prefers clearance.
  /// @param outlines  of the world.
  static std::shared_ptr<const ClearanceCost> of(const Vehicle& vehicle,
                                                 const std::shared_ptr<const Outlines>& outlines,
                                                 const std::optional<ClearancePreference>& preference,
                                                 std::span<const Zone> zones);
  /// The cost of one preference.
  ClearanceCost(const Vehicle& vehicle, std::shared_ptr<const Outlines> outlines,
                const ClearancePreference& preference);

  /// The preference of the planner, if it has one, then zones, ascending.
  [[nodiscard]] std::span<const Rule> rules() const { return rules_; }
  /// Whether no rule costs anything, so that close driving is measured only.
  [[nodiscard]] bool costs_nothing() const;

  /// The cost of a segment [s].
  [[nodiscard]] double of(const PathSegment& segment) const;
  /// The cost of a path [s].
  [[nodiscard]] double of(std::span<const PathSegment> path) const;

  /// Where turns on a circle cost something.
  struct CloseHeadings {
    double cost;                            ///< [s/m], > 0
    std::vector<HeadingInterval> headings;  ///< which may overlap
  };
  /// Those of all rules that count on a circle of F.
  /// @param radius  [m], > 0
  [[nodiscard]] std::vector<CloseHeadings> close_headings(const Vec2& center, double radius, Side side) const;

 private:
  ClearanceCost() = default;

  std::vector<Rule> rules_;
};

/// A turn from a heading to a side.
struct Turn {
  double radius;  ///< of F's circle [m]
  Side side;
  double heading;  ///< at its begin [rad]
  double angle;    ///< [rad], >= 0
};
/// What a turn on a circle costs, of which it is known where turns cost something [s].
double turn_cost(std::span<const ClearanceCost::CloseHeadings> close, const Turn& turn);

/// The cost of driving close on a path [s]; 0 without a preference.
/// @param cost  may be null.
inline double clearance_cost(const ClearanceCost* cost, std::span<const PathSegment> path) {
  return cost == nullptr ? 0.0 : cost->of(path);
}

}  // namespace arcway::internal
