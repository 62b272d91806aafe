#include "core/passage/dead_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/geometry/angle.h"

namespace arcway {

namespace {

constexpr int kLevels = 2;
constexpr double kCoarsest = 0.15;      // edge of the larger boxes, of the body's half width
constexpr int kFewestHeadings = 128;    // in a full turn
constexpr std::int32_t kFurthest = 40;  // boxes away from the end, at the coarsest
constexpr double kStep = 0.25;          // length of a step, of the smallest turning radius
constexpr double kLeastStep = 4.0;      // of a box's edge: shorter ones would get lost in it
constexpr double kMostTurn = 1.5;       // in a step, below a right angle [rad]
constexpr double kRounding = 1e-9;      // relative, that shrunk bodies are smaller by and that steps lead further

struct Range {
  double low, high;
};

/// A box of positions of the reference point and of headings, or how far one is from another.
struct Box3 {
  std::int32_t x, y, heading;
};

/// Where a step of length `step` leads that turns by an angle in `turn`, seen from its begin: x ahead, y to the left.
/// The heading on the way lies between those of the sharpest turns out and back; all bounds are attained.
std::array<Range, 2> places_after(double step, double radius, const Range& turn) {
  const double most = step / radius;
  const double least = turn.low > 0.0 ? turn.low : turn.high < 0.0 ? -turn.high : 0.0;  // of the angle's size
  const double largest = std::max(-turn.low, turn.high);
  const auto to_the_left = [&](double angle) {
    return radius * (1.0 + std::cos(angle) - 2.0 * std::cos(0.5 * (most + angle)));
  };
  return {{{radius * (2.0 * std::sin(0.5 * (most + largest)) - std::sin(largest)),
            step - radius * (least - std::sin(least))},
           {-to_the_left(-turn.low), to_the_left(turn.high)}}};
}

class ForwardFlood {
 public:
  ForwardFlood(const Pose& from, const Vec2& to, const Footprint& footprint, double radius, const SweepQuery& sweep,
               int level)
      : sweep_(sweep),
        from_(from),
        to_(to),
        radius_(radius),
        headings_(kFewestHeadings << level),
        furthest_(kFurthest << level),
        edge_(kCoarsest * footprint.half_width / (1 << level)),
        step_(std::max(kStep * radius, kLeastStep * edge_)),
        moves_(static_cast<std::size_t>(headings_)) {
    const double length = std::max(footprint.front, footprint.rear);
    const double largest = std::max(from.position().cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
    const double turn = std::sin(kPi / headings_);
    // What the body covers wherever it is in a box.
    const double shift = edge_ * std::sqrt(0.5) + kRounding * (length + largest);
    const double shorter = turn * footprint.half_width + shift;
    core_ = {footprint.front - shorter, footprint.rear - shorter, footprint.half_width - turn * length - shift};
  }

  enum class End { kClosed, kOpen, kGivenUp };
  End run(std::size_t max_checks) {
    if (core_.half_width <= 0.0 || core_.front + core_.rear <= 0.0 || step_ > kMostTurn * radius_) return End::kOpen;
    const auto width = static_cast<std::size_t>(2 * furthest_ + 1);
    seen_.assign(width * width * static_cast<std::size_t>(headings_), false);
    std::vector<Box3> open{{0, 0, 0}};
    seen_[index_of(open[0])] = true;
    const double near = step_ + edge_;
    for (std::size_t checks = 0; !open.empty(); ++checks) {
      // The last one first, and not asked about before: where there is a way out, it is found soon.
      const Box3 box = open.back();
      open.pop_back();
      if (checks > max_checks) return End::kGivenUp;
      if (checks > 0 && !is_free(box)) continue;
      const Vec2 position = center_of(box).position();
      if (is_far(box) || (position - to_).norm() < near) return End::kOpen;
      reach_ = std::max(reach_, (position - from_.position()).norm() + near);
      for (const Box3& move : moves_from(box.heading)) {
        const Box3 next{box.x + move.x, box.y + move.y, (box.heading + move.heading + headings_) % headings_};
        if (!is_far(next)) {
          const std::size_t index = index_of(next);
          if (seen_[index]) continue;
          seen_[index] = true;
        }
        open.push_back(next);
      }
    }
    return End::kClosed;
  }

  [[nodiscard]] double reach() const { return reach_; }

 private:
  [[nodiscard]] bool is_far(const Box3& box) const { return std::max(std::abs(box.x), std::abs(box.y)) > furthest_; }
  [[nodiscard]] bool is_free(const Box3& box) const {
    return sweep_.straight_free(swept_rectangle(center_of(box), 0.0, core_));
  }
  [[nodiscard]] double heading_of(std::int32_t heading) const { return from_.heading + kTwoPi * heading / headings_; }
  [[nodiscard]] Pose center_of(const Box3& box) const {
    return {from_.x + edge_ * box.x, from_.y + edge_ * box.y, heading_of(box.heading)};
  }
  [[nodiscard]] std::size_t index_of(const Box3& box) const {
    const std::int32_t width = 2 * furthest_ + 1;
    return (static_cast<std::size_t>(box.x + furthest_) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(box.y + furthest_)) *
               static_cast<std::size_t>(headings_) +
           static_cast<std::size_t>(box.heading);
  }

  // To all boxes in which a step from a box with this heading may end.
  const std::vector<Box3>& moves_from(std::int32_t heading) {
    std::vector<Box3>& moves = moves_[static_cast<std::size_t>(heading)];
    if (!moves.empty()) return moves;
    const double part = kTwoPi / headings_;
    const double most = step_ / radius_;
    const Vec2 ahead = direction_of(heading_of(heading));
    const auto furthest_turn = static_cast<std::int32_t>(most / part + 1.0);
    for (std::int32_t turned = -furthest_turn; turned <= furthest_turn; ++turned) {
      const Range turn{std::max(-most, (turned - 1) * part), std::min(most, (turned + 1) * part)};
      const auto [x, y] = places_after(step_, radius_, turn);
      // Headings in the box are off by half a part.
      const double aside = std::max(-y.low, y.high), sine = std::sin(0.5 * part), lost = 1.0 - std::cos(0.5 * part);
      const double more_ahead = aside * sine + x.high * lost + kRounding * step_;
      const double more_aside = x.high * sine + aside * lost + kRounding * step_;
      const Vec2 middle = 0.5 * (x.low + x.high) * ahead + 0.5 * (y.low + y.high) * perpendicular(ahead);
      const double half_x = 0.5 * (x.high - x.low) + more_ahead, half_y = 0.5 * (y.high - y.low) + more_aside;
      const Vec2 half = half_x * ahead.cwiseAbs() + half_y * perpendicular(ahead).cwiseAbs() + Vec2(edge_, edge_);
      const auto first = [&](double d) { return static_cast<std::int32_t>(std::ceil(d / edge_)); };
      const auto last = [&](double d) { return static_cast<std::int32_t>(std::floor(d / edge_)); };
      for (std::int32_t i = first(middle.x() - half.x()); i <= last(middle.x() + half.x()); ++i)
        for (std::int32_t j = first(middle.y() - half.y()); j <= last(middle.y() + half.y()); ++j)
          moves.push_back({i, j, turned});
    }
    return moves;
  }

  const SweepQuery& sweep_;
  Pose from_;
  Vec2 to_;
  double radius_;
  std::int32_t headings_, furthest_;
  double edge_, step_;
  Footprint core_{};
  std::vector<std::vector<Box3>> moves_;  // by heading; empty until asked for
  std::vector<bool> seen_;
  double reach_ = 0.0;
};

}  // namespace

std::optional<DeadEnd> find_dead_end(const Pose& start, const Pose& goal, const Footprint& footprint, double radius,
                                     const SweepQuery& sweep, std::size_t max_checks) {
  // Whoever drives from where it came sees the body the other way round.
  const Pose turned{goal.x, goal.y, goal.heading + kPi};
  const Footprint swapped{footprint.rear, footprint.front, footprint.half_width};
  std::array<bool, 2> given_up{};  // smaller boxes would be even more
  for (int level = 0; level < kLevels; ++level)
    for (const bool at_start : {true, false}) {
      if (given_up[at_start]) continue;
      ForwardFlood flood(at_start ? start : turned, at_start ? goal.position() : start.position(),
                         at_start ? footprint : swapped, radius, sweep, level);
      const ForwardFlood::End end = flood.run(max_checks << level);
      if (end == ForwardFlood::End::kClosed) return DeadEnd{at_start, flood.reach()};
      given_up[at_start] = end == ForwardFlood::End::kGivenUp;
    }
  return std::nullopt;
}

}  // namespace arcway
