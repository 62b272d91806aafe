#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "arcway/world.h"

namespace arcway::internal::test {

/// Expects that two worlds have the same obstacles and bounds, and that all that is known about them is the same.
inline void expect_same_world(const World& a, const World& b) {
  ASSERT_EQ(a.vertices().size(), b.vertices().size());
  ASSERT_EQ(a.obstacle_count(), b.obstacle_count());
  ASSERT_EQ(a.has_bounds(), b.has_bounds());
  for (VertexId v = 0; v < a.vertices().size(); ++v) {
    ASSERT_EQ(a.vertex(v), b.vertex(v)) << v;
    ASSERT_EQ(a.next(v), b.next(v)) << v;
    ASSERT_EQ(a.previous(v), b.previous(v)) << v;
    ASSERT_EQ(a.obstacle_of(v), b.obstacle_of(v)) << v;
    ASSERT_EQ(a.is_convex(v), b.is_convex(v)) << v;
    ASSERT_EQ(a.is_covered(v), b.is_covered(v)) << v;
    ASSERT_EQ(a.edges()[v].b, b.edges()[v].b) << v;
  }
  ASSERT_TRUE(std::equal(a.convex_vertices().begin(), a.convex_vertices().end(), b.convex_vertices().begin(),
                         b.convex_vertices().end()));
  for (ObstacleId o = 0; o < a.region_count(); ++o) {
    ASSERT_EQ(a.vertices_of(o).first, b.vertices_of(o).first);
    ASSERT_EQ(a.vertices_of(o).last, b.vertices_of(o).last);
    ASSERT_TRUE(
        std::equal(a.ring_starts(o).begin(), a.ring_starts(o).end(), b.ring_starts(o).begin(), b.ring_starts(o).end()));
    ASSERT_EQ(a.box_of(o).min, b.box_of(o).min);
    ASSERT_EQ(a.box_of(o).max, b.box_of(o).max);
  }
  ASSERT_TRUE(std::ranges::equal(a.self_contacts(), b.self_contacts()));
  if (a.vertices().empty()) return;
  ASSERT_EQ(a.box().min, b.box().min);
  ASSERT_EQ(a.box().max, b.box().max);
}

}  // namespace arcway::internal::test
