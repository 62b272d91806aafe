#pragma once

#include <optional>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway::internal {

/// A directed circle that the reference point follows round a convex vertex; see TurnCircles.
struct TurnCircle {
  Vec2 center;
  double radius;
  Side side;                ///< kLeft: counter-clockwise
  VertexId vertex;          ///< kNone for the circles of a pose
  VertexId second = kNone;  ///< of a circle round two vertices at once: the other one
};

/// Pose of the reference point on a circle where the body has the given heading.
Pose pose_on(const TurnCircle& circle, double heading);

/// Arrival and departure headings of one straight line may differ by rounding, less than this [rad].
inline constexpr double kNoTurn = 1e-9;

/// How far to turn towards a side from one heading to another [rad], in [0, 2 pi); a turn that falls short of a full
/// circle by rounding alone is none.
double turn_between(double from, double to, Side side);

/// The straight motion from one directed circle to the next; its heading is that of both circles at its ends.
struct Bitangent {
  Pose start;
  double length;
};

/// The directed bitangent of two directed circles: outer if they turn to the same side, inner if not.
/// @returns nothing if none exists: one circle inside the other, or opposite circles that overlap. Constant time.
/// Error of both ends: a few units in the last place of the coordinates.
std::optional<Bitangent> directed_bitangent(const TurnCircle& from, const TurnCircle& to);

/// Radius of the circle about the rotation center that the body's inner side touches in a turn, as it does on the
/// straights before and behind it; 0 if the center lies between the sides. It is rho_in where F lies on the body;
/// elsewhere the turn keeps further off, but the straights do not.
double inner_side_radius(const Footprint& body, double radius);

/// The circle round a convex vertex: its center lies inner_side_radius (of the body grown by the margin) inwards along
/// the bisector of the vertex's two edges, so that the body's side passes by the vertex.
TurnCircle turn_circle(const World& world, VertexId vertex, double radius, Side side, const Footprint& grown_body);

/// The circle round two convex vertices at once, traveling from u to w with the obstacles on the given side: both lie
/// on the circle of inner_side_radius. nothing if they are further apart than its diameter.
std::optional<TurnCircle> turn_circle(const World& world, VertexId u, VertexId w, double radius, Side side,
                                      const Footprint& grown_body);

/// The heading on a vertex's circle at which the reference point is nearest to the vertex.
double heading_at_vertex(const World& world, const TurnCircle& circle);

/// The circle of a pose: tangent to its heading at its position.
TurnCircle turn_circle(const Pose& pose, double radius, Side side);

}  // namespace arcway::internal
