#include "core/gaps/dead_end.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "arcway/angle.h"
#include "core/base/paged_array.h"
#include "core/gaps/local_sweep.h"

namespace arcway::internal {

namespace {

constexpr double kCoarsest = 0.075;     // edge of the largest boxes, in widths of the body
constexpr int kFewestHeadings = 128;    // number of heading intervals of the largest boxes; a power of two
constexpr std::int32_t kFurthest = 40;  // distance from the end that counts as left, in largest boxes
constexpr double kStep = 0.25;          // length of a step, in smallest turning radii
constexpr double kLeastStep = 4.0;      // least length of a step, in edges of a box: shorter steps get lost in it
constexpr double kMostTurn = 1.5;       // largest turn in a step [rad], below a right angle
constexpr double kLongestStep =
    2.0;  // longest step, in units of `kFurthest` boxes: longer ones leave the neighborhood at once
constexpr double kStepRounding = 1e-9;  // share by which tested bodies are smaller and steps longer, against rounding

struct Range {
  double low, high;
};

/// A box of positions of the reference point and of headings.
struct PoseBox {
  std::int32_t x, y, heading;
};

/// The moves from a box to the boxes at one position. They differ from the box by (x, y) in position, and by any number
/// of headings from the first turn to the last.
struct Move {
  std::int32_t x, y, first_turn, last_turn;
};

/// The ranges of x (ahead) and y (to the left) to which a step of length `step` leads that turns by an angle in `turn`.
/// Along the step, the heading lies between those of the sharpest turns out and back. All bounds are attained.
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

/// A set of boxes, one bit each. The bits of one position lie together.
class SeenBoxes {
 public:
  // @param furthest  positions are from -furthest to furthest along both axes.
  // @param headings  number of headings: a power of two, at least kBits.
  SeenBoxes(std::int32_t furthest, std::int32_t headings, PagedArray<std::uint32_t>& memory)
      : furthest_(furthest), across_(2 * furthest + 1), words_(headings / kBits), seen_(memory) {
    seen_.clear();
    seen_.make_room(static_cast<std::size_t>(across_) * static_cast<std::size_t>(across_) *
                    static_cast<std::size_t>(words_));
  }

  /// Adds the boxes of `count` headings at a position, from a heading on. Calls visit(heading) for those that are new.
  template <class Visitor>
  void see(std::int32_t x, std::int32_t y, std::int32_t first_heading, std::int32_t count, Visitor&& visit) {
    const std::int32_t position = (x + furthest_) * across_ + y + furthest_;
    // Those of a position lie in one page, as both are powers of two.
    std::uint32_t* const place = &seen_[static_cast<std::size_t>(position) * static_cast<std::size_t>(words_)];
    for (std::int32_t done = 0; done < count; done += kBits) {
      const std::int32_t first = (first_heading + done) & (words_ * kBits - 1);
      const std::int32_t word = first / kBits, begin = word * kBits;
      std::uint32_t &low = place[word], &high = place[(word + 1) & (words_ - 1)];
      const std::uint64_t asked = ((std::uint64_t{1} << std::min(kBits, count - done)) - 1) << (first - begin);
      std::uint64_t fresh = asked & ~(low | std::uint64_t{high} << kBits);
      if (fresh == 0) continue;
      low |= static_cast<std::uint32_t>(asked);
      high |= static_cast<std::uint32_t>(asked >> kBits);
      for (; fresh != 0; fresh &= fresh - 1) visit((begin + std::countr_zero(fresh)) & (words_ * kBits - 1));
    }
  }

 private:
  static constexpr std::int32_t kBits = 32;

