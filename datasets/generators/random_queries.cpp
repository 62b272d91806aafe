#include "arcway/datasets/random_queries.h"

#include <optional>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"
#include "core/base/shortest_text.h"
#include "core/gaps/bottleneck_finder.h"
#include "datasets/io/random.h"

namespace arcway {

using namespace internal;
namespace {

constexpr std::size_t kMaxDraws = 10'000;  // draws for one pair

}  // namespace

std::vector<PlanRequest> random_queries(const World& world, const QuerySet& queries, const Vehicle& vehicle,
                                        const RandomQueryParameters& parameters) {
  const Box& box = world.box();
  const Vec2 extent = box.empty() ? Vec2(0.0, 0.0) : Vec2(box.max - box.min);
  if (!(extent.minCoeff() > 0.0)) throw std::invalid_argument("random queries: the map has no extent");
  if (!(parameters.min_distance >= 0.0 && parameters.min_distance <= 1.0)) {
    throw std::invalid_argument("random queries: min_distance is " + shortest_text(parameters.min_distance) +
                                ", must be in [0, 1]");
  }
  const double apart = parameters.min_distance * extent.maxCoeff();
  const Body body = vehicle.body(vehicle.safety_margin());

  Random random(parameters.seed);
  const auto draw = [&] {
    const double x = random.uniform(box.min.x(), box.max.x());
    const double y = random.uniform(box.min.y(), box.max.y());
    return Pose{x, y, random.uniform(-kPi, kPi)};
  };
  const auto is_free = [&](const Pose& pose) { return queries.sweep->straight_free({pose, 0.0, body}); };
  std::optional<BottleneckFinder> find_bottleneck;
  if (parameters.passable) find_bottleneck.emplace(world, vehicle);
  const auto is_parted = [&](const Pose& start, const Pose& goal) {
    const auto bottleneck = find_bottleneck ? (*find_bottleneck)(start, goal) : std::nullopt;
    return bottleneck && bottleneck->too_narrow();
  };

  std::vector<PlanRequest> pairs;
  pairs.reserve(parameters.count);
  for (std::size_t draws = 0; pairs.size() < parameters.count;) {
    if (draws++ == kMaxDraws) {
      throw std::runtime_error("random queries: no free pair " + shortest_text(apart) + " m apart in " +
                               std::to_string(kMaxDraws) + " draws");
    }
    const Pose start = draw(), goal = draw();
    if ((goal.position() - start.position()).norm() < apart || !is_free(start) || !is_free(goal)) continue;
    if (is_parted(start, goal)) continue;
    pairs.push_back({.start = start, .goal = goal});
    draws = 0;
  }
  return pairs;
}

}  // namespace arcway
