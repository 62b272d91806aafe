#include "core/geometry/inscribed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

constexpr double kPrecision = 1e-3;  // share of the radius: discs larger by less than this are not searched for
constexpr int kMostCells = 20000;    // number of cells after which the search for a larger disc ends
constexpr double kRounding = 1e-12;  // by which share of the extent results are made smaller: more than rounding
constexpr int kHeights = 24;         // number of steps between the lowest and the highest vertex
constexpr int kCells = 4;            // number of cells along either axis to begin with

LineSegment side_of(std::span<const Vec2> ring, std::size_t i) { return {ring[i], ring[(i + 1) % ring.size()]}; }

Box bounds_of(std::span<const Vec2> ring) {
  Box box;
  for (const Vec2& p : ring) box.extend(p);
  return box;
}

// Distance of a point from the ring, negative outside of it.
double depth_in(std::span<const Vec2> ring, const Vec2& p) {
  double least = distance(p, side_of(ring, 0));
  for (std::size_t i = 1; i < ring.size(); ++i) least = std::min(least, distance(p, side_of(ring, i)));
  return locate(p, ring) == PointLocation::kInside ? least : -least;
}

struct Cell {
  Vec2 middle;
  Vec2 half;
  double depth;  // of the middle
  [[nodiscard]] double most() const { return depth + half.norm(); }
  bool operator<(const Cell& other) const { return most() < other.most(); }
};

// The widest range of x in which no side reaches into the open strip low < y < high, inside the ring.
std::pair<double, double> widest_in_strip(std::span<const Vec2> ring, double low, double high) {
  std::vector<std::pair<double, double>> taken;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LineSegment side = side_of(ring, i);
    const Vec2 &a = side.a, &b = side.b;
    if (std::max(a.y(), b.y()) <= low || std::min(a.y(), b.y()) >= high) continue;
    const auto x_at = [&](double y) {
      return std::lerp(a.x(), b.x(), std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0));
    };
    const bool is_level = a.y() == b.y();
    const double one = is_level ? a.x() : x_at(low), two = is_level ? b.x() : x_at(high);
    taken.emplace_back(std::min(one, two), std::max(one, two));
  }
  std::sort(taken.begin(), taken.end());
  std::pair<double, double> widest{0.0, 0.0};
  double end = taken.empty() ? 0.0 : taken.front().second;
  for (const auto& [from, to] : taken) {
    const bool is_wider = from - end > widest.second - widest.first;
    if (is_wider && locate(Vec2(0.5 * (end + from), 0.5 * (low + high)), ring) == PointLocation::kInside)
      widest = {end, from};
    end = std::max(end, to);
  }
  return widest;
}

}  // namespace

InscribedDisc largest_disc_in(std::span<const Vec2> ring, const Vec2& inside) {
  const Box box = bounds_of(ring);
  const Vec2 extent = box.max - box.min;
  const auto cell = [&](const Vec2& middle, const Vec2& half) { return Cell{middle, half, depth_in(ring, middle)}; };
  std::priority_queue<Cell> open;
  const Vec2 half = extent / (2.0 * kCells);
  Cell best = cell(inside, Vec2::Zero());
  const auto add = [&](const Cell& next) {
    if (next.depth > best.depth) best = next;
    open.push(next);
  };
  for (int i = 0; i < kCells * kCells; ++i) {
    const Vec2 index(i % kCells, static_cast<double>(i / kCells));
    add(cell(box.min + (2.0 * index + Vec2::Ones()).cwiseProduct(half), half));
  }
  for (int cells = 0; cells < kMostCells && open.top().most() > (1.0 + kPrecision) * best.depth; ++cells) {
    const Cell wide = open.top();
    open.pop();
    const Vec2 quarter = 0.5 * wide.half;
    for (const Vec2& way : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
      add(cell(wide.middle + way.cwiseProduct(quarter), quarter));
  }
  return {best.middle, std::max(0.0, best.depth - kRounding * extent.norm())};
}

Box large_box_in(std::span<const Vec2> ring) {
  const Box box = bounds_of(ring);
  std::vector<double> heights;
  for (const Vec2& p : ring) heights.push_back(p.y());
  for (int i = 1; i < kHeights; ++i)
    heights.push_back(std::lerp(box.min.y(), box.max.y(), static_cast<double>(i) / kHeights));
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  Box best;
  double most = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    for (std::size_t j = i + 1; j < heights.size(); ++j) {
      const auto [from, to] = widest_in_strip(ring, heights[i], heights[j]);
      const double area = (to - from) * (heights[j] - heights[i]);
      if (area <= most) continue;
      most = area;
      best = {{from, heights[i]}, {to, heights[j]}};
    }
  }
  if (best.empty()) return best;
  best = best.grown(-kRounding * (box.max - box.min).norm());
  return best.min.y() < best.max.y() ? best : Box();
}

}  // namespace arcway::internal
