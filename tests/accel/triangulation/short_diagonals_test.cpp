#include "accel/triangulation/short_diagonals.h"

#include <gtest/gtest.h>

#include "accel/expansion/free_space_triangulation.h"
#include "arcway/datasets/clutter.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Large enough for several blocks of triangles that are flipped at the same time.
TEST(ShortDiagonals, AreTheSameForAnyNumberOfThreads) {
  const World world = random_world({.obstacles = 3000, .vertices = 10, .fill = 0.3, .seed = 1});
  const ThreadExecutor threads(4);
  for (const Diagonals which : {Diagonals::kLong, Diagonals::kAll}) {
    const FreeSpaceTriangulation one(world, SerialExecutor(), which), many(world, threads, which);
    ASSERT_EQ(one.half_edges().size(), many.half_edges().size());
    for (std::size_t d = 0; d < one.half_edges().size(); ++d) {
      EXPECT_EQ(one.half_edges()[d].left, many.half_edges()[d].left);
      EXPECT_EQ(one.half_edges()[d].right, many.half_edges()[d].right);
      EXPECT_EQ(one.half_edges()[d].point, many.half_edges()[d].point);
    }
  }
}

}  // namespace
}  // namespace arcway::internal
