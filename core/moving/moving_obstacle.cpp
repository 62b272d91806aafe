#include "arcway/moving_obstacle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/shortest_text.h"
#include "core/moving/blocked_places.h"
#include "core/moving/start_times.h"

namespace arcway {

using namespace internal;
namespace internal {
namespace {

[[noreturn]] void refuse(std::size_t obstacle, const std::string& what) {
  throw std::invalid_argument("moving obstacle " + std::to_string(obstacle) + ": " + what);
}

void check_outline(const Ring& outline, std::size_t index) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (!outline[i].allFinite()) refuse(index, "vertex " + std::to_string(i) + " is not finite");
  if (outline.size() < 3) refuse(index, "it has " + std::to_string(outline.size()) + " vertices, must have >= 3");
  std::vector<RingContact> contacts;
  const auto conflict = find_conflict({outline, {}}, &contacts);
  if (conflict || !contacts.empty() || winding(outline) == 0)
    refuse(index, "its outline crosses or touches itself, or has no area; give a simple polygon");
}

}  // namespace

void check_moving(std::span<const MovingObstacle> obstacles) {
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const MovingObstacle& o = obstacles[i];
    check_outline(o.outline, i);
    if (!o.velocity.allFinite()) refuse(i, "a velocity is not finite");
    if (!std::isfinite(o.from)) refuse(i, "from is " + shortest_text(o.from) + " s, must be finite");
    if (!(o.until > o.from))
      refuse(i, "until is " + shortest_text(o.until) + " s, must be > from, " + shortest_text(o.from));
  }
}

void check_horizon(double horizon) {
  if (!(horizon > 0.0 && std::isfinite(horizon)))
    throw std::invalid_argument("moving obstacles: horizon is " + shortest_text(horizon) +
                                " s, must be finite and > 0");
}

}  // namespace internal

std::vector<TimeInterval> blocked_times(const PathSegment& segment, const Vehicle& vehicle,
                                        const MovingObstacle& obstacle, double horizon) {
  check_moving({&obstacle, 1});
  check_horizon(horizon);
  std::vector<TimeInterval> times;
  for (const BlockedPlaces& places : blocked_places({&segment, 1}, vehicle, {&obstacle, 1}, horizon)) {
    TimeInterval interval{INFINITY, -INFINITY};
    for (const Vec2& corner : places.corners) {
      interval.begin = std::min(interval.begin, corner.y());
      interval.end = std::max(interval.end, corner.y());
    }
    times.push_back(interval);
  }
  const TimeSet united(std::move(times));
  return {united.intervals().begin(), united.intervals().end()};
}

}  // namespace arcway
