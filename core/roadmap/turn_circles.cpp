#include "core/roadmap/turn_circles.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

TurnCircles::TurnCircles(const World& world, const VisibilityRows& rows, const CircleRadii& radii,
                         const Footprint& grown_body, const Executor& executor)
    : radius_count_(radii.size()), first_(world.vertices().size(), kNone) {
  constexpr std::size_t kGrain = 256;
  const std::span<const VertexId> convex = world.convex_vertices();
  const std::size_t own = 2 * radius_count_ * convex.size();
  circles_.reserve(own + own / 8);  // for those of two vertices
  circles_.resize(own);
  executor.begin_stage("turn circles");
  executor.for_ranges(convex.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      auto c = static_cast<std::uint32_t>(2 * radius_count_ * i);
      first_[convex[i]] = c;
      for (std::size_t k = 0; k < radius_count_; ++k)
        for (const Side side : {Side::kLeft, Side::kRight})
          circles_[c++] = turn_circle(world, convex[i], radii.of(side)[k], side, grown_body);
    }
  });

  const std::size_t tightest = radii.tightest(grown_body) - 1;
  const SideRadii radius = radii[tightest];
  const auto leads_back = [&](VertexId u, VertexId w) {
    const Vec2 between = world.vertex(w) - world.vertex(u);
    return std::ranges::any_of(std::array{Side::kLeft, Side::kRight}, [&](Side side) {
      const std::size_t from = first_around(u, side) + 2 * tightest, to = first_around(w, side) + 2 * tightest;
      return (circles_[to].center - circles_[from].center).dot(between) <= 0.0;
    });
  };
  // No circle goes round two vertices that are further apart.
  const double inner = std::max(inner_side_radius(grown_body, Side::kLeft, radius.left),
                                inner_side_radius(grown_body, Side::kRight, radius.right));
  const double reach = 2.0 * inner * (1.0 + 1e-9);
  for (const auto& [u, w] : rows.pairs_within(reach, leads_back, executor)) {
    const Side side = obstacle_side(world, w, world.vertex(u));  // traveling from u to w
    if (obstacle_side(world, u, world.vertex(w)) == side) continue;
    const VertexPair pair{u, w, side};
    for (const Side turn : {Side::kLeft, Side::kRight})
      if (const auto circle = turn_circle(world, pair, radius.of(turn), turn, grown_body)) circles_.push_back(*circle);
  }
  base_count_ = first_of_gap_straights_ = circles_.size();
  group_more(own);
}

TurnCircles::TurnCircles(const TurnCircles& base, const AddedCircles& added)
    : radius_count_(base.radius_count_), first_(base.first_), base_count_(base.base_count_) {
  const auto own = static_cast<std::size_t>(std::ranges::count_if(first_, [](auto f) { return f != kNone; }));
  std::size_t count = base_count_ + added.around_vertices.size();
  for (const GapStraight& straight : added.gap_straights) count += straight.entries.size() + straight.exits.size();
  circles_.reserve(count);
  circles_ = base.circles_;
  circles_.insert(circles_.end(), added.around_vertices.begin(), added.around_vertices.end());
  first_of_gap_straights_ = circles_.size();
  for (const GapStraight& straight : added.gap_straights) {
    circles_.insert(circles_.end(), straight.entries.begin(), straight.entries.end());
    const auto exits = static_cast<std::uint32_t>(circles_.size());
    circles_.insert(circles_.end(), straight.exits.begin(), straight.exits.end());
    gap_straight_.resize(circles_.size() - first_of_gap_straights_, static_cast<std::uint32_t>(gap_straights_.size()));
    gap_straights_.push_back({exits, static_cast<std::uint32_t>(circles_.size())});
  }
  group_more(2 * radius_count_ * own);
  beside_ = vertex_buckets(first_of_gap_straights_, circles_.size(), std::array{Side::kLeft, Side::kRight});
}

// @param own  number of circles that are a vertex's own.
void TurnCircles::group_more(std::size_t own) {
  more_ = {vertex_buckets(own, first_of_gap_straights_, std::array{Side::kLeft}),
           vertex_buckets(own, first_of_gap_straights_, std::array{Side::kRight})};
}

TurnCircles::VertexBuckets TurnCircles::vertex_buckets(std::size_t first, std::size_t last,
                                                       std::span<const Side> sides) const {
  VertexBuckets result;
  result.starts.assign(first_.size() + 1, 0);
  const auto visit = [&](auto&& see) {
    for (auto c = static_cast<std::uint32_t>(first); c < last; ++c) {
      if (std::ranges::find(sides, circles_[c].side) == sides.end()) continue;
      for (const VertexId v : {circles_[c].vertex, circles_[c].second})
        if (v != kNone) see(v, c);
    }
  };
  visit([&](VertexId v, std::uint32_t) { ++result.starts[v + 1]; });
  std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
  result.circles.resize(result.starts.back());
  HugeVector<std::uint64_t> next(result.starts.begin(), result.starts.end() - 1);
  visit([&](VertexId v, std::uint32_t c) { result.circles[next[v]++] = c; });
  return result;
}

}  // namespace arcway::internal
