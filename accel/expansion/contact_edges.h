#pragma once

#include <span>
#include <vector>

#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Edges of the reduced visibility graph that cross an obstacle edge where a vertex of the same region touches it, see
/// World::self_contacts.
///
/// Such an edge leads from the vertex's cone of free space to the free side of the obstacle edge. No triangle lies at
/// such a point, so tangent-cone expansion does not find it. Each edge is listed once, u < v, ascending.
///
/// O(1) without contacts; else O(n log n + triangles seen from each contact).
/// @param triangulation  of the world; must have listed its left edges if there are contacts.
EdgeList edges_through_contacts(const World& world, const FreeSpaceTriangulation& triangulation);

/// Adds the edges that none of the lists has yet. O(e log k) for k added edges and e listed ones.
void add_missing(EdgeList added, std::vector<EdgeList>& lists);

/// Returns each edge in both directions, ascending.
EdgeList both_ways(EdgeList edges);

/// Adds a vertex's edges from a sorted list of edges in both directions to its row of the graph; the row stays
/// ascending. O(log k) for a list of k edges that has none of the vertex.
void add_missing(std::span<const EdgeList::value_type> both_ways, VertexId vertex, std::vector<VertexId>& row);

/// Keeps those vertices seen from a point that are convex and tangent there and have no such vertex before them;
/// ascending.
void keep_tangents(const World& world, const Vec2& point, std::vector<VertexId>& seen);

}  // namespace arcway::internal
