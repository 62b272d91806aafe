#pragma once

#include <cstddef>
#include <vector>

#include "datasets/grid/trace.h"

namespace arcway::internal {

/// Removes corners so that the polygons grow and never shrink: every blocked cell stays covered, and no point of a ring
/// moves by more than `tolerance` cells. Corners are corners of cells before and after.
///
/// A corner may go if the triangle with its two neighbors lies on the free side or is flat, and contains no other
/// corner of any polygon. All corners removed between these neighbors must lie within the tolerance of the new edge. So
/// each step adds a triangle of free space, and no two rings begin to cross or touch. Corners go in the order of their
/// distance, then by the number of corners that the new edge replaces. All decisions but that of the tolerance are
/// exact.
///
/// O(n log n) for tolerances of some cells; an edge replaces at most 1,000 corners.
/// @param tolerance  >= 0, in cells. Half a cell smooths shallow stairs, one cell stairs of 45 degrees as well.
void simplify(std::vector<CornerPolygon>& polygons, double tolerance);

/// Number of corners of all rings.
std::size_t corner_count(const std::vector<CornerPolygon>& polygons);

}  // namespace arcway::internal
