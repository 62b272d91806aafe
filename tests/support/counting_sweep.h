#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "arcway/query_set.h"

namespace arcway::internal::test {

/// The reference, which counts what it was asked.
class CountingSweep final : public SweepQuery {
 public:
  explicit CountingSweep(const World& world) : exact_(make_reference_queries(world).sweep) {}
  [[nodiscard]] std::size_t asked() const { return asked_; }  ///< about straights
  [[nodiscard]] std::size_t headings_asked() const { return headings_asked_; }

 private:
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override {
    asked_ += rectangles.size();
    exact_->straight_free(rectangles, free);
  }
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override {
    asked_ += bodies.size();
    exact_->straight_free(bodies, free);
  }
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override {
    headings_asked_ += bodies.size();
    exact_->free_headings(bodies, result);
  }

  std::shared_ptr<const SweepQuery> exact_;
  mutable std::size_t asked_ = 0, headings_asked_ = 0;
};

}  // namespace arcway::internal::test
