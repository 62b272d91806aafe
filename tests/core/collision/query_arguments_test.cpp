#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "arcway/query_set.h"
#include "arcway/vehicle.h"

namespace arcway::internal {
namespace {

class QueryArguments : public testing::Test {
 protected:
  const QuerySet queries_ = make_reference_queries(World({}));
  const Vec2 good_{1.0, 2.0};
};

TEST_F(QueryArguments, CoordinatesAreZeroOrOfTheMagnitudesOfMaps) {
  for (const double x : {0.0, -0.0, 1e-100, -1e100}) {
    EXPECT_NO_THROW((void)queries_.visibility->visible({good_, {x, 1.0}})) << x;
    EXPECT_NO_THROW((void)queries_.distance->containing({1.0, x})) << x;
  }
  for (const double x : {1e-101, -1e101, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Vec2 bad(1.0, x);
    EXPECT_THROW((void)queries_.visibility->visible({good_, bad}), std::invalid_argument) << x;
    EXPECT_THROW((void)queries_.visibility->visible({{x, 1.0}, good_}), std::invalid_argument) << x;
    EXPECT_THROW((void)queries_.distance->closest(bad), std::invalid_argument) << x;
    EXPECT_THROW((void)queries_.distance->containing(bad), std::invalid_argument) << x;
    EXPECT_THROW((void)queries_.sweep->straight_free({good_, good_, good_, bad}), std::invalid_argument) << x;
    EXPECT_THROW((void)queries_.sweep->free_headings({bad, 1.0, Side::kLeft, Vehicle{}.footprint()}),
                 std::invalid_argument)
        << x;
  }
}

TEST_F(QueryArguments, RadiiAndDistancesAreNumbers) {
  for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW((void)queries_.sweep->free_headings({good_, radius, Side::kLeft, Vehicle{}.footprint()}),
                 std::invalid_argument)
        << radius;
  std::uint8_t closer = 0;
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  EXPECT_NO_THROW(queries_.distance->closer_than({&good_, 1}, {&infinity, 1}, {&closer, 1}));
  EXPECT_THROW(queries_.distance->closer_than({&good_, 1}, {&nan, 1}, {&closer, 1}), std::invalid_argument);
}

TEST_F(QueryArguments, BodiesCoverSomething) {
  const auto ask = [&](const Footprint& body) {
    return queries_.sweep->free_headings({good_, 1.0, Side::kLeft, body});
  };
  EXPECT_NO_THROW((void)ask({2.0, -0.5, 0.4, 0.4}));
  EXPECT_NO_THROW((void)ask({-0.5, 2.0, 0.4, 0.4}));
  EXPECT_NO_THROW((void)ask({1.0, 0.3, 0.8, -0.2}));
  EXPECT_NO_THROW((void)ask({1.0, 0.3, -0.2, 0.8}));
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const Footprint& body :
       {Footprint{nan, 1.0, 0.4, 0.4}, Footprint{1.0, nan, 0.4, 0.4}, Footprint{1.0, 0.3, nan, nan},
        Footprint{infinity, 0.3, 0.4, 0.4}, Footprint{1.0, 0.3, infinity, infinity}, Footprint{1.0, 0.3, 0.0, 0.0},
        Footprint{1.0, 0.3, -0.4, -0.4}, Footprint{1.0, 0.3, nan, 0.4}, Footprint{1.0, 0.3, 0.4, infinity},
        Footprint{1.0, 0.3, 0.4, -0.4}, Footprint{1.0, -1.0, 0.4, 0.4}})
    EXPECT_THROW((void)ask(body), std::invalid_argument)
        << body.front << " " << body.rear << " " << body.left << " " << body.right;
  try {
    (void)ask({1.0, 0.3, -0.5, 0.25});
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "query 0: the body's width, left + right, is -0.25, must be positive");
  }
}

TEST_F(QueryArguments, AnswersHaveRoom) {
  const std::array<Vec2, 2> points{good_, good_};
  const std::array<double, 1> distance{1.0};
  std::array<std::uint8_t, 1> answer{};
  std::array<std::uint8_t, 2> answers{};
  std::array<ObstacleId, 1> obstacle{};
  const std::array<LineSegment, 2> segments{LineSegment{good_, {3, 4}}, LineSegment{good_, {5, 6}}};
  EXPECT_THROW(queries_.visibility->visible(segments, answer), std::invalid_argument);
  EXPECT_THROW(queries_.distance->containing(points, obstacle), std::invalid_argument);
  EXPECT_THROW(queries_.distance->closer_than(points, distance, answers), std::invalid_argument);
  EXPECT_THROW(queries_.distance->closer_than({points.data(), 1}, distance, answers), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal
