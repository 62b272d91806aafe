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

/// Work done by the pairwise builder.
struct PairwiseCounts {
  std::uint64_t vertex_pairs = 0;   ///< pairs of vertices tested for tangency
  std::uint64_t binary_pairs = 0;   ///< pairs of convex obstacles whose tangents were found by binary search
  std::uint64_t tangent_pairs = 0;  ///< lines of sight tested
};

/// The reduced visibility graph by pairs of vertices; it equals that of core's build_reduced_visibility_graph.
///
/// A filter in single precision rejects pairs that are clearly not tangent. Core's exact test decides the rest, and
/// `visibility` tests the tangent pairs. Between two convex obstacles with disjoint boxes the four common tangents are
/// computed directly, in O(log n1 + log n2) as a rule.
///
/// O(n²) or, among convex obstacles, O(k² log n) for k obstacles, plus a line of sight for each tangent pair. Memory:
/// three times the visible edges, plus the tangent pairs of 8 vertices a thread (64 of a convex obstacle). The result
/// does not depend on the executor; an executor that throws cancels the build.
VisibilityGraph build_pairwise_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                                const Executor& executor, TangentSearch search = TangentSearch::kBinary,
                                                PairwiseCounts* counts = nullptr);

}  // namespace arcway::internal
