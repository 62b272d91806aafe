#pragma once

#include "arcway/executor.h"
#include "arcway/path.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Whether the line through the convex vertex v with the direction towards p is tangent at v: both
/// neighbors of v on one closed side of it. Exact. p != v; false if p == v.
bool is_tangent(const World& world, VertexId v, const Vec2& p);

/// The side of the obstacle at a tangent vertex, seen when traveling from `from` through v. Precondition:
/// is_tangent(world, v, from).
Side obstacle_side(const World& world, VertexId v, const Vec2& from);

/// Of the tangent edges at each vertex that lie on one ray, only the nearest: (iii) of build_reduced_visibility_graph,
/// for a graph that has all edges of (i) and (ii). Exact; O(e log e) for e edges.
VisibilityGraph without_carried_edges(const World& world, const VisibilityGraph& graph, const Executor& executor);

}  // namespace arcway::internal
