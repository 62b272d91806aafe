#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/vehicle.h"

namespace arcway::internal {

/// What a body of polygons sweeps in turns to one side. Immutable.
///
/// The center lies at (0, radius): turns to the right are those to the left of the body in a mirror. Distances from
/// it are given as what they are longer than the radius, so that they lose no digits at large radii.
class SweptOutline {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Edge {
    Vec2 from, to, along, normal;
    double length;
  };
  /// What bounds the annulus: a corner outside, and a corner or a side inside. Corner i is the start of edge i.
  struct Bounds {
    std::size_t outer = kNone, inner_corner = kNone, inner_side = kNone;  ///< no inner: the center lies in the body
    friend bool operator==(const Bounds&, const Bounds&) = default;
  };

  /// @param rings  simple polygons about F, of either orientation, whose union is the body.
  SweptOutline(std::span<const Ring> rings, Side side);

  [[nodiscard]] std::span<const Edge> edges() const { return edges_; }
  /// The width at an infinite radius.
  [[nodiscard]] double straight_width() const { return straight_width_; }
  /// All below: O(corners). Precondition: radius >= 0.
  [[nodiscard]] Bounds bounds(double radius) const;
  [[nodiscard]] SweptAnnulus annulus(double radius) const;
  [[nodiscard]] double width(double radius) const;

 private:
  void add_edges(const Ring& ring);
  [[nodiscard]] bool contains_center(double radius) const;
  [[nodiscard]] double beyond_side(const Edge& side, double radius) const;
  [[nodiscard]] double inner_beyond(const Bounds& bounds, double radius) const;

  std::vector<Edge> edges_;            // of all rings
  std::vector<std::size_t> ring_end_;  // behind the last edge of each ring
  double straight_width_ = 0.0;
};

}  // namespace arcway::internal
