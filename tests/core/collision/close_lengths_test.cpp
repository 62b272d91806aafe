#include "core/collision/close_lengths.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "tests/support/random_bodies.h"
#include "tests/support/sampled_cost.h"

namespace arcway::internal::close_lengths_test {
namespace {

PathSegment random_segment(test::RandomInputs& random, double side) {
  const Pose start{random.uniform(0, side), random.uniform(0, side), random.uniform(-4.0, 4.0)};
  const Gear gear = random.unit() < 0.5 ? Gear::kForward : Gear::kReverse;
  if (random.unit() < 0.5) return {start, random.uniform(0.0, 12.0), 0.0, gear};
  const double radius = random.uniform(1.3, 6.0), sign = random.unit() < 0.5 ? 1.0 : -1.0;
  return {start, random.uniform(0.0, 1.2 * kTwoPi * radius), sign / radius, gear};
}

// Samples in cells of one length: how much of a segment is close, and how often that changes.
struct Sampled {
  double close = 0.0;
  int changes = 0;
  double cell;
};
Sampled sampled(const PathSegment& segment, const Body& body, const World& world, int cells) {
  Sampled result{.cell = segment.length / cells};
  bool before = false;
  for (int i = 0; i < cells; ++i) {
    const test::PlacedBody placed(test::parts_of(body), segment.at((i + 0.5) * result.cell));
    const bool is_close = placed.distance_to(world) == 0.0L;
    if (is_close) result.close += result.cell;
    if (i > 0 && is_close != before) ++result.changes;
    before = is_close;
  }
  return result;
}

TEST(CloseLengths, AreThoseOfDenseSamples) {
  test::RandomInputs random(8);
  int close = 0, free = 0, mixed = 0;
  for (int i = 0; i < 120; ++i) {
    const World world = random_world({.kind = ClutterKind::kStar,
                                      .obstacles = 8,
                                      .vertices = 6,
                                      .fill = 0.15,
                                      .seed = static_cast<std::uint64_t>(i)});
    const Vehicle vehicle = i % 2 == 0 ? Vehicle() : test::random_body_vehicle(random);
    const CloseLengths close_lengths(vehicle, std::make_shared<const Outlines>(world), random.uniform(0.1, 1.0));
    const PathSegment segment = random_segment(random, world.box().max.x());
    const Sampled expected = sampled(segment, vehicle.body(close_lengths.distance()), world, 1000);
    const double found = close_lengths.on(segment);
    // A change lies anywhere within its cell, and one within a cell at each end goes unseen.
    ASSERT_NEAR(found, expected.close, (expected.changes + 2) * expected.cell) << "segment " << i;
    EXPECT_LE(found, segment.length * (1.0 + 1e-12));
    EXPECT_NEAR(close_lengths.on(segment.reversed()), found, 1e-9);
    close += found > 0.99 * segment.length ? 1 : 0;
    free += found == 0.0 ? 1 : 0;
    mixed += found > 0.0 && found < 0.99 * segment.length ? 1 : 0;
  }
  EXPECT_GT(close, 1);
  EXPECT_GT(free, 5);
  EXPECT_GT(mixed, 40);
}

TEST(CloseLengths, BesideASquareAreThoseOfTheGrownBody) {
  const World world({{test::square(10.0, -1.0, 2.0), {}}});
  const Vehicle vehicle;
  const CloseLengths close(vehicle, std::make_shared<const Outlines>(world), 0.5);
  // From where the nose comes near its left side to where the tail has left its right one.
  const double away = 1.0 + vehicle.footprint().left + 0.4;
  const PathSegment line{{0.0, away, 0.0}, 30.0, 0.0};
  EXPECT_NEAR(close.on(line), 2.0 + vehicle.footprint().length() + 2.0 * 0.5, 1e-12);
  EXPECT_EQ(close.on({{0.0, away + 0.2, 0.0}, 30.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace arcway::internal::close_lengths_test