  std::int32_t furthest_, across_, words_;
  PagedArray<std::uint32_t>& seen_;
};

class ForwardFlood {
 public:
  // A body, and the part of its world that it may touch.
  struct Body {
    Footprint footprint;
    double radius;
    LocalSweep& sweep;
  };
  ForwardFlood(const Pose& from, const Vec2& to, const Body& body, int level)
      : sweep_(body.sweep),
        from_(from),
        to_(to),
        radius_(body.radius),
        headings_(kFewestHeadings << level),
        furthest_(kFurthest << level),
        edge_(kCoarsest * body.footprint.width() / (1 << level)),
        step_(std::max(kStep * radius_, kLeastStep * edge_)),
        bodies_(static_cast<std::size_t>(headings_)),
        moves_(static_cast<std::size_t>(headings_)) {
    const Footprint& footprint = body.footprint;
    const double length = std::max(footprint.front, footprint.rear);
    const double largest = std::max(from.position().cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
    const double turn = std::sin(kPi / headings_);
    // What the body covers wherever it is in a box.
    const double shift = edge_ * std::sqrt(0.5) + kStepRounding * (length + largest);
    const double shorter = turn * std::max(footprint.left, footprint.right) + shift, slimmer = turn * length + shift;
    core_ = {footprint.front - shorter, footprint.rear - shorter, footprint.left - slimmer, footprint.right - slimmer};
  }

  enum class End { kClosed, kOpen, kOpenAtOnce, kGivenUp };
  End run(std::size_t max_checks, PagedArray<std::uint32_t>& memory, const StopClock& clock) {
    if (core_.width() <= 0.0 || core_.length() <= 0.0 || step_ > kMostTurn * radius_ ||
        step_ > kLongestStep * furthest_ * edge_)
      return End::kOpen;
    if (clock.is_over()) return End::kGivenUp;
    turned_steps_ = turned_steps();  // their number is bounded by what was just asked
    SeenBoxes seen(furthest_, headings_, memory);
    std::vector<PoseBox> open;
    seen.see(0, 0, 0, 1, [&](std::int32_t heading) { open.push_back({0, 0, heading}); });
    const double near = step_ + edge_;
    bool has_collided = false;
    StopTicker ticker(clock);
    for (std::size_t checks = 0; !open.empty(); ++checks) {
      // Boxes are expanded last in, first out, so that a path out is found soon.
      const PoseBox box = open.back();
      open.pop_back();
      if (checks > max_checks || ticker.is_over()) return End::kGivenUp;
      if (checks > 0 && !is_free(box)) {
        has_collided = true;
        continue;
      }
      const Vec2 position = position_of(box);
      if (is_far(box) || (position - to_).norm() < near) return has_collided ? End::kOpen : End::kOpenAtOnce;
      if (clock.is_over()) return End::kGivenUp;  // moves take much longer than boxes that are not free
      reach_ = std::max(reach_, (position - from_.position()).norm() + near);
      for (const Move& move : moves_from(box.heading)) {
        const std::int32_t x = box.x + move.x, y = box.y + move.y, first = box.heading + move.first_turn;
        const std::int32_t count = move.last_turn - move.first_turn + 1;
        const auto add = [&](std::int32_t heading) { open.push_back({x, y, heading}); };
        if (!is_far({x, y, 0})) {
          seen.see(x, y, first, count, add);
        } else {
          for (std::int32_t heading = first; heading < first + count; ++heading) add(heading & (headings_ - 1));
        }
      }
    }
    return End::kClosed;
  }

  [[nodiscard]] double reach() const { return reach_; }

 private:
  [[nodiscard]] bool is_far(const PoseBox& box) const { return std::max(std::abs(box.x), std::abs(box.y)) > furthest_; }
  [[nodiscard]] bool is_free(const PoseBox& box) {
    auto& body = bodies_[static_cast<std::size_t>(box.heading)];
    if (!body) body = swept_rectangle({0.0, 0.0, heading_of(box.heading)}, 0.0, core_);
    SweptRectangle placed = *body;
    for (Vec2& corner : placed) corner += position_of(box);
    return sweep_.straight_free(placed);
  }
  [[nodiscard]] double heading_of(std::int32_t heading) const { return from_.heading + kTwoPi * heading / headings_; }
  [[nodiscard]] Vec2 position_of(const PoseBox& box) const { return from_.position() + edge_ * Vec2(box.x, box.y); }
  // Where steps may end that turn by a number of headings, up to half a heading more or less.
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

  // The boxes in which a step may end that turns by a number of headings.
  struct Places {
    std::int32_t first_x, last_x, first_y, last_y, turned;
  };
  // The turns of a step to some position; none if first > last.
  struct Turns {
    std::int32_t first, last;
  };

  // The moves to all boxes in which a step from a box with this heading may end.
  const std::vector<Move>& moves_from(std::int32_t heading) {
    std::vector<Move>& moves = moves_[static_cast<std::size_t>(heading)];
    if (!moves.empty()) return moves;
    places_.clear();
    // Headings in the box are off by half a part.
    const double sine = std::sin(kPi / headings_), lost = 1.0 - std::cos(kPi / headings_);
    const Vec2 ahead = direction_of(heading_of(heading));
    for (const auto& [turned, x, y] : turned_steps_) {
      const double aside = std::max(-y.low, y.high);
      const double more_ahead = aside * sine + x.high * lost + kStepRounding * step_;
      const double more_aside = x.high * sine + aside * lost + kStepRounding * step_;
      const Vec2 middle = 0.5 * (x.low + x.high) * ahead + 0.5 * (y.low + y.high) * perpendicular(ahead);
      const double half_x = 0.5 * (x.high - x.low) + more_ahead, half_y = 0.5 * (y.high - y.low) + more_aside;
      const Vec2 half = half_x * ahead.cwiseAbs() + half_y * perpendicular(ahead).cwiseAbs() + Vec2(edge_, edge_);
      const auto first = [&](double d) { return static_cast<std::int32_t>(std::ceil(d / edge_)); };
      const auto last = [&](double d) { return static_cast<std::int32_t>(std::floor(d / edge_)); };
      places_.push_back({first(middle.x() - half.x()), last(middle.x() + half.x()), first(middle.y() - half.y()),
                         last(middle.y() + half.y()), turned});
    }
    // Headings that lead to one position are consecutive; those in between are included.
    std::int32_t low_x = 0, high_x = 0, low_y = 0, high_y = 0;
    for (const Places& p : places_) {
      low_x = std::min(low_x, p.first_x), high_x = std::max(high_x, p.last_x);
      low_y = std::min(low_y, p.first_y), high_y = std::max(high_y, p.last_y);
    }
    const std::int32_t columns = high_x - low_x + 1, rows = high_y - low_y + 1;
    turns_.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), {1, 0});
    for (const Places& p : places_)
      for (std::int32_t j = p.first_y; j <= p.last_y; ++j)
        for (std::int32_t i = p.first_x; i <= p.last_x; ++i) {
          Turns& t = turns_[static_cast<std::size_t>((j - low_y) * columns + i - low_x)];
          if (t.first > t.last) t.first = p.turned;
          t.last = p.turned;
        }
    for (std::int32_t j = low_y; j <= high_y; ++j)
      for (std::int32_t i = low_x; i <= high_x; ++i)
        if (const Turns& t = turns_[static_cast<std::size_t>((j - low_y) * columns + i - low_x)]; t.first <= t.last)
          moves.push_back({i, j, t.first, t.last});
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
  std::vector<Places> places_;  // memory of one call
  std::vector<Turns> turns_;    // memory of one call
  double reach_ = 0.0;
};

// What the body may cover in the boxes about a position, of either size.
Box place_around(const Vec2& position, const Footprint& footprint) {
  const double boxes = kFurthest * kCoarsest * footprint.width();
  const double reach = boxes + std::max(footprint.front, footprint.rear) + std::max(footprint.left, footprint.right);
  return Box{position, position}.grown(reach);
}

}  // namespace

std::optional<DeadEnd> find_dead_end(const Pose& start, const Pose& goal, const ForwardBody& body,
                                     const DeadEndEffort& effort, const StopClock& clock) {
  // Backwards from the goal, the body is turned by pi.
  const Footprint& footprint = body.footprint;
  const Pose turned{goal.x, goal.y, goal.heading + kPi};
  const Footprint swapped = footprint.reversed();
  LocalSweep near_start(body.sweep, body.outlines, place_around(start.position(), footprint));
  LocalSweep near_goal(body.sweep, body.outlines, place_around(goal.position(), footprint));
  PagedArray<std::uint32_t> memory;
  // Whether smaller boxes cannot help: there would be even more than too many, or all are free.
  std::array<bool, 2> is_settled{};
  for (int level = 0; level <= effort.halvings; ++level)
    for (const bool at_start : {true, false}) {
      if (is_settled[at_start]) continue;
      const ForwardFlood::Body forwards{footprint, body.radius, near_start}, backwards{swapped, body.radius, near_goal};
      ForwardFlood flood(at_start ? start : turned, at_start ? goal.position() : start.position(),
                         at_start ? forwards : backwards, level);
      const ForwardFlood::End end = flood.run(effort.max_checks << level, memory, clock);
      if (end == ForwardFlood::End::kClosed) return DeadEnd{at_start, flood.reach()};
      is_settled[at_start] = end == ForwardFlood::End::kGivenUp || end == ForwardFlood::End::kOpenAtOnce;
    }
  return std::nullopt;
}

}  // namespace arcway::internal
