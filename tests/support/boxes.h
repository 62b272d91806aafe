#pragma once

#include "arcway/world.h"

namespace arcway::internal::test {

/// The border of an upright rectangle.
inline Ring box_ring(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// An upright rectangle without holes.
inline Polygon box(double left, double bottom, double right, double top) {
  return {box_ring(left, bottom, right, top), {}};
}

}  // namespace arcway::internal::test
