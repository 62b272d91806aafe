#pragma once

#include <span>
#include <vector>

#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Edges of the reduced visibility graph that cross an edge of a region where a vertex of the same region touches it:
/// see World::self_contacts. They lead from the vertex's wedge of free space to the free side of the edge. Walks pass
/// through triangles, and there is none at such a point. Each is listed once, u < v, ascending.
///
/// O(1) without contacts; else O(n log n) and what is seen from each contact.
/// @param map  of the world; lists left edges if there are contacts.
EdgeList edges_through_contacts(const World& world, const FreeSpaceTriangulation& triangulation);

/// Adds to lists what none of them has yet. O(e log k) for k edges to be added to e.
void add_missing(EdgeList added, std::vector<EdgeList>& lists);

/// The same edges from both of their ends, ascending.
EdgeList both_ways(EdgeList edges);

/// Adds to a row of the graph what its vertex has in a list of edges both ways; ascending again. O(log k) if it has
/// none of k.
void add_missing(std::span<const EdgeList::value_type> both_ways, VertexId vertex, std::vector<VertexId>& row);

/// Of the vertices that a point sees, keeps the convex ones at which its line is tangent, with no other such vertex in
/// between; ascending.
void keep_tangents(const World& world, const Vec2& point, std::vector<VertexId>& seen);

}  // namespace arcway::internal
