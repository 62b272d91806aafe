#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "arcway/feasible_graph_snapshot.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal::test {

/// Whether two arrays are equal, bit for bit.
template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Expects two finished graphs to be equal, bit for bit.
inline void expect_same(const FeasibleGraph& a, const FeasibleGraph& b) {
  ASSERT_TRUE(a.finished() && b.finished());
  const FeasibleGraphSnapshot x = a.finished()->snapshot(), y = b.finished()->snapshot();
  EXPECT_TRUE(same_bytes(x.interval_starts, y.interval_starts));
  EXPECT_TRUE(same_bytes(x.intervals, y.intervals));
  EXPECT_TRUE(same_bytes(x.link_starts, y.link_starts));
  EXPECT_TRUE(same_bytes(x.links, y.links));
  EXPECT_TRUE(same_bytes(x.link_counts, y.link_counts));
  const FeasibleGraphCounts m = a.counts(), n = b.counts();
  EXPECT_EQ(std::memcmp(&m, &n, sizeof m), 0);
}

}  // namespace arcway::internal::test
