#include "core/roadmap/turn_circle.h"

#include <algorithm>
#include <cmath>

#include "arcway/angle.h"

namespace arcway::internal {

Pose pose_on(const TurnCircle& circle, double heading) {
  const Vec2 p = circle.center - sign_of(circle.side) * circle.radius * perpendicular(direction_of(heading));
  return {p.x(), p.y(), heading};
}

PathSegment arc_on(const TurnCircle& circle, double from_heading, double turn) {
  return {pose_on(circle, from_heading), turn * circle.radius, sign_of(circle.side) / circle.radius};
}

double turn_between(double from, double to, Side side) {
  const double turn = wrap_positive(side == Side::kLeft ? to - from : from - to);
  return turn > kTwoPi - kNoTurn ? 0.0 : turn;
}

std::optional<BitangentLine> line_of_bitangent(const TurnCircle& from, const TurnCircle& to) {
  const Vec2 d = to.center - from.center;
  const double offset = sign_of(to.side) * to.radius - sign_of(from.side) * from.radius;
  const double square = (d.norm() - std::abs(offset)) * (d.norm() + std::abs(offset));
  if (!(square > 0.0)) return std::nullopt;
  const double length = std::sqrt(square);
  // In the frame of the line's direction t and left normal n: d = length t + offset n.
  return BitangentLine{length * d - offset * perpendicular(d), length};
}

std::optional<Bitangent> directed_bitangent(const TurnCircle& from, const TurnCircle& to) {
  const auto line = line_of_bitangent(from, to);
  if (!line) return std::nullopt;
  return Bitangent{pose_on(from, line->heading()), line->length};
}

namespace {

// Unit vector from a convex vertex into the obstacle.
Vec2 inwards(const World& world, VertexId vertex) {
  const Vec2& v = world.vertex(vertex);
  const Vec2 back = (world.vertex(world.previous(vertex)) - v).normalized();
  const Vec2 ahead = (world.vertex(world.next(vertex)) - v).normalized();
  // At a nearly straight vertex the sum is tiny; the inward normal of the chord is as good there.
  const Vec2 sum = back + ahead;
  return sum.squaredNorm() > 1e-3 ? sum.normalized() : Vec2(perpendicular(ahead - back).normalized());
}

}  // namespace

double inner_side_radius(const Footprint& body, Side side, double radius) {
  return std::max(0.0, radius - body.beside(side));
}

TurnCircle turn_circle(const World& world, VertexId vertex, double radius, Side side, const Footprint& grown_body) {
  const double inner = inner_side_radius(grown_body, side, radius);
  return {world.vertex(vertex) + inner * inwards(world, vertex), radius, side, vertex};
}

std::optional<TurnCircle> turn_circle(const World& world, const VertexPair& pair, double radius, Side side,
                                      const Footprint& grown_body) {
  const auto [u, w, obstacles] = pair;
  const double inner = inner_side_radius(grown_body, side, radius);
  const Vec2 half = 0.5 * (world.vertex(w) - world.vertex(u));
  const double square = inner * inner - half.squaredNorm();
  if (!(square > 0.0)) return std::nullopt;
  const Vec2 inwards = sign_of(obstacles) * perpendicular(half.normalized());
  return TurnCircle{world.vertex(u) + half + std::sqrt(square) * inwards, radius, side, u, w};
}

double heading_at_vertex(const World& world, const TurnCircle& circle) {
  const Vec2 to_center = circle.second == kNone
                             ? inwards(world, circle.vertex)
                             : Vec2(circle.center - 0.5 * (world.vertex(circle.vertex) + world.vertex(circle.second)));
  // pose_on puts the reference point on the side of the center away from the left normal if turning left.
  const Vec2 normal = sign_of(circle.side) * to_center;
  return std::atan2(-normal.x(), normal.y());
}

TurnCircle turn_circle(const Pose& pose, double radius, Side side) {
  return {pose.position() + sign_of(side) * radius * perpendicular(direction_of(pose.heading)), radius, side, kNone};
}

}  // namespace arcway::internal
