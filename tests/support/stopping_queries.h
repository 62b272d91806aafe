#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stop_token>

#include "arcway/query_set.h"

namespace arcway::internal::test {

/// The reference's queries, which count what they are asked and request a stop at a given question: a deadline that is
/// the same on every machine. For one thread.
class StoppingQueries {
 public:
  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

  explicit StoppingQueries(const World& world) : exact_(make_reference_queries(world)) {}

  /// With a new stop, requested at the question of this number from now on, from 1.
  std::stop_token stop_at(std::size_t question) {
    count_->asked = 0;
    count_->last = question;
    count_->stop = std::stop_source();
    return count_->stop.get_token();
  }
  /// Since stop_at.
  [[nodiscard]] std::size_t asked() const { return count_->asked; }
  [[nodiscard]] std::size_t asked_after_stop() const {
    return count_->asked > count_->last ? count_->asked - count_->last : 0;
  }

  [[nodiscard]] QuerySet queries() const {
    return {std::make_shared<const Visibility>(exact_.visibility, count_), exact_.distance,
            std::make_shared<const Sweep>(exact_.sweep, count_)};
  }

 private:
  struct Count {
    std::size_t asked = 0, last = kNever;
    std::stop_source stop;
    void add(std::size_t questions) {
      asked += questions;
      if (asked >= last) stop.request_stop();
    }
  };

  class Visibility final : public VisibilityQuery {
   public:
    Visibility(std::shared_ptr<const VisibilityQuery> exact, std::shared_ptr<Count> count)
        : exact_(std::move(exact)), count_(std::move(count)) {}

   private:
    void do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const override {
      count_->add(segments.size());
      exact_->visible(segments, visible);
    }
    std::shared_ptr<const VisibilityQuery> exact_;
    std::shared_ptr<Count> count_;
  };

  class Sweep final : public SweepQuery {
   public:
    Sweep(std::shared_ptr<const SweepQuery> exact, std::shared_ptr<Count> count)
        : exact_(std::move(exact)), count_(std::move(count)) {}

   private:
    void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override {
      count_->add(rectangles.size());
      exact_->straight_free(rectangles, free);
    }
    void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override {
      count_->add(bodies.size());
      exact_->straight_free(bodies, free);
    }
    void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override {
      count_->add(bodies.size());
      exact_->free_headings(bodies, result);
    }
    std::shared_ptr<const SweepQuery> exact_;
    std::shared_ptr<Count> count_;
  };

  QuerySet exact_;
  std::shared_ptr<Count> count_ = std::make_shared<Count>();
};

}  // namespace arcway::internal::test
