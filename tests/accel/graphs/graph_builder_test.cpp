#include "arcway/accel/graph_builder.h"

#include <gtest/gtest.h>

#include "arcway/datasets/clutter.h"

namespace arcway::internal {
namespace {

GraphBuilder choice(ClutterKind kind, std::size_t obstacles, std::size_t vertices) {
  return faster_graph_builder(
      random_world({.kind = kind, .obstacles = obstacles, .vertices = vertices, .fill = 0.2, .seed = 1}));
}

TEST(GraphBuilderChoice, TangentConesForAnyShape) {
  EXPECT_EQ(faster_graph_builder(World({})), GraphBuilder::kTangentCones);
  EXPECT_EQ(choice(ClutterKind::kConvex, 2, 4), GraphBuilder::kTangentCones);
  EXPECT_EQ(choice(ClutterKind::kConvex, 1000, 10), GraphBuilder::kTangentCones);
  EXPECT_EQ(choice(ClutterKind::kConvex, 10, 1000), GraphBuilder::kTangentCones);
  EXPECT_EQ(choice(ClutterKind::kConvex, 5, 3000), GraphBuilder::kTangentCones);
  EXPECT_EQ(choice(ClutterKind::kStar, 5, 3000), GraphBuilder::kTangentCones);
}

TEST(GraphBuilderChoice, HasNames) {
  EXPECT_STREQ(name_of(GraphBuilder::kPairwise), "pairwise");
  EXPECT_STREQ(name_of(GraphBuilder::kTangentCones), "tangent-cones");
}

}  // namespace
}  // namespace arcway::internal
