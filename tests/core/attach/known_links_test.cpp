#include "core/attach/known_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "core/roadmap/build_feasible_graph.h"

namespace arcway::internal {
namespace {

constexpr double kAnyLength = std::numeric_limits<double>::infinity();

class KnownLinksTest : public ::testing::Test {
 protected:
  using Links = HugeVector<AttachmentLink>;

  [[nodiscard]] Roadmap map_of(const CircleRadii& radii) const { return map_.with_graph(graph_of(radii), radii); }
  [[nodiscard]] std::shared_ptr<const FeasibleGraph> graph_of(const CircleRadii& radii) const {
    return build_feasible_graph({world_, planner_.vehicle(), planner_.visibility_rows(), planner_.queries(), radii},
                                SerialExecutor());
  }
  [[nodiscard]] AttachmentCircle circle(const Roadmap& map, Direction direction) {
    std::vector<AttachmentCircle> circles;
    const Attachment attachment{direction == Direction::kFromStart ? request_.start : request_.goal, {}};
    links_.append_circles({map, direction, 1}, {&attachment, 1}, 0, circles);
    return circles[0];
  }
  [[nodiscard]] LengthLimit limit(Direction direction, double length = kAnyLength) const {
    return {(direction == Direction::kFromStart ? request_.goal : request_.start).position(), length};
  }
  [[nodiscard]] Links found(const Roadmap& map, Direction direction, double length = kAnyLength) {
    Links links;
    links_.append_links({map, direction}, std::vector{circle(map, direction)}, 0, limit(direction, length), links);
    return links;
  }
  void keep(const Roadmap& map, Direction direction) {
    known_.keep({map, direction}, circle(map, direction), limit(direction), found(map, direction), 0);
  }
  bool append(const Roadmap& map, Direction direction, Links& links, double length = kAnyLength) {
    return known_.append({map, direction}, circle(map, direction), limit(direction, length), 0, links);
  }
  // Nothing else decides which path a search finds.
  [[nodiscard]] static std::vector<AttachmentLink> free_ones(const Roadmap& map, const Links& links) {
    std::vector<AttachmentLink> free;
    std::ranges::copy_if(links, std::back_inserter(free), [&](const AttachmentLink& link) {
      return map.graph->free_headings(link.circle).contains(link.line.start.heading) &&
             map.queries.sweep->straight_free({link.line.start, link.line.length, map.body});
    });
    return free;
  }
  void expect_known(const Roadmap& map, Direction direction, double length = kAnyLength) {
    Links links;
    ASSERT_TRUE(append(map, direction, links, length));
    const auto known = free_ones(map, links), anew = free_ones(map, found(map, direction, length));
    EXPECT_GT(known.size(), 0U);
    ASSERT_EQ(known.size(), anew.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      EXPECT_EQ(known[i].circle, anew[i].circle);
      EXPECT_EQ(known[i].line.start, anew[i].line.start);
      EXPECT_EQ(known[i].line.length, anew[i].line.length);
      EXPECT_EQ(known[i].turn, anew[i].turn);
    }
  }

