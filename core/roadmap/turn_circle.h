#pragma once

#include <cmath>
#include <optional>

#include "arcway/angle.h"
#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway::internal {

/// A turn circle: a directed circle of the reference point around a convex vertex. See TurnCircles.
struct TurnCircle {
  Vec2 center;
  double radius;
  Side side;                ///< kLeft: counter-clockwise
  VertexId vertex;          ///< kNone for the circles of a pose
  VertexId second = kNone;  ///< the other vertex of a circle around two
};

/// The pose on a circle where the body has the given heading [rad].
Pose pose_on(const TurnCircle& circle, double heading);

/// The arc on a circle from a heading on [rad].
/// @param turn  [rad], not negative.
PathSegment arc_on(const TurnCircle& circle, double from_heading, double turn);

/// The headings at the ends of one bitangent may differ by rounding, by less than this [rad].
inline constexpr double kNoTurn = 1e-9;

/// The turn from one heading towards a side to another [rad], in [0, 2 pi). A turn that falls short of a full circle by
/// rounding alone counts as 0.
double turn_between(double from, double to, Side side);

/// A directed bitangent: the straight motion from one directed circle to the next. Its heading is that of both circles
/// there.
struct Bitangent {
  Pose start;
  double length;
};

/// The directed bitangent of two directed circles: outer if they turn to the same side, inner if not. Constant time.
/// Error of both ends: a few units in the last place of the coordinates.
/// @return nothing if none exists: one circle lies inside the other, or opposite circles overlap.
std::optional<Bitangent> directed_bitangent(const TurnCircle& from, const TurnCircle& to);

/// What directed_bitangent finds, without its pose: some vector along the line, and its length.
struct BitangentLine {
  Vec2 along;
  double length;
  /// The heading of the bitangent [rad], in [0, 2 pi).
  [[nodiscard]] double heading() const { return wrap_positive(std::atan2(along.y(), along.x())); }
};
std::optional<BitangentLine> line_of_bitangent(const TurnCircle& from, const TurnCircle& to);

/// Radius of the circle about the rotation center of a turn to a side that the body's inner side touches [m], both in
/// the turn and on the straights before and after it. 0 if the center does not lie beyond that side. It equals rho_in
/// if F lies on the body. Else the body keeps further off in the turn, but not on the straights.
double inner_side_radius(const Footprint& body, Side side, double radius);

/// The circle around a convex vertex. Its center lies inwards on the bisector of the vertex's edges, by
/// inner_side_radius of the body grown by the margin. The body's side then passes by the vertex.
TurnCircle turn_circle(const World& world, VertexId vertex, double radius, Side side, const Footprint& grown_body);

/// Two convex vertices.
struct VertexPair {
  VertexId first, second;
  Side obstacles;  ///< where the obstacles lie for who goes from the first to the second
};
/// The circle around two convex vertices on which a path turns to a side. Both vertices lie on the circle of
/// inner_side_radius. Nothing if they are further apart than its diameter.
std::optional<TurnCircle> turn_circle(const World& world, const VertexPair& pair, double radius, Side side,
                                      const Footprint& grown_body);

/// The heading on a vertex's circle at which the reference point is nearest to the vertex [rad].
double heading_at_vertex(const World& world, const TurnCircle& circle);

/// The circle through a pose, tangent to its heading.
TurnCircle turn_circle(const Pose& pose, double radius, Side side);

}  // namespace arcway::internal
