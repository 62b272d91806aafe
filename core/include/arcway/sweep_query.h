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

/// What a rectangle sweeps when it drives straight: a rectangle again, corners counter-clockwise.
using SweptRectangle = std::array<Vec2, 4>;

/// Swept rectangle from the tail of the body at `from` to its nose `length` further on. The one
/// place where corners are rounded: all implementations decide on these corners.
ARCWAY_API SweptRectangle swept_rectangle(const Pose& from, double length, const Footprint& body);

/// The middle of the body.
ARCWAY_API Vec2 middle_of(const Footprint& body, const Pose& pose);

/// A body that turns about a fixed center at a fixed radius, driving forwards.
struct TurningBody {
  Vec2 center;
  double radius;  ///< of the reference point's circle, > 0
  Side side;      ///< kLeft: counter-clockwise
  Footprint body;
};

/// Is the swept region free? Obstacles are closed sets here (contact is a collision); a region
/// swallowed whole by an obstacle, or wholly outside the bounds, is not free.
/// Rectangles are decided exactly on their rounded corners. Heading sets have ends rounded to a few
/// units in the last place of the angle (grazing contact: of the square root of it), the same bits for every
/// implementation. Planner's safety margin absorbs this rounding many times over, see vehicle.h. Thread-safe.
class ARCWAY_API SweepQuery {
 public:
  virtual ~SweepQuery() = default;

  /// free[i] = 1 if no point of rectangles[i] belongs to an obstacle. Does not allocate.
  /// @throws std::invalid_argument if the sizes differ or a coordinate is not in the range of predicates.h, naming its
  ///   index.
  void straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const;
  [[nodiscard]] bool straight_free(const SweptRectangle& rectangle) const;

  /// All headings at which the body, at that point of its circle, touches no obstacle.
  /// @throws std::invalid_argument likewise, of centers; or if a radius, the half width or the length front + rear is
  ///   not positive and finite. One of front and rear may be negative.
  void free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const;
  [[nodiscard]] HeadingSet free_headings(const TurningBody& body) const;

 private:
  virtual void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const = 0;
  virtual void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const = 0;
};

}  // namespace arcway
