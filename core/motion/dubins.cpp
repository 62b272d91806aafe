#include "core/motion/dubins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "arcway/angle.h"
#include "core/base/infinity.h"

namespace arcway::internal {
namespace {

constexpr double kDubinsUlps = 16.0 * std::numeric_limits<double>::epsilon();

/// Turn in [0, 2 pi); one that misses a full turn by rounding is none.
double turn_of(double angle, double tolerance) {
  const double turn = wrap_positive(angle);
  return turn >= kTwoPi - tolerance ? 0.0 : turn;
}

struct WordParts {
  double first;   ///< angle of the first arc
  double middle;  ///< length of the line, angle of the middle arc
  double last;    ///< angle of the last arc
};

/// Start and last circles of a word, relative to the start.
struct Circles {
  double s0, s1;  ///< their sides
  double r0, r1;  ///< their radii [m]
  Vec2 between;   ///< from the first center to the last
  double distance;
  double direction;
  double place_error;    ///< rounding of a position
  double heading_error;  ///< rounding of a heading
  double h0, h1;
};

Circles circles_of(const Pose& start, const Pose& goal, const SideRadii& radii, double s0, double s1) {
  const double r0 = radii.on(s0), r1 = radii.on(s1), radius = std::max(r0, r1);
  const Vec2 left0 = perpendicular(direction_of(start.heading)), left1 = perpendicular(direction_of(goal.heading));
  const Vec2 of_centers = r0 == r1 ? Vec2(r0 * (s1 * left1 - s0 * left0)) : Vec2(s1 * r1 * left1 - s0 * r0 * left0);
  const Vec2 between = goal.position() - start.position() + of_centers;
  // A heading of many turns is rounded coarsely: its direction and the center of its circle are uncertain.
  const double turned = std::abs(start.heading) + std::abs(goal.heading);
  const double scale = std::max({start.position().cwiseAbs().maxCoeff(), goal.position().cwiseAbs().maxCoeff(), radius,
                                 radius * turned / kTwoPi});
  return {.s0 = s0,
          .s1 = s1,
          .r0 = r0,
          .r1 = r1,
          .between = between,
          .distance = between.norm(),
          .direction = std::atan2(between.y(), between.x()),
          .place_error = kDubinsUlps * scale,
          .heading_error = kDubinsUlps * (1.0 + turned),
          .h0 = start.heading,
          .h1 = goal.heading};
}

/// LSL, RSR: the line is parallel to the centers' one.
WordParts same_side(const Circles& c) {
  const double whole = turn_of(c.s0 * (c.h1 - c.h0), c.heading_error);
  if (c.distance <= c.place_error) return {whole, 0.0, 0.0};  // one circle: its direction is noise
  // Where an arc vanishes up to rounding, its neighbor's heading is taken for the line's.
  const double noise = c.heading_error + c.place_error / c.distance;
  const double first = turn_of(c.s0 * (c.direction - c.h0), noise);
  if (first == 0.0) return {0.0, c.distance, whole};
  const double last = turn_of(c.s0 * (c.h1 - c.direction), noise);
  if (last == 0.0) return {whole, c.distance, 0.0};
  return {first, c.distance, last};
}

/// LSR, RSL: the line crosses the centers' one.
std::optional<WordParts> opposite_sides(const Circles& c) {
  const double radii = c.r0 + c.r1, excess = c.distance - radii;
  if (excess < -c.place_error) return std::nullopt;
  const double line = excess <= c.place_error ? 0.0 : std::sqrt(excess) * std::sqrt(c.distance + radii);
  const double heading = c.direction + c.s0 * std::atan2(radii, line);
  const double noise = c.heading_error + c.place_error / c.distance;
  return WordParts{turn_of(c.s0 * (heading - c.h0), noise), line, turn_of(c.s1 * (c.h1 - heading), noise)};
}

/// LRL, RLR: the middle circle on the side that gives its arc at least half a turn (the other is never shortest).
/// Its center and those of the others are the corners of an isosceles triangle.
std::optional<WordParts> three_arcs(const Circles& c, double middle_radius) {
  const double legs = 2.0 * (c.r0 + middle_radius);
  if (c.distance > legs + c.place_error) return std::nullopt;
  const double half_angle = std::asin(std::min(1.0, c.distance / legs));
  const bool one_circle = c.distance <= c.place_error;  // any middle circle will do: the one without a first arc
  const double heading = one_circle ? c.h0 : c.direction + c.s0 * (kPi - half_angle);
  const double noise = c.heading_error + c.place_error / std::max(c.distance, c.r0);
  const double middle = kTwoPi - 2.0 * half_angle;
  return WordParts{turn_of(c.s0 * (heading - c.h0), noise), middle,
                   turn_of(c.s0 * (c.h1 - heading) - 2.0 * half_angle, noise)};
}

/// The motions of a word, some of which may have no length.
struct WordMotions {
  std::array<double, 3> lengths;  // [m]
  std::array<double, 3> curvatures;
};

std::optional<WordMotions> motions_of(DubinsWord word, const Pose& start, const Pose& goal, const SideRadii& radii) {
  for (const double radius : {radii.left, radii.right})
    if (!(radius > 0.0) || !std::isfinite(radius))
      throw std::invalid_argument("dubins_path: radius must be finite and > 0");
  const bool starts_left = word == DubinsWord::kLSL || word == DubinsWord::kLSR || word == DubinsWord::kLRL;
  const bool ends_left = word == DubinsWord::kLSL || word == DubinsWord::kRSL || word == DubinsWord::kLRL;
  const bool turns_thrice = word == DubinsWord::kLRL || word == DubinsWord::kRLR;
  const Circles circles = circles_of(start, goal, radii, starts_left ? 1.0 : -1.0, ends_left ? 1.0 : -1.0);

  const double middle_radius = radii.on(-circles.s0);
  std::optional<WordParts> parts;
  if (turns_thrice) {
    parts = three_arcs(circles, middle_radius);
  } else if (starts_left == ends_left) {
    parts = same_side(circles);
  } else {
    parts = opposite_sides(circles);
  }
  if (!parts) return std::nullopt;
  return WordMotions{
      {parts->first * circles.r0, turns_thrice ? parts->middle * middle_radius : parts->middle,
       parts->last * circles.r1},
      {circles.s0 / circles.r0, turns_thrice ? -circles.s0 / middle_radius : 0.0, circles.s1 / circles.r1}};
}

}  // namespace

std::optional<DubinsPath> dubins_word(DubinsWord word, const Pose& start, const Pose& goal, const SideRadii& radii) {
  const auto motions = motions_of(word, start, goal, radii);
  if (!motions) return std::nullopt;
  DubinsPath path;
  for (std::size_t i = 0; i < motions->lengths.size(); ++i) {
    if (!(motions->lengths[i] > 0.0)) continue;
    path.parts[path.count] = {path.count == 0 ? start : path.parts[path.count - 1].end(), motions->lengths[i],
                              motions->curvatures[i]};
    ++path.count;
  }
  return path;
}

double dubins_length(DubinsWord word, const Pose& start, const Pose& goal, const SideRadii& radii) {
  const auto motions = motions_of(word, start, goal, radii);
  if (!motions) return kInfinity;
  double length = 0.0;
  for (const double part : motions->lengths) length += std::max(0.0, part);
  return length;
}

std::optional<Path> dubins_path(DubinsWord word, const Pose& start, const Pose& goal, const SideRadii& radii) {
  const auto path = dubins_word(word, start, goal, radii);
  if (!path) return std::nullopt;
  return Path(path->segments().begin(), path->segments().end());
}

}  // namespace arcway::internal
