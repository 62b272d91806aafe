#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/base/spare.h"
#include "core/geometry/box_tree.h"
#include "core/model/world_history.h"

namespace arcway {

namespace internal {
class VertexMap;
}

/// What a world holds, in arrays by vertex and by region, and what makes it. world_data.cpp builds regions,
/// world_covered.cpp finds the vertices inside others, obstacle_change.h and changed_world.cpp make one world of
/// another.
struct World::Data {
  template <class Value>
  using HugeVector = internal::HugeVector<Value>;
  template <class Value>
  using Spare = internal::Spare<Value>;
  using BoxTree = internal::BoxTree;
  using VertexMap = internal::VertexMap;
  using WorldHistory = internal::WorldHistory;

  HugeVector<Vec2> vertices;
  HugeVector<LineSegment> edges;
  HugeVector<VertexId> next;
  HugeVector<VertexId> previous;
  HugeVector<ObstacleId> obstacle_of;
  std::vector<bool> convex;
  std::vector<bool> covered;
  std::size_t graph_vertex_count = 0;
  // Lists the graph vertices when it is first asked for them.
  struct GraphVertices {
    std::once_flag listed;
    HugeVector<VertexId> all;
  };
  std::unique_ptr<GraphVertices> graph_vertices = std::make_unique<GraphVertices>();
  std::vector<SelfContact> contacts;            // ascending by edge
  std::vector<SelfContact> contacts_by_vertex;  // all contacts, ascending by vertex
  std::vector<VertexId> region_starts{0};       // one more than regions
  std::vector<VertexId> ring_starts;
  std::vector<std::size_t> region_rings{0};  // into ring_starts, one more than regions
  std::vector<Box> boxes;
  Box box;
  bool has_bounds = false;
  std::optional<ObstacleKey> next_key;  // of the next obstacle that is added; none: keys are ids, nothing was removed
  std::vector<ObstacleKey> keys;        // of the obstacles, ascending, where they are no ids
  std::vector<std::uint64_t> stamps;    // one a region: regions of equal stamps are the same, in all worlds
  WorldHistory history;                 // from the first world of its origin
  // What all worlds have in common that come from one by changes.
  struct Origin {
    Spare<Data> spare;
    std::once_flag indexed;
    BoxTree obstacles;                                   // of the first world, without its bounds
    std::vector<VertexId> first_vertex;                  // of each of these obstacles
    std::shared_ptr<const HugeVector<VertexId>> convex;  // convex vertices of the first world, covered or not
  };
  std::shared_ptr<Origin> origin = std::make_shared<Origin>();

  // Questions.

  [[nodiscard]] ObstacleId obstacle_count() const {
    return static_cast<ObstacleId>(boxes.size() - (has_bounds ? 1 : 0));
  }
  [[nodiscard]] bool is_bounds(ObstacleId region) const { return has_bounds && region + 1 == boxes.size(); }
  [[nodiscard]] ObstacleKey key_of(ObstacleId o) const { return next_key ? keys[o] : o; }
  [[nodiscard]] bool is_graph_vertex(VertexId v) const { return convex[v] && !covered[v]; }
  /// All of them, ascending. O(vertices) the first time.
  [[nodiscard]] std::span<const VertexId> listed_graph_vertices() const;
  /// How many of some ranges are graph vertices.
  [[nodiscard]] std::size_t count_graph_vertices(std::span<const VertexRange> ranges) const;
  /// The place among a region's rings, as seen from the region's side of them.
  [[nodiscard]] PointLocation side_of(PointLocation in_rings, ObstacleId region) const {
    if (!is_bounds(region) || in_rings == PointLocation::kBoundary) return in_rings;
    return in_rings == PointLocation::kInside ? PointLocation::kOutside : PointLocation::kInside;
  }
  [[nodiscard]] PointLocation locate(const Vec2& p, ObstacleId region) const;
  /// The regions whose boxes meet one of some places, ascending.
  [[nodiscard]] std::vector<ObstacleId> regions_meeting(std::span<const Box> places) const;

  // What builds a world, region by region.

