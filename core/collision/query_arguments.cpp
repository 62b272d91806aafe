#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "arcway/distance_query.h"
#include "arcway/sweep_query.h"
#include "arcway/visibility_query.h"
#include "core/base/shortest_text.h"
#include "core/geometry/predicates.h"

// The public halves of the query interfaces: arguments are checked here, once for all implementations.
namespace arcway {

using namespace internal;

namespace {

void require_equal_sizes(std::size_t questions, std::size_t answers) {
  if (questions != answers)
    throw std::invalid_argument("query: " + std::to_string(questions) + " questions but room for " +
                                std::to_string(answers) + " answers");
}

void require_coordinate(double value, std::size_t index) {
  if (is_in_range(value)) return;
  throw std::invalid_argument("query " + std::to_string(index) + ": coordinate " + shortest_text(value) +
                              " is not zero and not of magnitude 1e-100 to 1e100");
}

void require_point(const Vec2& p, std::size_t index) {
  require_coordinate(p.x(), index);
  require_coordinate(p.y(), index);
}

void require_body(const Footprint& body, std::size_t index) {
  const auto require = [&](bool is_right, const char* what, double value, const char* limit) {
    if (!is_right)
      throw std::invalid_argument("query " + std::to_string(index) + ": the body's " + what + " is " +
                                  shortest_text(value) + ", must be " + limit);
  };
  require(std::isfinite(body.front), "front", body.front, "finite");
  require(std::isfinite(body.rear), "rear", body.rear, "finite");
  require(std::isfinite(body.left), "left", body.left, "finite");
  require(std::isfinite(body.right), "right", body.right, "finite");
  require(body.length() > 0.0, "length, front + rear,", body.length(), "positive");
  require(body.width() > 0.0, "width, left + right,", body.width(), "positive");
}

void require_points(std::span<const Vec2> points) {
  for (std::size_t i = 0; i < points.size(); ++i) require_point(points[i], i);
}

}  // namespace

void VisibilityQuery::visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const {
  require_equal_sizes(segments.size(), visible.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    require_point(segments[i].a, i);
    require_point(segments[i].b, i);
  }
  do_visible(segments, visible);
}

bool VisibilityQuery::visible(const LineSegment& segment) const {
  std::uint8_t answer = 0;
  visible({&segment, 1}, {&answer, 1});
  return answer != 0;
}

void DistanceQuery::closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const {
  require_equal_sizes(points.size(), result.size());
  require_points(points);
  do_closest(points, result);
}

ClosestPoint DistanceQuery::closest(const Vec2& point) const {
  ClosestPoint answer;
  closest({&point, 1}, {&answer, 1});
  return answer;
}

void DistanceQuery::closer_than(std::span<const Vec2> points, std::span<const double> distances,
                                std::span<std::uint8_t> closer) const {
  require_equal_sizes(points.size(), closer.size());
  require_equal_sizes(points.size(), distances.size());
  require_points(points);
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (std::isnan(distances[i])) throw std::invalid_argument("query " + std::to_string(i) + ": distance is nan");
  do_closer_than(points, distances, closer);
}

void DistanceQuery::containing(std::span<const Vec2> points, std::span<ObstacleId> result) const {
  require_equal_sizes(points.size(), result.size());
  require_points(points);
  do_containing(points, result);
}

ObstacleId DistanceQuery::containing(const Vec2& point) const {
  ObstacleId answer = kNone;
  containing({&point, 1}, {&answer, 1});
  return answer;
}

void SweepQuery::straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const {
  require_equal_sizes(rectangles.size(), free.size());
  for (std::size_t i = 0; i < rectangles.size(); ++i)
    for (const Vec2& corner : rectangles[i]) require_point(corner, i);
  do_straight_free(rectangles, free);
}

bool SweepQuery::straight_free(const SweptRectangle& rectangle) const {
  std::uint8_t answer = 0;
  straight_free({&rectangle, 1}, {&answer, 1});
  return answer != 0;
}

void SweepQuery::straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  require_equal_sizes(bodies.size(), free.size());
  do_straights_free(bodies, free);
}

