#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/vec2.h"
#include "arcway/vehicle.h"

namespace arcway {

/// What a rectangle sweeps when it drives straight: a rectangle again, its corners counter-clockwise [m].
using SweptRectangle = std::array<Vec2, 4>;

/// The swept rectangle from the tail of the body at `from` to its nose `length` [m] further on. Its corners are rounded
/// here and nowhere else: all implementations decide on these corners.
ARCWAY_API SweptRectangle swept_rectangle(const Pose& from, double length, const Footprint& body);

/// The center of a rectangle at a pose [m].
ARCWAY_API Vec2 middle_of(const Footprint& body, const Pose& pose);

/// A point inside of the body at a pose [m]: the center of a rectangle.
ARCWAY_API Vec2 inner_point_of(const Body& body, const Pose& pose);

/// A body that drives on a line, described as if it drove forwards.
struct StraightBody {
  Pose from;      ///< of the reference point
  double length;  ///< [m], >= 0; 0: the body stands
  Body body;
  Gear gear = Gear::kForward;  ///< kReverse: driven backwards to `from`, over the same poses. Obstacles do not mind.
};

/// A body that drives on a circle, described as if it drove forwards.
struct TurningBody {
  Vec2 center;    ///< of the circle [m]
  double radius;  ///< of the reference point's circle [m], > 0
  Side side;      ///< kLeft: counter-clockwise
  Body body;
  Gear gear = Gear::kForward;  ///< kReverse: driven backwards, over the same poses. Obstacles do not mind.
};

/// Whether swept regions are free of obstacles. Obstacles are closed sets here: contact is a collision. A region that
/// lies wholly inside an obstacle, or outside the bounds, is not free. Straight motions are decided exactly, on
/// rounded corners. The ends of heading sets are rounded to a few units in the last place of the angle, or of its
/// square root at grazing contact. They have the same bits in every implementation. A planner's safety margin covers
/// this rounding many times over, see vehicle.h. Thread-safe.
class ARCWAY_API SweepQuery {
 public:
  virtual ~SweepQuery() = default;

  /// free[i] = 1 if no point of rectangles[i] belongs to an obstacle, else 0. Does not allocate.
  /// @throws std::invalid_argument if the sizes differ or a coordinate is not in the exact range of vec2.h, naming its
  ///   index.
  void straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const;
  [[nodiscard]] bool straight_free(const SweptRectangle& rectangle) const;
  /// free[i] = 1 if bodies[i] touches no obstacle on its way, else 0. A rectangle has the answer of its swept
  /// rectangle.
  /// @throws std::invalid_argument as above, for the corners of what bounds the swept region.
  void straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const;
  [[nodiscard]] bool straight_free(const StraightBody& body) const;

  /// The headings at which the body, at that point of its circle, touches no obstacle.
  /// @throws std::invalid_argument if the sizes differ or a center is not in the exact range of vec2.h, naming its
  ///   index. Also if a radius, a length front + rear or a width left + right is not positive, or a number not finite.
  ///   Single reaches may be negative.
  void free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const;
  [[nodiscard]] HeadingSet free_headings(const TurningBody& body) const;

  /// Whether the body touches no obstacle while it turns from a heading by an angle, in its driving direction. The
  /// answer has the bits of `free_headings`, but may cost less than all free headings do.
  /// @param body  as for `free_headings`. Not every implementation checks it.
  /// @param angle  from 0 to 2 pi [rad].
  /// @param headings  memory that is used again; its content is unspecified afterwards.
  [[nodiscard]] bool arc_free(const TurningBody& body, double heading, double angle, HeadingSet& headings) const;
  /// How far the body turns from a heading, to the left or to the right, until it touches an obstacle:
  /// HeadingSet::reach of its free headings [rad]. Arguments are those of `arc_free`.
  [[nodiscard]] double reach(const TurningBody& body, double heading, Side towards, HeadingSet& headings) const;

 private:
  // Unless an implementation asks for more than free regions: by rectangles where bodies have no shape.
  virtual void do_straights_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const;
  virtual void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const = 0;
  // Bodies that have a shape.
  virtual void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const = 0;
  virtual void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const = 0;
  // Unless an implementation knows better: by all free headings.
  [[nodiscard]] virtual bool do_arc_free(const TurningBody& body, double heading, double angle,
                                         HeadingSet& headings) const;
  [[nodiscard]] virtual double do_reach(const TurningBody& body, double heading, Side towards,
                                        HeadingSet& headings) const;
};

}  // namespace arcway
