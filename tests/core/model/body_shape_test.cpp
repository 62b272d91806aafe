#include "arcway/body_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/geometry/distance.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

std::string parts_refusal(std::vector<Ring> parts) {
  try {
    const BodyShape shape(std::move(parts));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

// A fork lift truck: a body and two tines.
const Ring kFork{{-1, -0.5}, {1, -0.5}, {1, -0.4}, {2, -0.4}, {2, -0.2}, {1, -0.2},
                 {1, 0.2},   {2, 0.2},  {2, 0.4},  {1, 0.4},  {1, 0.5},  {-1, 0.5}};

TEST(BodyShape, HasPiecesAndWhatLiesInside) {
  const BodyShape fork({kFork});
  EXPECT_FALSE(fork.is_rectangle());
  EXPECT_EQ(fork.pieces().size(), 3u);
  EXPECT_EQ(fork.bounds().min, Vec2(-1, -0.5));
  EXPECT_EQ(fork.bounds().max, Vec2(2, 0.5));
  EXPECT_NEAR(fork.disc(), 1.0, 1e-3);
  EXPECT_LE(fork.disc(), 1.0);
  EXPECT_NEAR((fork.core().min - Vec2(-1, -0.5)).norm() + (fork.core().max - Vec2(1, 0.5)).norm(), 0.0, 1e-10);
  ASSERT_EQ(fork.inner_points().size(), 1u);
  EXPECT_EQ(distance(fork.inner_points()[0], Polygon{kFork, {}}), 0.0);
}

TEST(BodyShape, TurnsClockwiseRingsAround) {
  const BodyShape fork({test::reversed(kFork)});
  EXPECT_EQ(winding(fork.parts()[0]), 1);
  EXPECT_EQ(fork.parts()[0].size(), 12u);
}

TEST(BodyShape, LeavesOutStraightCornersAndTheRepeatedEnd) {
  const BodyShape shape({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0.25}, {0, 0}}});
  EXPECT_EQ(shape.parts()[0].size(), 4u);
  EXPECT_TRUE(shape.is_rectangle());
  EXPECT_EQ(shape.core().max, Vec2(2, 1));
}

TEST(BodyShape, IsARectangleOnlyIfUpright) {
  EXPECT_TRUE(BodyShape({test::box_ring(-1, -0.5, 2, 0.75)}).is_rectangle());
  EXPECT_TRUE(BodyShape({test::reversed(test::box_ring(-1, -0.5, 2, 0.75))}).is_rectangle());
  EXPECT_FALSE(BodyShape({{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}).is_rectangle());
  EXPECT_FALSE(BodyShape({test::square(0, 0, 1), test::square(2, 0, 1)}).is_rectangle());
}

TEST(BodyShape, OfSeveralPartsHasThatOfTheLargest) {
  const BodyShape shape({test::square(3, 0, 0.5), test::square(0, 0, 2), test::square(0, 3, 1)});
  EXPECT_EQ(shape.inner_points().size(), 3u);
  EXPECT_NEAR(shape.disc(), 2.0, 2e-3);
  EXPECT_NEAR((shape.core().max - Vec2(2, 2)).norm(), 0.0, 1e-10);
}

TEST(BodyShape, PartsMayTouch) {
  EXPECT_EQ(parts_refusal({test::square(0, 0, 1), test::square(1, 0, 1)}), "accepted");
  EXPECT_EQ(parts_refusal({test::square(0, 0, 1), test::square(1, 0.5, 1)}), "accepted");
  EXPECT_EQ(parts_refusal({test::square(0, 0, 1), test::square(1, 1, 1)}), "accepted");
}

TEST(BodyShape, ErrorsNamePartAndVertex) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(parts_refusal({}), "vehicle: footprint has 0 parts, must have >= 1");
  EXPECT_EQ(parts_refusal({test::square(0, 0, 1), {{0, 0}, {1, 0}, {0, 0}}}),
            "vehicle: footprint[1] has 2 corners, must have >= 3");
  EXPECT_EQ(parts_refusal({{{0, 0}, {1, nan}, {1, 1}}}),
            "vehicle: footprint[0][1] is (1, nan), each coordinate must be 0 or of magnitude 1e-100 to 1e+50 m");
  EXPECT_EQ(parts_refusal({{{0, 0}, {1, 0}, {1, 1e51}}}),
            "vehicle: footprint[0][2] is (1, 1e+51), each coordinate must be 0 or of magnitude 1e-100 to 1e+50 m");
  EXPECT_EQ(parts_refusal({{{0, 0}, {1, 1}, {2, 2}}}), "vehicle: footprint[0] has no area");
  EXPECT_EQ(
      parts_refusal({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}),
      "vehicle: footprint[0]: the side from vertex 0 to 1 crosses the side from vertex 2 to 3 at (1, 1), give the "
      "corners in their order around the body");
  EXPECT_EQ(parts_refusal({{{0, 0}, {2, 2}, {2, 0}, {0, 1}}}),
            "vehicle: footprint[0]: the side from vertex 0 to 1 crosses the side from vertex 2 to 3 at "
            "(0.6666666666666666, 0.6666666666666666), give the corners in their order around the body");
  EXPECT_EQ(parts_refusal({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}),
            "vehicle: footprint[0][1] and footprint[0][2] are both (1, 0), remove one of them");
  EXPECT_EQ(parts_refusal({{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}}),
            "vehicle: footprint[0][3], (2, 0), lies on the side from vertex 0 to 1: a ring may not touch itself, give "
            "two parts");
  EXPECT_EQ(
      parts_refusal({{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}}),
      "vehicle: footprint[0][1] and footprint[0][4] are both (1, 1): a ring may not touch itself, give two parts");
  EXPECT_EQ(parts_refusal({test::square(0, 0, 2), test::square(1, 1, 2)}),
            "vehicle: footprint[0] and footprint[1] overlap near (2, 2), join them to one part or move them apart");
  EXPECT_NE(parts_refusal({test::square(0, 0, 4), test::square(1, 1, 1)}).find("overlap"), std::string::npos);
}

TEST(GrownBody, GrowsEachPiece) {
  const BodyShape fork({kFork});
  const GrownBody grown(fork, 0.125);
  ASSERT_EQ(grown.pieces.size(), fork.pieces().size());
  EXPECT_EQ(grown.inner_points[0], fork.inner_points()[0]);
  EXPECT_NEAR((grown.bounds.min - Vec2(-1.125, -0.625)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((grown.bounds.max - Vec2(2.125, 0.625)).norm(), 0.0, 1e-15);
  const GrownBody bare(fork, 0.0);
  for (std::size_t i = 0; i < fork.pieces().size(); ++i) EXPECT_EQ(bare.pieces[i], fork.pieces()[i]);
}

}  // namespace
}  // namespace arcway::internal
