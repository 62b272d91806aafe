#pragma once

#include <optional>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway::internal {

/// A gap: two edges, of two obstacles or of one, and the points where they are nearest to each other.
struct Gap {
  double width;  ///< 0 where they meet [m]
  VertexId edge_a, edge_b;
  Vec2 on_a, on_b;
};

/// The gaps between obstacles, for finding bottlenecks: the narrowest gap of the widest route between two points. The
/// widest route is the one for the largest disc. A disc of diameter d can move from one point to the other if and only
/// if their bottleneck is wider than d.
///
/// **Why gaps suffice.**
/// 1. The center of a disc of diameter d has to stay off all edges grown by d/2.
/// 2. Grown edges are convex, and so are their intersections. By the nerve theorem [Borsuk 1948], the loops of their
///    union are those of a graph: it joins each two edges at most d apart, which share the middle of their gap.
/// 3. The union separates two points if and only if one of its loops winds around just one of them. Such a loop crosses
///    a curve between the points an odd number of times.
/// 4. Gaps are therefore added one by one, the narrowest first. The one that first closes an odd loop is the
///    bottleneck.
/// 5. A gap is not needed if a third edge enters the circle that has the gap for a diameter. All three grown edges then
///    have its middle in common, and the gaps to the third edge are narrower.
///
/// **Obstacles** may touch, overlap and have holes; the bounds are one more. Where edges meet, or one ring separates
/// the points, the bottleneck has width 0.
///
/// Crossings are counted exactly; widths and ends of gaps are rounded. Immutable and thread-safe.
class GapMap {
 public:
  /// Finds all gaps up to a width [m] that may be bottlenecks. O(n log n + k log n) for n edges and k pairs of them so
  /// near to each other.
  /// @throws Canceled if the clock is over before all are found.
  GapMap(const World& world, double widest, const StopClock& clock = {});

  /// The gaps by width, then edges; without those between neighbors on a ring.
  [[nodiscard]] std::span<const Gap> gaps() const { return gaps_; }

  /// The bottleneck of two points. Nothing if a disc of the largest width passes, or one as wide as the room around one
  /// of the points, which is twice its distance from the next edge. Nothing for two points in one place. O(n + gaps).
  /// Precondition: no point lies on an edge.
  /// @throws Canceled if the clock is over before that is known.
  [[nodiscard]] std::optional<Gap> bottleneck(const Vec2& from, const Vec2& to, const StopClock& clock = {}) const;

 private:
  World world_;
  std::vector<Gap> gaps_;
};

}  // namespace arcway::internal
