#include "core/validate/edge_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace arcway::internal {

namespace {

constexpr double kEdgesPerCell = 2.0;
constexpr double kMostColumns = 16384.0;
constexpr std::uint64_t kMostEntries = 16;  // average number of cells of an edge, at most
constexpr double kMargin = 1e-6;            // distance within which an edge passes a cell, in cells: more than rounding

// Number of cells of an edge up to which the lists of all cells stay within their limit. Edges that pass more are long.
std::uint64_t most_cells(std::vector<std::uint64_t> counts) {
  std::sort(counts.begin(), counts.end());
  std::uint64_t left = kMostEntries * counts.size();
  for (const std::uint64_t count : counts) {
    if (count > left) return count - 1;
    left -= count;
  }
  return counts.back();
}

}  // namespace

EdgeGrid::EdgeGrid(std::span<const LineSegment> edges) : edges_(edges) {
  if (edges.empty()) return;
  for (const LineSegment& edge : edges) box_.extend(arcway::box_of(edge));
  const Vec2 size = box_.max - box_.min;
  const double cells = std::max(1.0, static_cast<double>(edges.size()) / kEdgesPerCell);
  cell_ = std::max(std::sqrt(size.x() / cells) * std::sqrt(size.y()), size.maxCoeff() / std::min(cells, kMostColumns));
  if (!(cell_ > 0.0)) cell_ = 1.0;
  columns_ = place(size.x() / cell_, 1u << 15) + 1;
  rows_ = place(size.y() / cell_, 1u << 15) + 1;

  std::vector<std::uint64_t> counts(edges.size(), 0);
  for (VertexId e = 0; e < edges.size(); ++e) visit_cells(edges[e], [&](std::size_t) { ++counts[e]; });
  const std::uint64_t most = most_cells(counts);
  starts_.assign(std::size_t{columns_} * rows_ + 1, 0);
  for (VertexId e = 0; e < edges.size(); ++e) {
    if (counts[e] > most) {
      long_.push_back(e);
    } else {
      visit_cells(edges[e], [&](std::size_t c) { ++starts_[c]; });
    }
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  items_.resize(starts_.back());
  for (VertexId e = static_cast<VertexId>(edges.size()); e-- > 0;)
    if (counts[e] <= most) visit_cells(edges[e], [&](std::size_t c) { items_[--starts_[c]] = e; });
}

// Row by row those between the places where the edge comes and goes, none twice.
template <class Visit>
void EdgeGrid::visit_cells(const LineSegment& edge, Visit&& visit) const {
  const Cells own = cells_of(arcway::box_of(edge));
  const Vec2 a = (edge.a - box_.min) / cell_, along = (edge.b - edge.a) / cell_;
  for (std::uint32_t y = own.y0; y <= own.y1; ++y) {
    double t0 = 0.0, t1 = 1.0;
    if (along.y() != 0.0) {
      t0 = (y - kMargin - a.y()) / along.y();
      t1 = (y + 1.0 + kMargin - a.y()) / along.y();
    }
    const double x0 = a.x() + std::clamp(std::min(t0, t1), 0.0, 1.0) * along.x();
    const double x1 = a.x() + std::clamp(std::max(t0, t1), 0.0, 1.0) * along.x();
    const std::uint32_t first = std::max(own.x0, place(std::min(x0, x1) - kMargin, columns_));
    const std::uint32_t last = std::min(own.x1, place(std::max(x0, x1) + kMargin, columns_));
    for (std::uint32_t x = first; x <= last; ++x) visit(index_of(x, y));
  }
}

}  // namespace arcway::internal
