#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "arcway/heading_set.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
#include "core/geometry/near_boxes.h"
#include "core/model/vertex_map.h"
#include "core/roadmap/circle_checks.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/feasible_graph_inputs.h"

namespace arcway::internal {

/// What a lazy graph before a change of the world has found that still holds, by circles after the change. It asks for
/// no rows of the reduced graph. A row of links holds where no vertex in its box may have other neighbors, and the box
/// meets no place of a removed or added obstacle. Thread-safe.
class FoundBefore {
 public:
  /// @param inputs, after  of the world after the change; `after` must outlive this.
  /// @param may_differ  see VisibilityRows::Changed.
  // Many parameters because it joins two worlds.
  FoundBefore(std::shared_ptr<const FeasibleGraph> before, const FeasibleGraphInputs& inputs, const CircleChecks& after,
              const WorldChange& change, std::span<const VertexId> may_differ);

  /// The free headings of a circle; null if they are not known.
  [[nodiscard]] const HeadingSet* headings(std::uint32_t circle) const;
  /// The links that leave a circle; nothing if they are not known.
  [[nodiscard]] std::optional<CheckedRow> row(std::uint32_t circle) const;
  /// Number of graphs that this keeps alive: `before`, and those that it knows from.
  [[nodiscard]] std::size_t graphs() const { return graphs_; }

 private:
  // The index that a circle had, or that it has now; kNone if there is none.
  [[nodiscard]] std::uint32_t before_of(std::uint32_t circle) const;
  [[nodiscard]] std::uint32_t after_of(std::uint32_t circle_before) const;

  std::shared_ptr<const FeasibleGraph> before_;
  std::size_t graphs_;
  const CircleChecks& after_;
  VertexMap map_;
  NearBoxes places_;     // where obstacles were added or removed, and as far as a body reaches from there
  NearBoxes differing_;  // vertices that may have other neighbors
};

}  // namespace arcway::internal
