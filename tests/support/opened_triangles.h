#pragma once

#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/opened_triangulation.h"
#include "accel/expansion/triangle_blocks.h"
#include "arcway/world.h"

namespace arcway::internal::test {

/// A triangulation whose obstacles may be opened, with what it needs.
struct OpenedTriangles {
  explicit OpenedTriangles(const World& the_world)
      : world(the_world), triangulation(world), blocks(with_left_edges()) {}

  World world;
  FreeSpaceTriangulation triangulation;
  TriangleBlocks blocks;
  OpenedTriangulation opened{triangulation, &blocks};

 private:
  const FreeSpaceTriangulation& with_left_edges() {
    triangulation.list_left_edges();
    return triangulation;
  }
};

}  // namespace arcway::internal::test
