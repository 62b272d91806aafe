#pragma once

#include <memory>
#include <vector>

#include "arcway/sweep_query.h"

namespace arcway::internal {

/// A sweep query with added walls of no thickness: line segments that the body may not touch. It serves walls that come
/// and go while the world stays. Each wall costs a test in every query. As exact as the query that it wraps.
class WalledSweep final : public SweepQuery {
 public:
  /// @param walls  with finite and distinct ends [m].
  WalledSweep(std::shared_ptr<const SweepQuery> base, std::vector<LineSegment> walls)
      : base_(std::move(base)), walls_(std::move(walls)) {}

 private:
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override;
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override;
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override;

  std::shared_ptr<const SweepQuery> base_;
  std::vector<LineSegment> walls_;
};

}  // namespace arcway::internal
