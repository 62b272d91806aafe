#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/turn_circle.h"
#include "core/graph/visibility_rows.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// The turn circles of a world. Each convex vertex has a left and a right one of each radius. Where two neighbors of
/// the reduced graph that are passed on one side lie so near each other that the bitangent of their circles would lead
/// back, as at the end of a thin wall, the two have a left and a right circle of the smallest radius in common, which
/// goes round both. Immutable.
class TurnCircles {
 public:
  /// @param radii       ascending, not empty;  @param grown_body  by the safety margin.
  TurnCircles(const World& world, const VisibilityRows& rows, std::span<const double> radii,
              const Footprint& grown_body);

  /// Those of one vertex first: all of a vertex are neighbors, radii ascending, for each left before right. Then those
  /// of two, left before right.
  [[nodiscard]] std::span<const TurnCircle> all() const { return circles_; }
  /// Whether a vertex is convex and has circles.
  [[nodiscard]] bool has(VertexId v) const { return first_[v] != kNone; }
  /// The circle round a convex vertex alone, of the smallest radius: an index into `all`.
  [[nodiscard]] std::uint32_t first_round(VertexId v, Side side) const {
    return first_[v] + (side == Side::kLeft ? 0 : 1);
  }
  /// Calls visit(circle) for each circle round a convex vertex, alone or with another one: indices into `all`.
  template <class Visitor>
  void visit_round(VertexId v, Side side, Visitor&& visit) const {
    const std::uint32_t right = side == Side::kLeft ? 0 : 1;
    for (std::uint32_t k = 0; k < radius_count_; ++k) visit(first_[v] + 2 * k + right);
    for (std::uint64_t i = shared_starts_[v]; i < shared_starts_[v + 1]; ++i) visit(shared_[i] + right);
  }

 private:
  std::size_t radius_count_;
  std::vector<TurnCircle> circles_;
  std::vector<std::uint32_t> first_;          // of each vertex's own circles, or kNone
  std::vector<std::uint64_t> shared_starts_;  // into shared_, by vertex
  std::vector<std::uint32_t> shared_;         // left circles round two vertices
};

}  // namespace arcway
