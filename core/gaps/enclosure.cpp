#include "core/gaps/enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

constexpr int kLevels = 4;
constexpr double kCoarsestEdge = 0.5;  // edge of the largest boxes, in half widths of the body
constexpr int kCoarsestHeadings = 32;
constexpr double kBodyRounding =
    1e-9;  // share of the body's size and of coordinates by which tested bodies are smaller, against rounding

/// A box of positions of the body's middle and of headings.
struct FloodBox {
  std::int32_t x, y, heading;
};

Pose middle_pose(const Footprint& footprint, const Pose& pose) {
  const Vec2 p = middle_of(footprint, pose);
  return {p.x(), p.y(), pose.heading};
}

class Flood {
 public:
  Flood(const Pose& from, const Pose& to, const MovedBody& body, int level)
      : sweep_(body.sweep),
        headings_(kCoarsestHeadings << level),
        from_(middle_pose(body.footprint, from)),
        to_(middle_pose(body.footprint, to)) {
    const Footprint& footprint = body.footprint;
    const double half_length = 0.5 * footprint.length();
    const double half_width = 0.5 * footprint.width();
    edge_ = kCoarsestEdge * half_width / (1 << level);
    const double largest = std::max(from_.position().cwiseAbs().maxCoeff(), to_.position().cwiseAbs().maxCoeff());
    const double turn = std::sin(kPi / headings_);
    const double shift = edge_ * std::sqrt(0.5) + kBodyRounding * (half_length + largest);
    // What the body covers wherever it is in a box: less by what its corners turn and by what its middle shifts.
    const double length = half_length - turn * half_width - shift;
    const double width = half_width - turn * half_length - shift;
    core_ = {length, length, width, width};
  }

  enum class End { kClosed, kOpen, kTooMany };
  End run(std::size_t max_boxes, const StopClock& clock) {
    if (std::min(core_.front, core_.left) <= 0.0) return End::kOpen;
    const FloodBox goal = box_of(to_);
    std::vector<FloodBox> boxes{{0, 0, 0}};
    using Waiting = std::pair<double, std::size_t>;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> open;
    open.push({0.0, 0});
    std::unordered_set<std::uint64_t> seen{key_of(boxes[0])};
    while (!open.empty()) {
      if (clock.is_over()) return End::kTooMany;
      const FloodBox box = boxes[open.top().second];
      open.pop();
      // Most boxes of an open place are never taken out, so that none is tested before.
      if (!is_free(box)) continue;
      reach_ = std::max(reach_, (center_of(box).position() - from_.position()).norm());
      if (box.x == goal.x && box.y == goal.y && box.heading == goal.heading) return End::kOpen;
      for (const FloodBox& next : neighbors(box)) {
        if (!seen.insert(key_of(next)).second) continue;
        if (seen.size() > max_boxes) return End::kTooMany;
        boxes.push_back(next);
        open.push({(center_of(next).position() - to_.position()).squaredNorm(), boxes.size() - 1});
      }
    }
    reach_ += edge_;
    return End::kClosed;
  }

  [[nodiscard]] double reach() const { return reach_; }

 private:
  [[nodiscard]] Pose center_of(const FloodBox& box) const {
    return {from_.x + edge_ * box.x, from_.y + edge_ * box.y, from_.heading + kTwoPi * box.heading / headings_};
  }
  // Not asked about the first box: the end itself is free.
  [[nodiscard]] bool is_free(const FloodBox& box) const {
    const bool is_first = box.x == 0 && box.y == 0 && box.heading == 0;
    return is_first || sweep_.straight_free(swept_rectangle(center_of(box), 0.0, core_));
  }
  [[nodiscard]] FloodBox box_of(const Pose& pose) const {
    const auto index = [this](double d) { return static_cast<std::int32_t>(std::lround(d / edge_)); };
    const double turns = wrap_positive(pose.heading - from_.heading) / kTwoPi;
    return {index(pose.x - from_.x), index(pose.y - from_.y),
            static_cast<std::int32_t>(std::lround(turns * headings_)) % headings_};
  }
  [[nodiscard]] std::array<FloodBox, 6> neighbors(const FloodBox& b) const {
    return {{{b.x + 1, b.y, b.heading},
             {b.x - 1, b.y, b.heading},
             {b.x, b.y + 1, b.heading},
             {b.x, b.y - 1, b.heading},
             {b.x, b.y, (b.heading + 1) % headings_},
             {b.x, b.y, (b.heading + headings_ - 1) % headings_}}};
  }
  static std::uint64_t key_of(const FloodBox& b) {
    return (static_cast<std::uint64_t>(b.x & 0xFFFFFF) << 40) | (static_cast<std::uint64_t>(b.y & 0xFFFFFF) << 16) |
           static_cast<std::uint64_t>(b.heading);
  }

  const SweepQuery& sweep_;
  std::int32_t headings_;
  Pose from_, to_;  // of the middle
  double edge_ = 0.0;
  Footprint core_{};
  double reach_ = 0.0;
};

}  // namespace

std::optional<Enclosure> find_enclosure(const Pose& start, const Pose& goal, const MovedBody& body,
                                        std::size_t max_boxes, const StopClock& clock) {
  std::array<bool, 2> has_room{};  // so much that there are too many boxes, and more of smaller ones
  for (int level = 0; level < kLevels; ++level)
    for (const bool at_start : {true, false}) {
      if (has_room[at_start]) continue;
      Flood flood(at_start ? start : goal, at_start ? goal : start, body, level);
      const Flood::End end = flood.run(max_boxes, clock);
      if (end == Flood::End::kClosed) return Enclosure{at_start, flood.reach()};
      has_room[at_start] = end == Flood::End::kTooMany;
    }
  return std::nullopt;
}

}  // namespace arcway::internal
