#pragma once

#include <cstddef>
#include <vector>

#include "datasets/grid/trace.h"

namespace arcway::internal {

/// Takes corners away so that the polygons grow and never shrink: every blocked cell stays covered, and no point of a
/// ring moves by more than `tolerance` cells. Corners are those of cells before and after.
///
/// A corner goes if the triangle that it makes with its two neighbors lies on the free side or is flat, and holds no
/// other corner of any polygon. All corners that went between these neighbors must be within the tolerance of the new
/// edge: so each step adds a triangle of free space, and no two rings cross or touch that did not before. Nearest
/// first, then by the number of corners that the new edge replaces, then in order. All decisions but that of the
/// tolerance are exact.
///
/// O(n log n) for tolerances of some cells; an edge replaces at most 1,000 corners.
/// @param tolerance  >= 0, in cells. Half a cell smooths shallow stairs, one cell stairs of 45 degrees as well.
void simplify(std::vector<CornerPolygon>& polygons, double tolerance);

/// Of all rings.
std::size_t corner_count(const std::vector<CornerPolygon>& polygons);

}  // namespace arcway::internal
