#include "core/passage/dead_end.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "core/geometry/angle.h"
#include "core/passage/local_sweep.h"

namespace arcway {

namespace {

constexpr int kLevels = 2;
constexpr double kCoarsest = 0.15;      // edge of the larger boxes, of the body's half width
constexpr int kFewestHeadings = 128;    // in a full turn, a power of two
constexpr std::int32_t kFurthest = 40;  // boxes away from the end, at the coarsest
constexpr double kStep = 0.25;          // length of a step, of the smallest turning radius
constexpr double kLeastStep = 4.0;      // of a box's edge: shorter ones would get lost in it
constexpr double kMostTurn = 1.5;       // in a step, below a right angle [rad]
constexpr double kRounding = 1e-9;      // relative, that shrunk bodies are smaller by and that steps lead further

struct Range {
  double low, high;
};

/// A box of positions of the reference point and of headings.
struct Box3 {
  std::int32_t x, y, heading;
};

/// From a box to some in a column: how far they are from it, by y from first to last.
struct Move {
  std::int32_t x, first_y, last_y, heading;
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

/// Which of many boxes have been seen, in columns of bits.
class SeenBoxes {
 public:
  // Boxes from -furthest to furthest, and of so many headings.
  SeenBoxes(std::int32_t furthest, std::int32_t headings)
      : furthest_(furthest),
        headings_(headings),
        words_((2 * furthest + kBits) / kBits),
        seen_(static_cast<std::size_t>((2 * furthest + 1) * headings * words_), 0) {}

  /// Calls visit(y) for each box from first_y to last_y that was not seen, in this order. Now they are.
  template <class Visitor>
  void see(std::int32_t x, std::int32_t first_y, std::int32_t last_y, std::int32_t heading, Visitor&& visit) {
    const std::int32_t first = first_y + furthest_, last = last_y + furthest_;
    const auto column = static_cast<std::size_t>(((x + furthest_) * headings_ + heading) * words_);
    for (std::int32_t word = first / kBits; word <= last / kBits; ++word) {
      const std::int32_t begin = word * kBits;
      std::uint64_t asked = ~std::uint64_t{0};
      if (first > begin) asked <<= first - begin;
      if (last < begin + kBits - 1) asked &= (std::uint64_t{2} << (last - begin)) - 1;
      std::uint64_t& known = seen_[column + static_cast<std::size_t>(word)];
      for (std::uint64_t fresh = asked & ~known; fresh != 0; fresh &= fresh - 1)
        visit(begin + std::countr_zero(fresh) - furthest_);
      known |= asked;
    }
  }

 private:
  static constexpr std::int32_t kBits = 64;

  std::int32_t furthest_, headings_, words_;
  std::vector<std::uint64_t> seen_;
};

class ForwardFlood {
 public:
  ForwardFlood(const Pose& from, const Vec2& to, const Footprint& footprint, double radius, LocalSweep& sweep,
               int level)
      : sweep_(sweep),
        from_(from),
        to_(to),
        radius_(radius),
        headings_(kFewestHeadings << level),
        furthest_(kFurthest << level),
        edge_(kCoarsest * footprint.half_width / (1 << level)),
        step_(std::max(kStep * radius, kLeastStep * edge_)),
        turned_steps_(turned_steps()),
        bodies_(static_cast<std::size_t>(headings_)),
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
    SeenBoxes seen(furthest_, headings_);
    std::vector<Box3> open;
    seen.see(0, 0, 0, 0, [&](std::int32_t y) { open.push_back({0, y, 0}); });
    const double near = step_ + edge_;
    for (std::size_t checks = 0; !open.empty(); ++checks) {
      // The last one first, and not asked about before: where there is a way out, it is found soon.
      const Box3 box = open.back();
      open.pop_back();
      if (checks > max_checks) return End::kGivenUp;
      if (checks > 0 && !is_free(box)) continue;
      const Vec2 position = position_of(box);
      if (is_far(box) || (position - to_).norm() < near) return End::kOpen;
      reach_ = std::max(reach_, (position - from_.position()).norm() + near);
      for (const Move& move : moves_from(box.heading)) {
        const std::int32_t x = box.x + move.x, heading = (box.heading + move.heading) & (headings_ - 1);
        const std::int32_t first = box.y + move.first_y, last = box.y + move.last_y;
        const auto add = [&](std::int32_t y) { open.push_back({x, y, heading}); };
        if (!is_far({x, first, heading}) && !is_far({x, last, heading})) {
          seen.see(x, first, last, heading, add);
          continue;
        }
        for (std::int32_t y = first; y <= last; ++y)
          if (is_far({x, y, heading})) {
            add(y);
          } else {
            seen.see(x, y, y, heading, add);
          }
      }
    }
    return End::kClosed;
  }

  [[nodiscard]] double reach() const { return reach_; }

