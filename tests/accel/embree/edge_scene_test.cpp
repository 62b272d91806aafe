#include "accel/embree/edge_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <new>

#include "arcway/datasets/clutter.h"

namespace arcway::internal::embree {
namespace {

// Embree takes an exception of a callback for an error of its own and answers as if nothing more were near.
TEST(EdgeScene, HandsOnWhatAVisitThrows) {
  const World world = random_world({.obstacles = 30, .vertices = 6, .fill = 0.15, .seed = 7});
  const EdgeScene scene(std::make_shared<const Device>(), world, nullptr, {});
  int visits = 0;
  const auto visit = [&](VertexId) -> double {
    if (++visits == 3) throw std::bad_alloc();
    return 100.0;
  };
  EXPECT_THROW(scene.visit_near(world.vertex(0), 100.0, visit), std::bad_alloc);
  EXPECT_EQ(visits, 3);
  scene.visit_near(world.vertex(0), 100.0, visit);
  EXPECT_GT(visits, 10);
}

}  // namespace
}  // namespace arcway::internal::embree
