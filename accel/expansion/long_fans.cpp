#include "accel/expansion/long_fans.h"

#include "arcway/executor.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

LongFans::LongFans(const FreeSpaceTriangulation& triangulation, std::uint32_t least, const StopClock& clock) {
  StopTicker ticker(clock);
  const std::span<const FreeSpaceTriangulation::HalfEdge> half_edges = triangulation.half_edges();
  const auto count = static_cast<std::uint32_t>(half_edges.size());
  const auto left_end = [&](std::uint32_t half_edge) { return half_edges[Triangulation::next(half_edge)].point; };
  const auto right_end = [&](std::uint32_t half_edge) { return half_edges[Triangulation::previous(half_edge)].point; };
  std::vector<std::uint32_t> degree(triangulation.points().size(), 0);
  for (std::uint32_t half_edge = 0; half_edge < count; ++half_edge) {
    end_if_over(ticker);
    ++degree[left_end(half_edge)];
  }

  std::vector<bool> is_taken(count, false);
  std::vector<std::uint32_t> fan;
  // Follows a fan from a half-edge on, around its left end, up to the boundary or half a turn.
  const auto follow = [&](std::uint32_t half_edge) {
    while (half_edge != kNone && !is_taken[half_edge]) {
      const std::uint32_t pivot = left_end(half_edge), first_point = right_end(half_edge);
      fan.clear();
      for (; half_edge != kNone && !is_taken[half_edge]; half_edge = half_edges[half_edge].left) {
        end_if_over(ticker);
        if (orientation(triangulation.points()[pivot], triangulation.points()[first_point],
                        half_edges[half_edge].apex) <= 0)
          break;
        is_taken[half_edge] = true;
        fan.push_back(half_edge);
      }
      if (fan.empty()) return;
      if (fan.size() >= least) add_fan(triangulation, fan, ticker);
    }
  };
  const auto is_long = [&](std::uint32_t half_edge) {
    end_if_over(ticker);
    return degree[left_end(half_edge)] >= least;
  };
  for (std::uint32_t half_edge = 0; half_edge < count; ++half_edge)  // from boundary edges first
    if (is_long(half_edge) && half_edges[Triangulation::next(half_edge)].left == kNone) follow(half_edge);
  for (std::uint32_t half_edge = 0; half_edge < count; ++half_edge)
    if (is_long(half_edge)) follow(half_edge);
  if (fans_.empty()) return;
  place_.assign(count, kNone);
  for (std::uint32_t i = 0; i < half_edges_.size(); ++i) place_[half_edges_[i]] = i;
}

void LongFans::add_fan(const FreeSpaceTriangulation& triangulation, std::span<const std::uint32_t> half_edges,
                       StopTicker& ticker) {
  const Fan fan{triangulation.half_edges()[Triangulation::next(half_edges.front())].point,
                static_cast<std::uint32_t>(half_edges_.size()), static_cast<std::uint32_t>(half_edges.size()),
                static_cast<std::uint32_t>(hull_starts_.size() - 1)};
  half_edges_.insert(half_edges_.end(), half_edges.begin(), half_edges.end());
  fan_of_.insert(fan_of_.end(), half_edges.size(), static_cast<std::uint32_t>(fans_.size()));
  rim_.push_back(triangulation.half_edges()[Triangulation::previous(half_edges.front())].point);
  for (const std::uint32_t half_edge : half_edges) rim_.push_back(triangulation.half_edges()[half_edge].point);
  fans_.push_back(fan);
  add_hulls(triangulation, fans_.back(), ticker);
}

// A corner belongs to the hull that faces the pivot if it lies on the pivot's side of the line between its neighbors.
void LongFans::add_hulls(const FreeSpaceTriangulation& triangulation, const Fan& fan, StopTicker& ticker) {
  const std::span<const Vec2> points = triangulation.points();
  std::vector<std::uint32_t> chain;
  const auto append = [&](std::uint32_t point) {
    while (chain.size() >= 2 && orientation(points[chain[chain.size() - 2]], points[chain.back()], points[point]) >= 0)
      chain.pop_back();
    chain.push_back(point);
  };
  for (std::uint32_t level = 0; level < levels(fan); ++level) {
    for (std::uint32_t block = 0; block < blocks(fan, level); ++block) {
      end_if_over(ticker);
      chain.clear();
      if (level == 0) {
        for (std::uint32_t i = 0; i < kLeaf; ++i) append(point(fan, block * kLeaf + i));
      } else {
        for (const std::uint32_t half : {2 * block, 2 * block + 1})
          for (const std::uint32_t s : hull(fan, level - 1, half)) append(s);
      }
      hull_points_.insert(hull_points_.end(), chain.begin(), chain.end());
      hull_starts_.push_back(static_cast<std::uint32_t>(hull_points_.size()));
    }
  }
}

}  // namespace arcway::internal
