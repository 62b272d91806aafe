#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arcway/vec2.h"
#include "arcway/world.h"
#include "core/base/huge_pages.h"

namespace arcway::internal {

/// A spatial index of a world's edges for the validator, which shares no tree with the planner. Cells have one size,
/// about two edges each if the edges lie all over the map. An edge is listed in each cell that it passes. Where that
/// would take more than 16 entries an edge, the longest edges are visited by every query instead. Immutable and
/// thread-safe. O(n log n).
class EdgeGrid {
 public:
  /// @param edges  must outlive this.
  explicit EdgeGrid(std::span<const LineSegment> edges);

  [[nodiscard]] std::span<const LineSegment> edges() const { return edges_; }
  /// The box of all edges [m]; empty without any.
  [[nodiscard]] const Box& box() const { return box_; }
  /// The side of a cell [m].
  [[nodiscard]] double cell() const { return cell_; }

  /// Calls visit(edge) once for each edge that meets a box, and for some others.
  template <class Visit>
  void visit_near(const Box& box, Visit&& visit) const {
    for (const VertexId e : long_) visit(e);
    if (edges_.empty() || !box.overlaps(box_)) return;
    const Cells asked = cells_of(box);
    std::vector<VertexId> near;
    for (std::uint32_t y = asked.y0; y <= asked.y1; ++y) {
      const auto first = items_.begin() + static_cast<std::ptrdiff_t>(starts_[index_of(asked.x0, y)]);
      const auto last = items_.begin() + static_cast<std::ptrdiff_t>(starts_[index_of(asked.x1, y) + 1]);
      near.insert(near.end(), first, last);
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const VertexId e : near) visit(e);
  }

 private:
  struct Cells {
    std::uint32_t x0, y0, x1, y1;
  };
  [[nodiscard]] Cells cells_of(const Box& box) const {
    return {column(box.min.x()), row(box.min.y()), column(box.max.x()), row(box.max.y())};
  }
  [[nodiscard]] std::uint32_t column(double x) const { return place((x - box_.min.x()) / cell_, columns_); }
  [[nodiscard]] std::uint32_t row(double y) const { return place((y - box_.min.y()) / cell_, rows_); }
  [[nodiscard]] static std::uint32_t place(double cells, std::uint32_t count) {
    if (!(cells > 0.0)) return 0;
    return cells < count - 1 ? static_cast<std::uint32_t>(cells) : count - 1;
  }
  [[nodiscard]] std::size_t index_of(std::uint32_t x, std::uint32_t y) const { return std::size_t{y} * columns_ + x; }
  template <class Visit>
  void visit_cells(const LineSegment& edge, Visit&& visit) const;

  std::span<const LineSegment> edges_;
  Box box_;
  double cell_ = 1.0;
  std::uint32_t columns_ = 1, rows_ = 1;
  HugeVector<std::uint64_t> starts_;  // by cell, one more
  HugeVector<VertexId> items_;
  HugeVector<VertexId> long_;
};

}  // namespace arcway::internal
