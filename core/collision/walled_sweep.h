#pragma once

#include <memory>
#include <vector>

#include "arcway/sweep_query.h"

namespace arcway::internal {

/// A sweep query's world with walls without thickness in it: line segments that the body may not touch. For walls that
/// come and go while the world stays; each costs a test on every question. Exact as the query that it is made from.
class WalledSweep final : public SweepQuery {
 public:
  /// @param walls  their ends are finite and differ.
  WalledSweep(std::shared_ptr<const SweepQuery> base, std::vector<LineSegment> walls)
      : base_(std::move(base)), walls_(std::move(walls)) {}

 private:
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override;
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override;

  std::shared_ptr<const SweepQuery> base_;
  std::vector<LineSegment> walls_;
};

}  // namespace arcway::internal