  /// Vertices inside an edge of their own region, whichever of its sides their ring is on.
  struct Touches {
    std::vector<SelfContact> on_left;
    std::vector<VertexId> on_right;  // the vertices; ascending
  };
  void reserve(std::size_t vertex_count);
  void add_region(const Polygon& polygon, std::span<const RingContact> ring_contacts, bool is_bounds, Touches& touches);
  void add_ring(const Ring& ring, int wanted_winding);
  /// All vertices and rings since the last region are one.
  void close_region(const Box& region_box);
  /// Links coincident vertices of new regions, and appends contacts, which must be sorted then.
  void connect(VertexId first_vertex, Touches touches);
  /// Where rings touch in a vertex, an edge that ends there is linked to the edge that bounds the same wedge of the
  /// interior: the first one clockwise from it. Each of the coincident vertices then has a wedge of its own, and all
  /// wedges are disjoint. An edge that passes between them separates the vertices on its two sides.
  void relink_pinches(VertexId first_vertex, std::span<const VertexId> on_right_of_edges);
  /// Appends the links (previous, vertex) of coincident vertices.
  void append_links(std::span<const VertexId> pinch, std::vector<std::pair<VertexId, VertexId>>& links) const;
  void sort_contacts();
  /// What follows at once from vertices and links, for all vertices that have no edges yet.
  void derive_edges();

  // Which vertices lie inside of a region.

  void mark_all_covered();
  /// Decides which of these vertices are covered.
  /// @param regions  all that may cover one of them.
  void mark_covered(std::span<const VertexId> which, std::span<const ObstacleId> regions);
  /// Marks those of the vertices that lie strictly inside one of the regions.
  /// @param most  how many edges may be looked at, about; then it ends and returns false.
  bool mark_inside(std::span<const ObstacleId> regions, std::span<const VertexId> which, std::size_t most);
  /// The vertices asked about, in stretches of some that follow each other in a region.
  struct Stretches {
    std::vector<std::size_t> starts;  // in what is asked, one more than stretches
    HugeVector<Box> boxes;
  };
  /// Groups vertices that are near each other, as their boxes are to be about as small as points.
  [[nodiscard]] Stretches stretches_of(std::span<const VertexId> which) const;
  /// Where points lie in one region, many of them.
  struct RegionSearch;

  // What makes one world of another.

  /// Gives its arrays to the next change when it is gone.
  static std::shared_ptr<const Data> shared(std::unique_ptr<Data> data);
  /// Begins a new origin.
  void begin_history();
  /// Precondition: this is the first world of the origin, or another one was indexed before.
  void index_obstacles() const;
  struct Change;
  /// What a change of another world begins with: arrays of a world that is gone, with the first obstacles that there
  /// will be. No obstacles if they differ in many: copies are made faster than coverage is looked at again.
  /// @param places  becomes the boxes of obstacles that only one of these two worlds has.
  static std::unique_ptr<Data> begin_change(const Data& old, const Change& change, std::vector<Box>& places);
  /// One obstacle after a change, alone.
  static Data region_after(const Data& old, const Change& change, ObstacleId o);
  /// Whether an obstacle has as many vertices in each ring as the only one of another world.
  [[nodiscard]] bool has_rings_of(ObstacleId o, const Data& region) const;
  /// Puts the only obstacle of another world in the place of one that has as many vertices in each ring.
  void overwrite(ObstacleId o, const Data& region);
  /// Makes this, of the same origin, have the first obstacles of a world after a change, as many as fit where others
  /// are. All others are left out.
  void overwrite_others(const Data& old, const Change& change);
  /// Appends what this has not yet of a world after a change.
  void append_rest(const Data& old, const Change& change);
  /// @param id  of the first one, for errors.
  void add_obstacles(std::span<const Polygon> polygons, ObstacleId id);
  /// Appends the boxes of obstacles that this world has and another one of its origin has not.
  void append_others(const Data& other, std::vector<Box>& places) const;
  /// Keeps the first regions only. Their vertices may be covered by others than before.
  void truncate(std::size_t regions);
  /// The box of what is left of a world without some obstacles.
  [[nodiscard]] Box box_without(std::span<const ObstacleId> removed) const;
  /// Regions [begin, end) of another world, after the last one of this one, with all that is known about them.
  void copy_regions(const Data& from, ObstacleId begin, ObstacleId end);
  /// Takes the keys of obstacles of another world, and gives new ones to those that follow them all. Those that there
  /// are already are right.
  void take_keys(const Data& from, const Change& change);
  /// Decides which vertices are covered after a change, and returns those for which that is another answer than before.
  /// @param places  boxes of obstacles that were removed or added.
  /// @param change  from `old`.
  std::vector<VertexId> update_covered(const std::vector<Box>& places, const Data& old, const VertexMap& change);
  /// Completes this after a change of another world: coverage, the number of graph vertices and the history.
  /// @param places  boxes of obstacles that were removed or added, or that only the world had whose arrays these were.
  void follow(const Data& old, const VertexMap& change, const std::vector<Box>& places);

  /// A number that no region and no origin has yet.
  static std::uint64_t next_stamp();
};

}  // namespace arcway
