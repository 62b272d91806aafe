#include "core/validate/edge_grid.h"

#include <cmath>
#include <numeric>

namespace arcway {

namespace {

constexpr double kEdgesPerCell = 2.0;
constexpr double kMostColumns = 16384.0;
constexpr std::uint64_t kMostCells = 16;  // of an edge that is not long

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

  starts_.assign(std::size_t{columns_} * rows_ + 1, 0);
  for (const LineSegment& edge : edges) visit_cells(edge, [&](std::size_t c) { ++starts_[c]; });
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  items_.resize(starts_.back());
  for (VertexId e = static_cast<VertexId>(edges.size()); e-- > 0;) {
    bool is_short = false;
    visit_cells(edges[e], [&](std::size_t c) {
      items_[--starts_[c]] = e;
      is_short = true;
    });
    if (!is_short) long_.push_back(e);
  }
}

// None of a long edge.
template <class Visit>
void EdgeGrid::visit_cells(const LineSegment& edge, Visit&& visit) const {
  const Cells own = cells_of(arcway::box_of(edge));
  const std::uint64_t count = std::uint64_t{own.x1 - own.x0 + 1} * (own.y1 - own.y0 + 1);
  if (count > kMostCells) return;
  for (std::uint32_t y = own.y0; y <= own.y1; ++y)
    for (std::uint32_t x = own.x0; x <= own.x1; ++x) visit(index_of(x, y));
}

}  // namespace arcway
