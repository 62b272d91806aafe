#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "arcway/world.h"
#include "core/base/huge_pages.h"

namespace arcway::internal {

/// Circles by the vertices that they refer to, of which few have some. Immutable.
class CirclesByVertex {
 public:
  struct Entry {
    VertexId vertex;
    std::uint32_t circle;
    /// What entries are ordered by.
    [[nodiscard]] std::pair<VertexId, std::uint32_t> key() const { return {vertex, circle}; }
  };

  /// No circles.
  CirclesByVertex() = default;
  /// @param entries   ascending.
  /// @param vertices  of the world.
  CirclesByVertex(std::vector<Entry> entries, std::size_t vertices) : entries_(std::move(entries)) {
    if (entries_.empty()) return;
    has_some_.resize(vertices / kBits + 1);
    for (const Entry& entry : entries_) has_some_[entry.vertex / kBits] |= std::uint64_t{1} << (entry.vertex % kBits);
  }

  /// All, ascending.
  [[nodiscard]] std::span<const Entry> entries() const { return entries_; }
  /// Those of a vertex, ascending. O(1) if there are none, else O(log n).
  [[nodiscard]] std::span<const Entry> of(VertexId v) const {
    if (has_some_.empty() || (has_some_[v / kBits] >> (v % kBits) & 1) == 0) return {};
    const auto first = std::ranges::lower_bound(entries_, v, {}, &Entry::vertex);
    auto last = first;
    while (last != entries_.end() && last->vertex == v) ++last;
    return {first, last};
  }

 private:
  static constexpr std::size_t kBits = 64;

  std::vector<Entry> entries_;
  HugeVector<std::uint64_t> has_some_;  // one bit a vertex; empty: none has circles
};

}  // namespace arcway::internal