void SweepQuery::do_straights_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  if (bodies.size() == 1 && bodies[0].body.shape == nullptr) {  // without memory of its own
    const SweptRectangle rectangle = swept_rectangle(bodies[0].from, bodies[0].length, bodies[0].body);
    return straight_free({&rectangle, 1}, free);
  }
  const auto has_shape = [](const StraightBody& b) { return b.body.shape != nullptr; };
  if (std::ranges::none_of(bodies, has_shape)) {
    std::vector<SweptRectangle> rectangles;
    rectangles.reserve(bodies.size());
    for (const StraightBody& b : bodies) rectangles.push_back(swept_rectangle(b.from, b.length, b.body));
    straight_free(rectangles, free);
  } else if (std::ranges::all_of(bodies, has_shape)) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (const Vec2& corner : swept_rectangle(bodies[i].from, bodies[i].length, bodies[i].body))
        require_point(corner, i);
    do_straight_free(bodies, free);
  } else {
    for (std::size_t i = 0; i < bodies.size(); ++i) free[i] = straight_free(bodies[i]) ? 1 : 0;
  }
}

bool SweepQuery::straight_free(const StraightBody& body) const {
  std::uint8_t answer = 0;
  do_straights_free({&body, 1}, {&answer, 1});
  return answer != 0;
}

void SweepQuery::free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const {
  require_equal_sizes(bodies.size(), result.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    require_point(bodies[i].center, i);
    if (!(bodies[i].radius > 0.0) || !std::isfinite(bodies[i].radius))
      throw std::invalid_argument("query " + std::to_string(i) + ": turning radius is " +
                                  shortest_text(bodies[i].radius) + ", must be positive and finite");
    require_body(bodies[i].body, i);
  }
  do_free_headings(bodies, result);
}

HeadingSet SweepQuery::free_headings(const TurningBody& body) const {
  HeadingSet answer;
  free_headings({&body, 1}, {&answer, 1});
  return answer;
}

SweptRectangle swept_rectangle(const Pose& from, double length, const Footprint& body) {
  const Vec2 along = direction_of(from.heading), aside = perpendicular(along);
  const Vec2 left = aside * body.left, right = aside * body.right;
  const Vec2 tail = from.position() - along * body.rear;
  const Vec2 nose = from.position() + along * (length + body.front);
  return {Vec2(tail - right), Vec2(nose - right), Vec2(nose + left), Vec2(tail + left)};
}

Vec2 middle_of(const Footprint& body, const Pose& pose) {
  const Vec2 ahead = direction_of(pose.heading);
  return pose.position() + 0.5 * (body.front - body.rear) * ahead +
         0.5 * (body.left - body.right) * perpendicular(ahead);
}

Vec2 inner_point_of(const Body& body, const Pose& pose) {
  if (body.shape == nullptr) return middle_of(body, pose);
  const Vec2 ahead = direction_of(pose.heading);
  const Vec2& p = body.shape->inner_points.front();
  return pose.position() + p.x() * ahead + p.y() * perpendicular(ahead);
}

bool SweepQuery::arc_free(const TurningBody& body, double heading, double angle, HeadingSet& headings) const {
  return do_arc_free(body, heading, angle, headings);
}

bool SweepQuery::do_arc_free(const TurningBody& body, double heading, double angle, HeadingSet& headings) const {
  free_headings({&body, 1}, {&headings, 1});
  return headings.reach(heading, body.side) >= angle;
}

double SweepQuery::reach(const TurningBody& body, double heading, Side towards, HeadingSet& headings) const {
  return do_reach(body, heading, towards, headings);
}

double SweepQuery::do_reach(const TurningBody& body, double heading, Side towards, HeadingSet& headings) const {
  free_headings({&body, 1}, {&headings, 1});
  return headings.reach(heading, towards);
}

}  // namespace arcway
