#include "core/roadmap/link_rows.h"

#include <gtest/gtest.h>

#include <vector>

namespace arcway::internal {
namespace {

TEST(LinkRows, LieOneBehindTheOther) {
  const std::vector<LinkRow> rows{{{{0, 1, 0.5, 2.0}, {0, 2, 0.6, 3.0}}, {.candidates = 5, .overlaps = 3}},
                                  {{}, {.candidates = 1, .straights = 1}},
                                  {{{2, 0, 0.1, 1.0}}, {.candidates = 1}}};
  const LinkRows all = compressed(rows);
  EXPECT_EQ(all.starts, (std::vector<std::uint64_t>{0, 2, 2, 3}));
  ASSERT_EQ(all.of(0).size(), 2u);
  EXPECT_EQ(all.of(0)[1].to, 2u);
  EXPECT_TRUE(all.of(1).empty());
  ASSERT_EQ(all.of(2).size(), 1u);
  EXPECT_EQ(all.of(2)[0].from, 2u);
  FeasibleGraphCounts sum;
  for (const LinkCounts& row : all.counts) add_counts(row, sum);
  EXPECT_EQ(sum.candidates, 7u);
  EXPECT_EQ(sum.rejected_overlap, 3u);
  EXPECT_EQ(sum.rejected_straight, 1u);
  EXPECT_EQ(sum.kept, 0u);
}

}  // namespace
}  // namespace arcway::internal
