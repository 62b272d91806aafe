#pragma once

#include <cstdint>

#include "arcway/executor.h"
#include "arcway/visibility_graph.h"
#include "arcway/visibility_query.h"
#include "arcway/world.h"

namespace arcway::internal {

/// How the tangent pairs of two convex obstacles are found.
enum class TangentSearch {
  kBinary,   ///< the four common tangents of two convex polygons by binary search [Rohnert 1986]
  kAllPairs  ///< a tangency test for every pair of vertices
};

/// What the pairwise builder did.
struct PairwiseCounts {
  std::uint64_t vertex_pairs = 0;   ///< tested for tangency one by one
  std::uint64_t binary_pairs = 0;   ///< pairs of convex obstacles whose tangents were found by binary search
  std::uint64_t tangent_pairs = 0;  ///< lines of sight asked for
};

/// The reduced visibility graph, the same as core's build_reduced_visibility_graph: by vertex pairs. A filter in single
/// precision throws out what is clearly not tangent, core's exact test decides the rest, and `visibility` answers for
/// the tangent pairs. Between two convex obstacles whose boxes are disjoint the four common tangents are found
/// directly, in O(log n1 + log n2) as a rule.
///
/// O(n^2) or, among convex obstacles, O(k^2 log n) for k obstacles, plus a line of sight for each tangent pair.
/// Memory: the visible edges three times, and the tangent pairs of 8 vertices, 64 of a convex obstacle, a thread. The
/// result does not depend on the executor; one that throws, such as StoppableExecutor, cancels the build.
VisibilityGraph build_pairwise_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                                const Executor& executor, TangentSearch search = TangentSearch::kBinary,
                                                PairwiseCounts* counts = nullptr);

}  // namespace arcway::internal
