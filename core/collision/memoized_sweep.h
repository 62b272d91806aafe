#pragma once

#include <memory>

#include "arcway/sweep_query.h"

namespace arcway::internal {

/// A sweep query that remembers the answers of another one, bit for bit. It serves planners on one world that ask
/// nearly the same questions in turn. It remembers up to a million questions, some 100 bytes each, and passes later
/// ones on. A remembered answer takes less than a microsecond. Bodies' shapes must outlive this. Thread-safe.
class MemoizedSweep final : public SweepQuery {
 public:
  explicit MemoizedSweep(std::shared_ptr<const SweepQuery> base);
  ~MemoizedSweep() override;

 private:
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override;
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override;
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override;

  struct Memory;
  std::shared_ptr<const SweepQuery> base_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace arcway::internal
