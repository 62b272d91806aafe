#pragma once

#include "arcway/distance_query.h"
#include "arcway/sweep_query.h"
#include "arcway/visibility_query.h"
#include "arcway/world.h"

namespace arcway::internal {

/// The brute-force implementation of all three query interfaces: it tries every edge. All other implementations must
/// agree with it. O(edges) a query.
class BruteForceQuery final : public VisibilityQuery, public DistanceQuery, public SweepQuery {
 public:
  explicit BruteForceQuery(World world) : world_(std::move(world)) {}

 private:
  void do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const override;
  void do_closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const override;
  void do_closer_than(std::span<const Vec2> points, std::span<const double> distances,
                      std::span<std::uint8_t> closer) const override;
  void do_containing(std::span<const Vec2> points, std::span<ObstacleId> result) const override;
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override;
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override;
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override;

  World world_;
};

}  // namespace arcway::internal