  const World world_ =
      random_world({.kind = ClutterKind::kStar, .obstacles = 60, .vertices = 6, .fill = 0.1, .seed = 2});
  const CircleRadii radii_{1.3, 2.6, 5.2};
  const Planner planner_{world_, Vehicle{}};
  const Roadmap map_{world_, planner_.vehicle(), planner_.queries(),
                     radii_, graph_of(radii_),   std::make_shared<const Outlines>(world_)};
  const PlanRequest request_ = random_queries(world_, make_reference_queries(world_), Vehicle(), {.count = 1})[0];
  AttachmentLinks links_;
  KnownLinks known_;
};

TEST_F(KnownLinksTest, AreThoseOfTheSameGraph) {
  known_.begin();
  for (const Direction direction : {Direction::kFromStart, Direction::kToGoal}) {
    keep(map_, direction);
    expect_known(map_, direction);
  }
  EXPECT_EQ(known_.size(), 2U);
}

TEST_F(KnownLinksTest, AreNotFoundInPart) {
  const Links all = found(map_, Direction::kFromStart);
  ASSERT_GT(all.size(), 0U);
  Links links = all;
  const std::vector<AttachmentCircle> circles{circle(map_, Direction::kFromStart)};
  const auto append_until = [&](const StopClock& clock) {
    return links_.append_links({.map = map_, .direction = Direction::kFromStart, .clock = clock}, circles, 0,
                               limit(Direction::kFromStart), links);
  };
  EXPECT_FALSE(append_until(StopClock(0.0)));
  EXPECT_EQ(links.size(), all.size());
  EXPECT_TRUE(append_until(StopClock(3600.0)));
  EXPECT_EQ(links.size(), 2 * all.size());
}

TEST_F(KnownLinksTest, OfFewerRadiiAreAPartOfThem) {
  known_.begin();
  for (const Direction direction : {Direction::kFromStart, Direction::kToGoal}) {
    keep(map_, direction);
    for (const std::size_t fewer : {1, 2}) expect_known(map_of(radii_.first(fewer)), direction);
  }
}

TEST_F(KnownLinksTest, OfShorterPathsAreAPartOfThem) {
  known_.begin();
  keep(map_, Direction::kFromStart);
  Links all, near;
  ASSERT_TRUE(append(map_, Direction::kFromStart, all));
  // A limit at which the nearest circles are still within reach. It allows for their radii.
  double length = kAnyLength;
  for (const AttachmentLink& link : all) {
    const Vec2& center = map_.graph->circles()[link.circle].center;
    const Vec2 to = center - request_.start.position(), from = request_.goal.position() - center;
    length = std::min(length, to.norm() + from.norm());
  }
  ASSERT_TRUE(append(map_, Direction::kFromStart, near, length));
  EXPECT_LT(near.size(), all.size());
  expect_known(map_, Direction::kFromStart, length);
}

TEST_F(KnownLinksTest, AreNotThoseOfMoreRadii) {
  known_.begin();
  keep(map_of(radii_.first(2)), Direction::kFromStart);
  Links links;
  EXPECT_FALSE(append(map_, Direction::kFromStart, links));
  EXPECT_FALSE(append(map_of({1.3}), Direction::kToGoal, links));
  EXPECT_TRUE(links.empty());
}

TEST_F(KnownLinksTest, AreNotThoseOfOtherRadii) {
  known_.begin();
  keep(map_, Direction::kFromStart);
  Links links;
  EXPECT_FALSE(append(map_of({1.3, 2.0}), Direction::kFromStart, links));
  EXPECT_TRUE(links.empty());
}

TEST_F(KnownLinksTest, AreNotThoseOfAnotherVehicle) {
  known_.begin();
  keep(map_, Direction::kFromStart);
  const Roadmap other(world_, planner_.vehicle(), planner_.queries(), radii_, graph_of(radii_), map_.outlines);
  Links links;
  EXPECT_FALSE(append(other, Direction::kFromStart, links));
}

TEST_F(KnownLinksTest, AreNotThoseOfASlimBodyWithTheSameGaps) {
  known_.begin();
  // None: circles of links would differ.
  known_.keep({map_, Direction::kFromStart}, circle(map_, Direction::kFromStart), limit(Direction::kFromStart), {}, 0);
  VehicleParameters parameters = planner_.vehicle().parameters();
  parameters.width *= 0.9;
  const Vehicle vehicle(parameters);
  const CircleRadii fewer = radii_.first(1);
  Roadmap slim(
      world_, vehicle, planner_.queries(), fewer,
      build_feasible_graph({world_, vehicle, planner_.visibility_rows(), planner_.queries(), fewer}, SerialExecutor()),
      map_.outlines);
  slim.gaps = map_.gaps;
  Links links;
  const AttachmentCircle own = circle(map_, Direction::kFromStart);  // it may turn as far
  EXPECT_FALSE(known_.append({slim, Direction::kFromStart}, own, limit(Direction::kFromStart), 0, links));
}

TEST_F(KnownLinksTest, AreThoseOfOneDirection) {
  known_.begin();
  keep(map_, Direction::kFromStart);
  Links links;
  const AttachmentCircle own = circle(map_, Direction::kFromStart);
  EXPECT_FALSE(known_.append({map_, Direction::kToGoal}, own, limit(Direction::kFromStart), 0, links));
}

TEST_F(KnownLinksTest, AreNotKeptWhereTheyAreVeryMany) {
  known_.begin();
  const AttachmentCircle own = circle(map_, Direction::kFromStart);
  const Links many(10'000);
  known_.keep({map_, Direction::kFromStart}, own, limit(Direction::kFromStart), many, 0);
  EXPECT_EQ(known_.size(), 0U);
  known_.keep({map_, Direction::kFromStart}, own, limit(Direction::kFromStart), many, 5'000);
  EXPECT_EQ(known_.size(), 1U);
  known_.keep({map_, Direction::kFromStart}, own, limit(Direction::kFromStart), many, 5'000);
  EXPECT_EQ(known_.size(), 1U);
}

TEST_F(KnownLinksTest, AreKeptForOneQuery) {
  keep(map_, Direction::kFromStart);
  EXPECT_EQ(known_.size(), 0U);
  known_.begin();
  keep(map_, Direction::kFromStart);
  EXPECT_EQ(known_.size(), 1U);
  known_.begin();
  Links links;
  EXPECT_FALSE(append(map_, Direction::kFromStart, links));
}

}  // namespace
}  // namespace arcway::internal
