#pragma once

#include "arcway/world.h"

namespace arcway::internal::test {

/// An upright rectangle without holes.
inline Polygon box(double left, double bottom, double right, double top) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}};
}

}  // namespace arcway::internal::test
