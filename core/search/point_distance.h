#pragma once

#include <cstdint>
#include <memory>

#include "arcway/stop_clock.h"
#include "arcway/vec2.h"
#include "arcway/visibility_query.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/attach/occlusion_horizon.h"
#include "core/base/open_list.h"
#include "core/base/paged_array.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// Shortest paths of a point among the obstacles: a lower bound on how far the reference point of a body drives that
/// covers it. A point may touch obstacles and pass between two that touch.
///
///     const PointDistance distance(world, rows_of(graph), std::make_shared<const Outlines>(world));
///     distance(start, goal, visibility, workspace);
///
/// Immutable, thread-safe.
class PointDistance {
 public:
  /// Memory of a search, used again by the next one. For one search at a time.
  class Workspace {
   private:
    friend class PointDistance;
    enum class Step : std::uint8_t {
      kFromStart,  ///< a segment from the start to a vertex, not yet asked for
      kEdge,       ///< an edge of the graph to a vertex
      kToGoal      ///< a segment from a vertex, or from the start, to the goal, not yet asked for
    };
    struct Entry {
      double estimate;  ///< of the whole path
      VertexId vertex;  ///< kNone: the start itself
      Step step;
      friend bool before(const Entry& a, const Entry& b) { return a.estimate < b.estimate; }
    };
    struct Reached {
      double length = 0.0;      ///< of the shortest path known
      VertexId parent = kNone;  ///< vertex before this one on that path; kNone: the start itself
      std::uint32_t mark = 0;   ///< the last search that came here, one more once that path is the shortest of all
    };
    void reset(std::size_t vertices);
    Reached& at(VertexId vertex);

    OpenList<Entry> open_;
    PagedArray<Reached> reached_;  // by vertex
    std::uint32_t search_ = 0;     // even
  };

  /// @param rows      of the reduced visibility graph of `world`.
  /// @param outlines  of `world`.
  PointDistance(const World& world, std::shared_ptr<const VisibilityRows> rows,
                std::shared_ptr<const Outlines> outlines);

  /// The length of the shortest path [m], up to the rounding of its sum; infinity if there is none. Precondition:
  /// neither point lies inside an obstacle. A* over the reduced graph, with the distance to the goal as heuristic. It
  /// starts from the vertices that outlines near the start do not hide, and follows edges that a taut string would
  /// take. Segments from the start and to the goal are checked when they come off the open list.
  /// @param clock  may end the search; the result is then a lower bound of the length.
  [[nodiscard]] double operator()(const Vec2& start, const Vec2& goal, const VisibilityQuery& visibility,
                                  Workspace& workspace, const StopClock& clock = {}) const;

 private:
  [[nodiscard]] OcclusionHorizon horizon_of(const Vec2& place) const;
  // Puts the segments from the start to the vertices that nothing near hides on the open list.
  void push_from_start(const Vec2& start, const Vec2& goal, Workspace& w) const;
  // Prefetches the memory that the next entries need.
  void prefetch_next(const Workspace& w) const;

  World world_;
  std::shared_ptr<const VisibilityRows> rows_;
  std::shared_ptr<const Outlines> outlines_;
};

}  // namespace arcway::internal
