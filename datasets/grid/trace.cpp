#include "datasets/grid/trace.h"

#include <algorithm>
#include <numeric>

namespace arcway::internal {
namespace {

/// Blocked cells [first, last) of a row, free on either side.
struct Run {
  std::int32_t first, last;
};

class Tracer {
 public:
  Tracer(const OccupancyGrid& grid, bool unknown_is_free)
      : width_(static_cast<std::int32_t>(grid.width)), height_(static_cast<std::int32_t>(grid.height)) {
    row_starts_.reserve(grid.height + 1);
    for (std::size_t y = 0; y < grid.height; ++y) {
      row_starts_.push_back(runs_.size());
      for (std::size_t x = 0; x < grid.width;) {
        const auto blocked = [&] {
          const Cell cell = grid.at(x, y);
          return cell == Cell::kOccupied || (cell == Cell::kUnknown && !unknown_is_free);
        };
        if (!blocked()) {
          ++x;
          continue;
        }
        const auto first = static_cast<std::int32_t>(x);
        while (x < grid.width && blocked()) ++x;
        runs_.push_back({first, static_cast<std::int32_t>(x)});
      }
    }
    row_starts_.push_back(runs_.size());
  }

  std::vector<CornerPolygon> trace() {
    join_runs();
    std::vector<CornerPolygon> polygons;
    constexpr std::size_t kNew = SIZE_MAX;
    std::vector<std::size_t> polygon_of(runs_.size(), kNew);  // by representative
    left_done_.assign(runs_.size(), false);
    // The first run of an obstacle is a lowest one, so that its left side is on the outer ring. Every ring goes down
    // along the left side of some run.
    for (std::int32_t y = 0; y < height_; ++y) {
      for (std::size_t r = row_starts_[y]; r < row_starts_[y + 1]; ++r) {
        if (left_done_[r]) continue;
        std::size_t& polygon = polygon_of[find(r)];
        if (polygon == kNew) {
          polygon = polygons.size();
          polygons.emplace_back();
        }
        polygons[polygon].push_back(follow({runs_[r].first, y + 1}));
      }
    }
    return polygons;
  }

 private:
  // The run of a cell, or the number of runs if it is free or outside.
  [[nodiscard]] std::size_t run_at(std::int32_t x, std::int32_t y) const {
    if (y < 0 || y >= height_ || x < 0 || x >= width_) return runs_.size();
    const auto begin = runs_.begin() + static_cast<std::ptrdiff_t>(row_starts_[y]);
    const auto end = runs_.begin() + static_cast<std::ptrdiff_t>(row_starts_[y + 1]);
    const auto after =
        std::upper_bound(begin, end, x, [](std::int32_t column, const Run& run) { return column < run.first; });
    if (after == begin || x >= std::prev(after)->last) return runs_.size();
    return static_cast<std::size_t>(std::prev(after) - runs_.begin());
  }
  [[nodiscard]] bool blocked(std::int32_t x, std::int32_t y) const { return run_at(x, y) < runs_.size(); }

  // Runs of one obstacle get the same representative: the first of them.
  void join_runs() {
    parent_.resize(runs_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::int32_t y = 1; y < height_; ++y) {
      std::size_t below = row_starts_[y - 1];
      for (std::size_t r = row_starts_[y]; r < row_starts_[y + 1]; ++r) {
        while (below < row_starts_[y] && runs_[below].last < runs_[r].first) ++below;
        // The last one that touches this run may touch the next one as well.
        for (std::size_t b = below; b < row_starts_[y] && runs_[b].first <= runs_[r].last; ++b) {
          const std::size_t u = find(b), v = find(r);
          parent_[std::max(u, v)] = std::min(u, v);
        }
      }
    }
  }
  std::size_t find(std::size_t r) {
    while (parent_[r] != r) r = parent_[r] = parent_[parent_[r]];
    return r;
  }

  // The ring that goes down from this corner, blocked cells on its left.
  CornerRing follow(Corner start) {
    CornerRing ring;
    Corner at = start;
    std::int32_t dx = 0, dy = -1;
    do {
      if (dy == -1) left_done_[run_at(at.x, at.y - 1)] = true;
      at = {at.x + dx, at.y + dy};
      // The cells ahead to the left and to the right: the lower left corner of each is known by the direction.
      const std::int32_t lx = at.x + (dx - dy - 1) / 2, ly = at.y + (dy + dx - 1) / 2;
      const std::int32_t rx = at.x + (dx + dy - 1) / 2, ry = at.y + (dy - dx - 1) / 2;
      if (blocked(rx, ry)) {
        ring.push_back(at);
        const std::int32_t old = dx;
        dx = dy, dy = -old;
      } else if (!blocked(lx, ly)) {
        ring.push_back(at);
        const std::int32_t old = dx;
        dx = -dy, dy = old;
      }
    } while (!(at == start && dx == 0 && dy == -1));
    return ring;
  }

  std::int32_t width_, height_;
  std::vector<Run> runs_;
  std::vector<std::size_t> row_starts_;  // one more than rows
  std::vector<std::size_t> parent_;
  std::vector<bool> left_done_;
};

}  // namespace

std::vector<CornerPolygon> trace_blocked(const OccupancyGrid& grid, bool unknown_is_free) {
  return Tracer(grid, unknown_is_free).trace();
}

}  // namespace arcway::internal
