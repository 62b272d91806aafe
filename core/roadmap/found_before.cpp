#include "core/roadmap/found_before.h"

#include <algorithm>
#include <utility>

#include "core/model/world_history.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal {

namespace {

// Largest number of graphs whose findings are kept: after so many changes a search has asked again for what it needs.
// Each takes part in every question about a circle that none of them knows.
constexpr std::size_t kMostGenerations = 32;
// Largest number of circles of all of these graphs where each lists its vertices, some 4 bytes a circle; but two graphs
// are always kept.
constexpr std::size_t kMostCircles = 8'000'000;
// Largest number of boxes of changes without a search in between. One box stands for more vertices than that.
constexpr std::size_t kMostBoxes = 4096;
// Largest number of vertices of an obstacle that have one box together. A row reaches much further than an obstacle, so
// that hardly any more is forgotten. A box for each vertex took 4 of 8.5 MB that a planner in a drive keeps (`Live`).
constexpr std::size_t kVerticesOfBox = 8;

// No less than how far a body reaches from a vertex of a circle on that circle: at most an inner and an outer radius.
double largest_reach(const FeasibleGraphInputs& inputs) {
  const Footprint grown_body = inputs.vehicle.footprint(inputs.vehicle.safety_margin());
  double largest = 0.0;
  for (const Side side : {Side::kLeft, Side::kRight})
    for (const double radius : inputs.radii.of(side))
      largest = std::max(largest, 2.0 * swept_annulus(grown_body, side, radius).outer);
  return largest;
}

std::vector<Box> boxes_of(const WorldChange& change) {
  std::vector<Box> boxes = change.removed_boxes;
  boxes.insert(boxes.end(), change.added_boxes.begin(), change.added_boxes.end());
  return boxes;
}

std::vector<Box> boxes_of(const World& world, std::span<const VertexId> vertices) {
  std::vector<Box> boxes;
  std::size_t of_box = 0;
  ObstacleId obstacle = kNone;
  for (const VertexId v : vertices) {
    if (of_box == kVerticesOfBox || boxes.empty() || world.obstacle_of(v) != obstacle) {
      boxes.emplace_back();
      of_box = 0;
      obstacle = world.obstacle_of(v);
    }
    boxes.back().extend(world.vertex(v));
    ++of_box;
  }
  boxes.shrink_to_fit();
  return boxes;
}

// One box around all of them if they are many.
std::vector<Box> few(std::vector<Box> boxes) {
  if (boxes.size() <= kMostBoxes / 2) return boxes;
  Box all;
  for (const Box& box : boxes) {
    all.extend(box.min);
    all.extend(box.max);
  }
  return {all};
}

void append(const std::vector<Box>& more, std::vector<Box>& boxes) {
  boxes.insert(boxes.end(), more.begin(), more.end());
}

}  // namespace

FoundBefore::FoundBefore(const LazyFeasibleGraph& before, const FeasibleGraphInputs& inputs, const CircleChecks& after,
                         const WorldChange& change, std::span<const VertexId> may_differ)
    : after_(after) {
  const VertexMap map(change);
  std::vector<Box> obstacles = boxes_of(change), vertices = boxes_of(after.world(), may_differ);
  if (before.found_before()) generations_ = before.found_before()->generations_;
  for (Generation& generation : generations_) generation.map = generation.map.then(map);
  if (!before.found()->empty()) {
    auto numbers =
        std::make_shared<const CircleNumbers>(before.checks().world(), before.turn_circles(), after.world().history());
    generations_.insert(generations_.begin(), {before.found(), std::move(numbers), map, nullptr});
  } else if (!generations_.empty()) {
    append(generations_.front().places->obstacles(), obstacles);
    append(generations_.front().places->vertices(), vertices);
  }
  if (generations_.empty()) return;
  generations_.front().places =
      std::make_shared<const Places>(std::move(obstacles), few(std::move(vertices)), largest_reach(inputs));
  const bool shares_lists = after.world().history().convex_of_origin() != nullptr;
  const std::size_t circles = std::max<std::size_t>(1, after.circles().all().size());
  std::size_t most =
      shares_lists ? kMostGenerations : std::clamp<std::size_t>(kMostCircles / circles, 2, kMostGenerations);
  if (generations_.front().places->size() > kMostBoxes) most = 0;
  if (generations_.size() > most)
    generations_.erase(generations_.begin() + static_cast<std::ptrdiff_t>(most), generations_.end());
}

const HeadingSet* FoundBefore::headings(std::uint32_t circle) const {
  const Vec2& vertex = after_.world().vertex(after_.circles().all()[circle].vertex);
  for (const Generation& generation : generations_) {
    if (generation.places->may_meet_obstacle(Box{vertex, vertex})) return nullptr;
    const std::uint32_t was = before(generation, circle);
    if (const HeadingSet* known = was == kNone ? nullptr : generation.found->headings.find(was)) return known;
  }
  return nullptr;
}

std::optional<CheckedRow> FoundBefore::row(std::uint32_t circle) const {
  for (auto at = generations_.begin(); at != generations_.end(); ++at) {
    const std::uint32_t was = before(*at, circle);
    const FoundLinks::Row* known = was == kNone ? nullptr : at->found->rows.find(was);
    if (!known || known->around.empty()) continue;
    const bool holds = std::none_of(generations_.begin(), at + 1,
                                    [&](const Generation& later) { return later.places->may_meet(known->around); });
    if (!holds) return std::nullopt;
    CheckedRow row = known->checked();
    for (FeasibleLink& link : row.row.links) {
      link.from = circle;
      link.to = at->numbers->after(link.to, after_.circles(), at->map);
    }
    return row;
  }
  return std::nullopt;
}

}  // namespace arcway::internal
