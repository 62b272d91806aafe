#include "core/collision/memoized_sweep.h"

#include <gtest/gtest.h>

#include <memory>

#include "arcway/query_set.h"
#include "tests/support/counting_sweep.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

const Footprint kSweptBody{1.4, 0.1, 0.4, 0.4};
// Bodies that differ on one side alone.
Footprint swept_body(int i) { return {1.4, 0.1, i % 3 == 1 ? 0.9 : 0.4, i % 3 == 2 ? 0.9 : 0.4}; }

TEST(MemoizedSweep, AsksEachQuestionOnceAndAnswersAlike) {
  test::RandomInputs random(3);
  const World world({{{{-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}}, {}}});
  const auto counting = std::make_shared<test::CountingSweep>(world);
  const MemoizedSweep memoized(counting);
  std::vector<SweptRectangle> rectangles;
  std::vector<TurningBody> bodies;
  for (int i = 0; i < 50; ++i) {
    const Vec2 p = random.point(-4.0, 4.0);
    rectangles.push_back(swept_rectangle({p.x(), p.y(), random.uniform(-3.0, 3.0)}, random.uniform(0, 4), kSweptBody));
    const double radius = random.uniform(1.3, 4.0);
    for (int k = 0; k < 3; ++k) bodies.push_back({p, radius, i % 2 == 0 ? Side::kLeft : Side::kRight, swept_body(k)});
  }
  for (int round = 0; round < 3; ++round)
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (i < rectangles.size()) {
        EXPECT_EQ(memoized.straight_free(rectangles[i]),
                  make_reference_queries(world).sweep->straight_free(rectangles[i]));
      }
      const HeadingSet expected = make_reference_queries(world).sweep->free_headings(bodies[i]);
      const HeadingSet found = memoized.free_headings(bodies[i]);
      ASSERT_EQ(found.intervals().size(), expected.intervals().size());
      for (std::size_t k = 0; k < expected.intervals().size(); ++k) {
        EXPECT_EQ(found.intervals()[k].low, expected.intervals()[k].low);
        EXPECT_EQ(found.intervals()[k].high, expected.intervals()[k].high);
      }
    }
  EXPECT_EQ(counting->asked() + counting->headings_asked(), rectangles.size() + bodies.size());
}

}  // namespace
}  // namespace arcway::internal
