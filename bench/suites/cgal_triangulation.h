#pragma once

#include "core/world.h"

namespace arcway::bench {

/// CGAL's constrained Delaunay triangulation of all vertices and edges of a world: the yardstick of the wedge builder.
/// Exact predicates, constraints inserted at once in CGAL's own spatial order, which is its fast way. The world's edges
/// must not cross.
/// @return  number of triangles.
std::size_t triangulate_by_cgal(const World& world);

}  // namespace arcway::bench
