#pragma once

#include <optional>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Where two edges are nearest to each other, of two obstacles or of one.
struct Gap {
  double width;  ///< 0 where they meet [m]
  VertexId edge_a, edge_b;
  Vec2 on_a, on_b;
};

/// How wide are the ways from one point to another?
///
/// The widest way between two points is the one for the largest disc; the bottleneck of two points is the narrowest gap
/// that their widest way passes through. A disc of diameter d passes from one to the other if and only if their
/// bottleneck is wider than d.
///
/// **Why gaps suffice.** The center of a disc of diameter d has to stay clear of all edges grown by d/2. Grown edges
/// are convex; so all that they have in common is convex too, and their union has the loops of their nerve [Borsuk
/// 1948]: those of the graph that joins each two edges at most d apart, which share the middle of their gap. The union
/// parts two points if and only if one of its loops winds round just one of them, that is, has an odd number of
/// crossings with a curve between them. So: add the gaps one by one, the narrowest first; the one that first closes an
/// odd loop is the bottleneck. A gap is not needed if a third edge comes into the circle that has it for a diameter:
/// all three, grown, have the middle in common, and the gaps to the third edge are narrower.
///
/// **Obstacles** may touch, overlap and have holes; the bounds are one more. Where edges meet, or one ring parts the
/// points, the bottleneck has width 0.
///
/// Crossings are counted exactly, widths and the ends of gaps are rounded. Immutable and thread-safe.
class GapMap {
 public:
  /// All gaps that may be bottlenecks, up to a width. Time O(n log n + k log n) for n edges, k pairs of them so near to
  /// each other.
  /// @throws Canceled if the clock is over before all are found.
  GapMap(const World& world, double widest, const StopClock& clock = {});

  /// By width, then edges; without those of edges that follow each other in a ring.
  [[nodiscard]] std::span<const Gap> gaps() const { return gaps_; }

  /// Nothing if a disc of the largest width asked for passes, or one with the diameter of the room around one of the
  /// points: twice its distance to the next edge. Two points in one place have none. O(n + gaps).
  /// Precondition: no point lies on an edge.
  /// @throws Canceled if the clock is over before that is known.
  [[nodiscard]] std::optional<Gap> bottleneck(const Vec2& from, const Vec2& to, const StopClock& clock = {}) const;

 private:
  World world_;
  std::vector<Gap> gaps_;
};

}  // namespace arcway::internal
