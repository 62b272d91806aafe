#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arcway/heading_set.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
#include "core/geometry/near_boxes.h"
#include "core/model/vertex_map.h"
#include "core/roadmap/circle_checks.h"
#include "core/roadmap/circle_numbers.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/feasible_graph_inputs.h"
#include "core/roadmap/found_links.h"

namespace arcway::internal {

class LazyFeasibleGraph;

/// What lazy graphs before changes of the world have found that still holds, by circles after the changes. It asks for
/// no rows of the reduced graph. A row of links holds where no vertex in its box may have other neighbors, and the box
/// meets no place of a removed or added obstacle. It keeps what the graphs have found, but not the graphs. What only
/// graphs of many changes ago have found is forgotten. Thread-safe.
class FoundBefore {
 public:
  /// @param inputs, after  of the world after the change; `after` must outlive this.
  /// @param may_differ  see VisibilityRows::Changed.
  FoundBefore(const LazyFeasibleGraph& before, const FeasibleGraphInputs& inputs, const CircleChecks& after,
              const WorldChange& change, std::span<const VertexId> may_differ);

  /// The free headings of a circle; null if they are not known.
  [[nodiscard]] const HeadingSet* headings(std::uint32_t circle) const;
  /// The links that leave a circle; nothing if they are not known.
  [[nodiscard]] std::optional<CheckedRow> row(std::uint32_t circle) const;
  /// Number of graphs whose findings this keeps.
  [[nodiscard]] std::size_t graphs() const { return generations_.size(); }

 private:
  // Where some changes of the world may have made a difference.
  class Places {
   public:
    Places(std::vector<Box> obstacles, std::vector<Box> vertices, double reach)
        : obstacles_(std::move(obstacles)),
          vertices_(std::move(vertices)),
          near_(obstacles_, reach),
          differing_(vertices_) {}

    [[nodiscard]] bool may_meet_obstacle(const Box& box) const { return near_.may_meet(box); }
    [[nodiscard]] bool may_meet(const Box& box) const { return near_.may_meet(box) || differing_.may_meet(box); }
    [[nodiscard]] std::size_t size() const { return obstacles_.size() + vertices_.size(); }
    [[nodiscard]] const std::vector<Box>& obstacles() const { return obstacles_; }
    [[nodiscard]] const std::vector<Box>& vertices() const { return vertices_; }

   private:
    std::vector<Box> obstacles_;  // removed or added
    std::vector<Box> vertices_;   // that may have other neighbors
    NearBoxes near_;              // as far as a body reaches from the obstacles
    NearBoxes differing_;
  };
  // What one graph has found.
  struct Generation {
    std::shared_ptr<const FoundLinks> found;
    std::shared_ptr<const CircleNumbers> numbers;
    VertexMap map;                         // to the world after all changes
    std::shared_ptr<const Places> places;  // of the changes up to the next generation
  };
  [[nodiscard]] std::uint32_t before(const Generation& generation, std::uint32_t circle) const {
    return generation.numbers->before(circle, after_.circles(), generation.map);
  }

  const CircleChecks& after_;
  std::vector<Generation> generations_;  // the latest first
};

}  // namespace arcway::internal
