#pragma once

#include <vector>

#include "arcway/executor.h"
#include "arcway/path.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Whether the line from p through the convex vertex v is tangent at v: both neighbors of v lie on one closed side of
/// it. Exact. False if p == v.
bool is_tangent(const World& world, VertexId v, const Vec2& p);

/// The side of the obstacle at a tangent vertex, when traveling from `from` through v. Precondition: is_tangent(world,
/// v, from).
Side obstacle_side(const World& world, VertexId v, const Vec2& from);

/// Of the vertices joined to a convex vertex u by edges with (i) and (ii) of build_reduced_visibility_graph, keeps
/// those with (iii): the nearest ones in each direction. Ascending.
/// @param around  all of them, or at least the nearest ones; none at the place of u.
void keep_nearest(const World& world, VertexId u, std::vector<VertexId>& around);

/// The graph without edges that pass through a convex vertex: of the edges at a vertex on one ray, only the shortest
/// stays. That is (iii) of build_reduced_visibility_graph, for a graph of all edges with (i) and (ii). Exact; O(e log
/// e) for e edges.
VisibilityGraph without_carried_edges(const World& world, const VisibilityGraph& graph, const Executor& executor);

}  // namespace arcway::internal