 private:
  [[nodiscard]] bool is_far(const Box3& box) const { return std::max(std::abs(box.x), std::abs(box.y)) > furthest_; }
  [[nodiscard]] bool is_free(const Box3& box) {
    auto& body = bodies_[static_cast<std::size_t>(box.heading)];
    if (!body) body = swept_rectangle({0.0, 0.0, heading_of(box.heading)}, 0.0, core_);
    SweptRectangle placed = *body;
    for (Vec2& corner : placed) corner += position_of(box);
    return sweep_.straight_free(placed);
  }
  [[nodiscard]] double heading_of(std::int32_t heading) const { return from_.heading + kTwoPi * heading / headings_; }
  [[nodiscard]] Vec2 position_of(const Box3& box) const { return from_.position() + edge_ * Vec2(box.x, box.y); }
  // Where steps may end that turn by so many headings, and half a one more or less.
  struct Turned {
    std::int32_t headings;
    Range x, y;
  };

  std::vector<Turned> turned_steps() const {
    std::vector<Turned> steps;
    const double part = kTwoPi / headings_;
    const double most = step_ / radius_;
    const auto furthest_turn = static_cast<std::int32_t>(most / part + 1.0);
    for (std::int32_t turned = -furthest_turn; turned <= furthest_turn; ++turned) {
      const Range turn{std::max(-most, (turned - 1) * part), std::min(most, (turned + 1) * part)};
      const auto [x, y] = places_after(step_, radius_, turn);
      steps.push_back({turned, x, y});
    }
    return steps;
  }

  // To all boxes in which a step from a box with this heading may end.
  const std::vector<Move>& moves_from(std::int32_t heading) {
    std::vector<Move>& moves = moves_[static_cast<std::size_t>(heading)];
    if (!moves.empty()) return moves;
    // Headings in the box are off by half a part.
    const double sine = std::sin(kPi / headings_), lost = 1.0 - std::cos(kPi / headings_);
    const Vec2 ahead = direction_of(heading_of(heading));
    for (const auto& [turned, x, y] : turned_steps_) {
      const double aside = std::max(-y.low, y.high);
      const double more_ahead = aside * sine + x.high * lost + kRounding * step_;
      const double more_aside = x.high * sine + aside * lost + kRounding * step_;
      const Vec2 middle = 0.5 * (x.low + x.high) * ahead + 0.5 * (y.low + y.high) * perpendicular(ahead);
      const double half_x = 0.5 * (x.high - x.low) + more_ahead, half_y = 0.5 * (y.high - y.low) + more_aside;
      const Vec2 half = half_x * ahead.cwiseAbs() + half_y * perpendicular(ahead).cwiseAbs() + Vec2(edge_, edge_);
      const auto first = [&](double d) { return static_cast<std::int32_t>(std::ceil(d / edge_)); };
      const auto last = [&](double d) { return static_cast<std::int32_t>(std::floor(d / edge_)); };
      for (std::int32_t i = first(middle.x() - half.x()); i <= last(middle.x() + half.x()); ++i)
        moves.push_back({i, first(middle.y() - half.y()), last(middle.y() + half.y()), turned});
    }
    return moves;
  }

  LocalSweep& sweep_;
  Pose from_;
  Vec2 to_;
  double radius_;
  std::int32_t headings_, furthest_;
  double edge_, step_;
  Footprint core_{};
  std::vector<Turned> turned_steps_;
  // By heading, once they were asked for: the body with the reference point at the origin, and the moves.
  std::vector<std::optional<SweptRectangle>> bodies_;
  std::vector<std::vector<Move>> moves_;
  double reach_ = 0.0;
};

// What the body may cover in the boxes about a position, of either size.
Box place_around(const Vec2& position, const Footprint& footprint) {
  const double boxes = kFurthest * kCoarsest * footprint.half_width;
  const double reach = boxes + std::max(footprint.front, footprint.rear) + footprint.half_width;
  return Box{position, position}.grown(reach);
}

}  // namespace

std::optional<DeadEnd> find_dead_end(const Pose& start, const Pose& goal, const Footprint& footprint, double radius,
                                     const SweepQuery& sweep, const Outlines& outlines, std::size_t max_checks) {
  // Whoever drives from where it came sees the body the other way round.
  const Pose turned{goal.x, goal.y, goal.heading + kPi};
  const Footprint swapped{footprint.rear, footprint.front, footprint.half_width};
  LocalSweep near_start(sweep, outlines, place_around(start.position(), footprint));
  LocalSweep near_goal(sweep, outlines, place_around(goal.position(), footprint));
  std::array<bool, 2> given_up{};  // smaller boxes would be even more
  for (int level = 0; level < kLevels; ++level)
    for (const bool at_start : {true, false}) {
      if (given_up[at_start]) continue;
      ForwardFlood flood(at_start ? start : turned, at_start ? goal.position() : start.position(),
                         at_start ? footprint : swapped, radius, at_start ? near_start : near_goal, level);
      const ForwardFlood::End end = flood.run(max_checks << level);
      if (end == ForwardFlood::End::kClosed) return DeadEnd{at_start, flood.reach()};
      given_up[at_start] = end == ForwardFlood::End::kGivenUp;
    }
  return std::nullopt;
}

}  // namespace arcway
