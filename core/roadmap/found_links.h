#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "arcway/heading_set.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/link_rows.h"
#include "core/roadmap/slot_cache.h"

namespace arcway::internal {

/// What a lazy graph has found, by circle. Graphs after changes share it. Thread-safe.
struct FoundLinks {
  /// Links that leave a circle. Each is decided when it is first asked for.
  struct Row {
    Row(LinkRow r, const Box& box) : row(std::move(r)), around(box), verdicts(row.links.size()) {}
    explicit Row(CheckedRow known);
    [[nodiscard]] CheckedRow checked() const;

    LinkRow row;
    Box around;  ///< see CircleChecks::departures
    mutable std::vector<std::atomic<LinkVerdict>> verdicts;
  };

  explicit FoundLinks(std::size_t circles) : headings(circles), rows(circles) {}

  /// Whether nothing has been found.
  [[nodiscard]] bool empty() const;

  SlotCache<HeadingSet> headings;
  SlotCache<Row> rows;
};

}  // namespace arcway::internal
