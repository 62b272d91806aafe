#include "arcway/world.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "arcway/world_change.h"
#include "core/base/huge_pages.h"
#include "core/base/spare.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/ray_parity.h"
#include "core/model/world_checks.h"
#include "core/model/world_coverage.h"
#include "core/model/world_history.h"
#include "core/model/world_zones.h"

namespace arcway {

using namespace internal;
namespace {

// Number of vertices up to which a scan of all edges is faster than a tree over them.
constexpr std::size_t kScanVertices = 64;
// Edges examined region by region, per vertex, after which one sweep over all edges takes over.
constexpr std::size_t kRegionPatience = 128;
// Share of the obstacles that may differ, beside some of any world, where a change takes the arrays of a world that is
// gone, or the index of regions of a world before. It looks again which vertices near these obstacles are covered, and
// at each added one whenever regions are looked up.
constexpr std::size_t kMostOthersOf = 8;
constexpr std::size_t kOthersOfAny = 64;

bool are_few(std::size_t obstacles, std::size_t of) { return obstacles * kMostOthersOf <= of + kOthersOfAny; }

std::size_t vertex_count_of(const std::vector<Polygon>& polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

// A number that no region has yet.
std::uint64_t next_stamp() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

struct World::Data {
  HugeVector<Vec2> vertices;
  HugeVector<LineSegment> edges;
  HugeVector<VertexId> next;
  HugeVector<VertexId> previous;
  HugeVector<ObstacleId> obstacle_of;
  std::vector<bool> convex;
  std::vector<bool> covered;
  HugeVector<VertexId> convex_vertices;
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
    std::shared_ptr<const HugeVector<VertexId>> convex;  // graph vertices of the first world
  };
  std::shared_ptr<Origin> origin = std::make_shared<Origin>();

  // Gives its arrays to the next change when it is gone.
  static std::shared_ptr<const Data> shared(std::unique_ptr<Data> data) {
    return {data.release(), [](Data* gone) {
              const std::shared_ptr<Origin> receiver = std::move(gone->origin);
              receiver->spare.give(std::unique_ptr<Data>(gone));
            }};
  }

  // Begins a new origin.
  void begin_history() {
    history = WorldHistory(next_stamp(), region_starts[obstacle_count()]);
    origin = std::make_shared<Origin>();
  }

  // Precondition: this is the first world of the origin, or another one was indexed before.
  void index_obstacles() const {
    std::call_once(origin->indexed, [this] {
      origin->convex = std::make_shared<const HugeVector<VertexId>>(convex_vertices);
      if (obstacle_count() == 0) return;
      origin->obstacles = BoxTree(std::span(boxes).first(obstacle_count()));
      origin->first_vertex.assign(region_starts.begin(), region_starts.begin() + obstacle_count());
    });
  }

  // The regions whose boxes meet one of some places, ascending.
  [[nodiscard]] std::vector<ObstacleId> regions_meeting(std::span<const Box> places) const {
    index_obstacles();
    std::vector<ObstacleId> found;
    const auto [first_added, end_added] = history.map().added();
    const ObstacleId first_other =
        first_added < end_added ? obstacle_of[first_added] : static_cast<ObstacleId>(obstacle_count());
    for (const Box& place : places) {
      origin->obstacles.visit_overlaps(place, [&](std::uint32_t o) {
        const VertexId now = history.map().after(origin->first_vertex[o]);
        if (now != kNone) found.push_back(obstacle_of[now]);
        return true;
      });
      for (ObstacleId o = first_other; o < boxes.size(); ++o)
        if (boxes[o].overlaps(place)) found.push_back(o);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  // Vertices inside an edge of their own region, whichever of its sides their ring is on.
  struct Touches {
    std::vector<SelfContact> on_left;
    std::vector<VertexId> on_right;  // the vertices; ascending
  };

  void add_region(const Polygon& polygon, std::span<const RingContact> ring_contacts, bool is_bounds,
                  Touches& touches) {
    const std::size_t first_ring = ring_starts.size();
    add_ring(polygon.outer, is_bounds ? -1 : 1);
    for (const Ring& hole : polygon.holes) add_ring(hole, -1);
    for (const RingContact& contact : ring_contacts) {
      const VertexId start = ring_starts[first_ring + contact.edge_ring] + static_cast<VertexId>(contact.edge);
      const Ring& ring = contact.edge_ring == 0 ? polygon.outer : polygon.holes[contact.edge_ring - 1];
      const VertexId ahead = contact.edge + 1 == ring.size() ? ring_starts[first_ring + contact.edge_ring] : start + 1;
      const VertexId edge = next[start] == ahead ? start : ahead;
      const VertexId v = ring_starts[first_ring + contact.vertex_ring] + static_cast<VertexId>(contact.vertex);
      // No edge runs along another one: both neighbors lie on one side.
      if (orientation(vertices[edge], vertices[next[edge]], vertices[next[v]]) > 0)
        touches.on_left.push_back({edge, v});
      else
        touches.on_right.push_back(v);
    }
    Box region_box;
    for (const Vec2& p : polygon.outer) region_box.extend(p);
    close_region(region_box);
  }

  void add_ring(const Ring& ring, int wanted_winding) {
    const auto first = static_cast<VertexId>(vertices.size());
    const auto n = static_cast<VertexId>(ring.size());
    ring_starts.push_back(first);
    const bool as_given = winding(ring) == wanted_winding;
    for (VertexId i = 0; i < n; ++i) {
      const VertexId ahead = first + (i + 1 == n ? 0 : i + 1);
      const VertexId behind = first + (i == 0 ? n - 1 : i - 1);
      vertices.push_back(ring[i]);
      next.push_back(as_given ? ahead : behind);
      previous.push_back(as_given ? behind : ahead);
    }
  }

  void reserve(std::size_t vertex_count) {
    vertices.reserve(vertex_count);
    edges.reserve(vertex_count);
    next.reserve(vertex_count);
    previous.reserve(vertex_count);
    obstacle_of.reserve(vertex_count);
    convex_vertices.reserve(vertex_count);
  }

  // Calls visit(begin, end) for ranges of obstacles that remain, but for the first `skipped` ones.
  template <class Visitor>
  static void visit_kept(std::span<const ObstacleId> removed, ObstacleId obstacles, std::size_t skipped,
                         Visitor&& visit) {
    ObstacleId begin = 0;
    for (std::size_t i = 0; i <= removed.size(); ++i) {
      const ObstacleId end = i < removed.size() ? removed[i] : obstacles;
      const auto passed = static_cast<ObstacleId>(std::min<std::size_t>(skipped, end - begin));
      skipped -= passed;
      if (begin + passed < end) visit(begin + passed, end);
      begin = end + 1;
    }
  }

  // The number of first obstacles that this world has in common with what is left of another one of its origin.
  // @param left  from the first world of the origin to what is left.
  [[nodiscard]] std::size_t count_common(const Data& other, std::span<const ObstacleId> removed,
                                         const VertexMap& left) const {
    const VertexId vertices_in_common = left.common_with(history.map());
    std::size_t common = static_cast<std::size_t>(std::ranges::upper_bound(region_starts, vertices_in_common) -
                                                  region_starts.begin() - 1);
    bool differs = false;
    visit_kept(removed, other.obstacle_count(), common, [&](ObstacleId begin, ObstacleId end) {
      if (differs) return;
      const auto range = std::span(other.stamps).subspan(begin, end - begin);
      const auto mine = std::span(stamps).first(obstacle_count()).subspan(common);
      const auto at = std::ranges::mismatch(range, mine).in1;
      common += static_cast<std::size_t>(at - range.begin());
      differs = at != range.end();
    });
    return common;
  }

  // The regions that were added since the first world of the origin.
  [[nodiscard]] std::pair<ObstacleId, ObstacleId> added_regions() const {
    const auto [first, last] = history.map().added();
    if (first == last) return {obstacle_count(), obstacle_count()};
    return {obstacle_of[first], obstacle_of[last - 1] + 1};
  }

  // Appends the boxes of obstacles that this world has and another one of its origin has not.
  void append_others(const Data& other, std::vector<Box>& places) const {
    for (const VertexRange& range : other.history.map().removed())
      if (const VertexId v = history.map().after(range.first); v != kNone) places.push_back(boxes[obstacle_of[v]]);
    const auto [theirs, their_end] = other.added_regions();
    std::vector<std::uint64_t> known(other.stamps.begin() + theirs, other.stamps.begin() + their_end);
    std::ranges::sort(known);
    const auto [mine, my_end] = added_regions();
    for (ObstacleId o = mine; o < my_end; ++o)
      if (!std::ranges::binary_search(known, stamps[o])) places.push_back(boxes[o]);
  }

  // Keeps the first regions only. Their vertices may be covered by others than before.
  void truncate(std::size_t regions) {
    const VertexId count = region_starts[regions];
    for (HugeVector<VertexId>* array : {&next, &previous, &obstacle_of}) array->resize(count);
    vertices.resize(count);
    edges.resize(count);
    convex.resize(count);
    covered.resize(count);
    region_starts.resize(regions + 1);
    region_rings.resize(regions + 1);
    ring_starts.resize(region_rings.back());
    boxes.resize(regions);
    stamps.resize(regions);
    has_bounds = false;
  }

  // What a change of another world begins with: arrays of a world that is gone, with the first obstacles of those that
  // remain. No obstacles if they differ in many: copies are made faster than coverage is looked at again.
  // @param left  from the first world of the origin to what is left.
  // @param places  becomes the boxes of obstacles that only one of these two worlds has.
  static std::unique_ptr<Data> begin_change(const Data& old, std::span<const ObstacleId> removed, const VertexMap& left,
                                            std::vector<Box>& places) {
    std::unique_ptr<Data> data = old.origin->spare.take();
    const bool is_of_use = data && data->contacts.empty() && old.contacts.empty();
    if (is_of_use) {
      data->append_others(old, places);
      old.append_others(*data, places);
    }
    if (!is_of_use || !are_few(places.size(), old.obstacle_count())) {
      places.clear();
      if (!data) data = std::make_unique<Data>();
      data->contacts.clear();
      data->contacts_by_vertex.clear();
      data->truncate(0);
      data->history = WorldHistory();
    } else {
      data->truncate(data->count_common(old, removed, left));
    }
    data->origin = old.origin;
    return data;
  }

  // The box of what is left of a world without some obstacles.
  [[nodiscard]] Box box_without(std::span<const ObstacleId> removed) const {
    const auto is_inside = [&](ObstacleId o) {
      return (boxes[o].min.array() > box.min.array()).all() && (boxes[o].max.array() < box.max.array()).all();
    };
    if (std::ranges::all_of(removed, is_inside)) return box;
    Box left;
    visit_kept(removed, static_cast<ObstacleId>(boxes.size()), 0, [&](ObstacleId begin, ObstacleId end) {
      for (ObstacleId o = begin; o < end; ++o) left.extend(boxes[o]);
    });
    return left;
  }

  // Regions [begin, end) of another world, after the last one of this one, with all that is known about them.
  void copy_regions(const Data& from, ObstacleId begin, ObstacleId end) {
    const VertexId first = from.region_starts[begin], last = from.region_starts[end];
    const auto to = static_cast<VertexId>(vertices.size());
    const auto region = static_cast<ObstacleId>(boxes.size());
    const auto moved = [&](VertexId v) { return v - first + to; };
    const auto append = [&](const auto& source, auto& target) {
      target.insert(target.end(), source.begin() + first, source.begin() + last);
    };
    const auto append_moved = [&](const auto& source, auto& target, const auto& move) {
      target.resize(vertices.size());
      std::transform(source.begin() + first, source.begin() + last, target.begin() + to, move);
    };
    append(from.vertices, vertices);
    append(from.edges, edges);
    append(from.convex, convex);
    append(from.covered, covered);
    append_moved(from.next, next, moved);
    append_moved(from.previous, previous, moved);
    append_moved(from.obstacle_of, obstacle_of, [&](ObstacleId o) { return o - begin + region; });
    for (ObstacleId o = begin; o < end; ++o) {
      for (std::size_t r = from.region_rings[o]; r < from.region_rings[o + 1]; ++r)
        ring_starts.push_back(moved(from.ring_starts[r]));
      region_starts.push_back(moved(from.region_starts[o + 1]));
      region_rings.push_back(ring_starts.size());
      boxes.push_back(from.boxes[o]);
      stamps.push_back(from.stamps[o]);
      box.extend(from.boxes[o]);
    }
    for (auto c = std::ranges::lower_bound(from.contacts, first, {}, &SelfContact::edge);
         c != from.contacts.end() && c->edge < last; ++c)
      contacts.push_back({moved(c->edge), moved(c->vertex)});
  }

  // All vertices and rings since the last region are one.
  void close_region(const Box& region_box) {
    obstacle_of.resize(vertices.size(), static_cast<ObstacleId>(boxes.size()));
    boxes.push_back(region_box);
    stamps.push_back(next_stamp());
    region_starts.push_back(static_cast<VertexId>(vertices.size()));
    region_rings.push_back(ring_starts.size());
    box.extend(region_box);
  }

  [[nodiscard]] ObstacleId obstacle_count() const {
    return static_cast<ObstacleId>(boxes.size() - (has_bounds ? 1 : 0));
  }

  // Takes the keys of the obstacles that are left of another world, and gives new ones to all others.
  // @param known  number of obstacles whose keys are right if there are any.
  void take_keys(const Data& from, std::span<const ObstacleId> removed, std::size_t known) {
    const ObstacleId before = from.obstacle_count();
    next_key.reset();
    keys.resize(from.next_key || !removed.empty() ? std::min(keys.size(), known) : 0);
    if (!from.next_key && removed.empty()) return;
    keys.reserve(obstacle_count());
    visit_kept(removed, before, keys.size(), [&](ObstacleId begin, ObstacleId end) {
      for (ObstacleId o = begin; o < end; ++o) keys.push_back(from.key_of(o));
    });
    ObstacleKey unused = from.next_key.value_or(before);
    while (keys.size() < obstacle_count()) keys.push_back(unused++);
    next_key = unused;
  }
  [[nodiscard]] ObstacleKey key_of(ObstacleId o) const { return next_key ? keys[o] : o; }

  // What follows at once from vertices and links, for all vertices that have no edges yet.
  void derive_edges() {
    const auto n = static_cast<VertexId>(vertices.size());
    edges.reserve(n);
    convex.resize(n);
    for (auto v = static_cast<VertexId>(edges.size()); v < n; ++v) {
      edges.push_back({vertices[v], vertices[next[v]]});
      convex[v] = orientation(vertices[previous[v]], vertices[v], vertices[next[v]]) > 0;
    }
  }

  [[nodiscard]] bool is_graph_vertex(VertexId v) const { return convex[v] && !covered[v]; }

  // @param same  number of first vertices for which the list is right.
  void list_convex_vertices(VertexId same = 0) {
    convex_vertices.erase(std::ranges::lower_bound(convex_vertices, same), convex_vertices.end());
    for (VertexId v = same; v < vertices.size(); ++v)
      if (is_graph_vertex(v)) convex_vertices.push_back(v);
  }

  // Decides which vertices are covered after a change, and returns those for which that is another answer than before.
  // @param places  boxes of obstacles that were removed or added.
  // @param change  from `old`.
  std::vector<VertexId> update_covered(const std::vector<Box>& places, const Data& old, const VertexMap& change) {
    if (places.empty()) return {};
    const BoxTree tree(places);
    std::vector<ObstacleId> regions = regions_meeting(places);
    std::vector<VertexId> doubtful;
    for (const ObstacleId o : regions)
      for (VertexId v = region_starts[o]; v < region_starts[o + 1]; ++v)
        if (!tree.visit_overlaps(Box{vertices[v], vertices[v]}, [](std::uint32_t) { return false; }))
          doubtful.push_back(v);
    // What is outside of the bounds is covered by them, wherever their box is.
    if (has_bounds && (regions.empty() || !is_bounds(regions.back()))) regions.push_back(obstacle_count());
    mark_covered(doubtful, regions);
    std::erase_if(doubtful, [&](VertexId v) {
      const VertexId before = change.before(v);
      return before == kNone || covered[v] == old.covered[before];
    });
    return doubtful;
  }

  // Completes this after a change of another world: coverage, the list of convex vertices and the history.
  // @param places  boxes of obstacles that were removed or added, or that only the world had whose arrays these were.
  void follow(const Data& old, const VertexMap& change, const std::vector<Box>& places) {
    const WorldHistory of_arrays = std::move(history);
    history = WorldHistory(old.history, change, {}, origin->convex);
    const std::vector<VertexId> flipped = update_covered(places, old, change);
    history = WorldHistory(old.history, change, flipped, origin->convex);
    list_convex_vertices(history.common_with(of_arrays));
    const auto [first, last] = added_regions();
    if (!are_few(last - first, obstacle_count())) begin_history();
  }

  [[nodiscard]] bool is_bounds(ObstacleId region) const { return has_bounds && region + 1 == boxes.size(); }

  // The place among a region's rings, as seen from the region's side of them.
  [[nodiscard]] PointLocation side_of(PointLocation in_rings, ObstacleId region) const {
    if (!is_bounds(region) || in_rings == PointLocation::kBoundary) return in_rings;
    return in_rings == PointLocation::kInside ? PointLocation::kOutside : PointLocation::kInside;
  }

  [[nodiscard]] PointLocation locate(const Vec2& p, ObstacleId region) const {
    if (!boxes[region].contains(p)) return side_of(PointLocation::kOutside, region);
    RayParity parity(p);
    for (VertexId v = region_starts[region]; v < region_starts[region + 1]; ++v) {
      parity.add(vertices[v], vertices[next[v]]);
    }
    return side_of(parity.location(), region);
  }

  // Where rings touch in a vertex, an edge that ends there is linked to the edge that bounds the same wedge of the
  // interior: the first one clockwise from it. Each of the coincident vertices then has a wedge of its own, and all
  // wedges are disjoint. An edge that passes between them separates the vertices on its two sides.
  void relink_pinches(VertexId first_vertex, std::span<const VertexId> on_right_of_edges) {
    HugeVector<VertexId> order(vertices.size() - first_vertex);
    std::iota(order.begin(), order.end(), first_vertex);
    const auto key = [this](VertexId v) { return std::tuple(obstacle_of[v], vertices[v].x(), vertices[v].y()); };
    std::sort(order.begin(), order.end(), [&](VertexId v, VertexId w) { return key(v) < key(w); });
    std::vector<std::pair<VertexId, VertexId>> links;  // made in the end: the search needs the old ones
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
      while (last < order.size() && key(order[first]) == key(order[last])) ++last;
      if (last - first < 2) continue;
      const auto on_right = std::partition(order.begin() + first, order.begin() + last, [&](VertexId v) {
        return !std::binary_search(on_right_of_edges.begin(), on_right_of_edges.end(), v);
      });
      append_links({order.begin() + first, on_right}, links);
      append_links({on_right, order.begin() + last}, links);
    }
    for (const auto& [u, v] : links) {
      next[u] = v;
      previous[v] = u;
    }
  }

  // Appends the links (previous, vertex) of coincident vertices.
  void append_links(std::span<const VertexId> pinch, std::vector<std::pair<VertexId, VertexId>>& links) const {
    for (const VertexId v : pinch) {
      VertexId nearest = previous[v];
      for (const VertexId w : pinch) {
        const VertexId u = previous[w];
        if (in_open_cone(vertices[nearest], vertices[v], vertices[next[v]], vertices[u])) nearest = u;
      }
      links.emplace_back(nearest, v);
    }
  }

  // Links coincident vertices of new regions, and lists contacts.
  void connect(VertexId first_vertex, Touches touches) {
    std::sort(touches.on_right.begin(), touches.on_right.end());
    relink_pinches(first_vertex, touches.on_right);
    contacts.insert(contacts.end(), touches.on_left.begin(), touches.on_left.end());
    sort_contacts();
  }

  void sort_contacts() {
    const auto by_edge = [](const SelfContact& c) { return std::pair(c.edge, c.vertex); };
    std::ranges::sort(contacts, {}, by_edge);
    contacts_by_vertex = contacts;
    std::ranges::sort(contacts_by_vertex, {}, &SelfContact::vertex);
  }

  // The vertices asked about, in stretches of some that follow each other in a region.
  struct Stretches {
    std::vector<std::size_t> starts;  // in what is asked, one more than stretches
    HugeVector<Box> boxes;
  };
  // Groups vertices that are near each other, as their boxes are to be about as small as points.
  [[nodiscard]] Stretches stretches_of(std::span<const VertexId> which) const {
    constexpr std::size_t kMostVertices = 16;
    const double widest = 4.0 * (box.max - box.min).maxCoeff() / std::sqrt(static_cast<double>(vertices.size()));
    Stretches stretches;
    for (std::size_t i = 0; i < which.size(); ++i) {
      const VertexId v = which[i];
      Box extended;
      if (i > 0) extended = stretches.boxes.back();
      extended.extend(vertices[v]);
      if (i > 0 && obstacle_of[v] == obstacle_of[which[i - 1]] && i - stretches.starts.back() < kMostVertices &&
          (extended.max - extended.min).maxCoeff() <= widest) {
        stretches.boxes.back() = extended;
        continue;
      }
      stretches.starts.push_back(i);
      stretches.boxes.emplace_back().extend(vertices[v]);
    }
    stretches.starts.push_back(which.size());
    return stretches;
  }

  // Decides which of these vertices are covered.
  // @param regions  all that may cover one of them.
  void mark_covered(std::span<const VertexId> which, std::span<const ObstacleId> regions) {
    covered.resize(vertices.size());
    for (const VertexId v : which) covered[v] = false;
    if (mark_inside(regions, which, kRegionPatience * vertices.size())) return;
    Coverage coverage = sweep_coverage(edges, obstacle_of, has_bounds ? obstacle_count() : kNone);
    covered = std::move(coverage.covered);
    HugeVector<VertexId> all(vertices.size());
    std::iota(all.begin(), all.end(), VertexId{0});
    mark_inside(coverage.left_over, all, std::numeric_limits<std::size_t>::max());
  }

  void mark_all_covered() {
    HugeVector<VertexId> all(vertices.size());
    std::iota(all.begin(), all.end(), VertexId{0});
    std::vector<ObstacleId> regions(boxes.size());
    std::iota(regions.begin(), regions.end(), ObstacleId{0});
    mark_covered(all, regions);
  }

  // Marks those of the vertices that lie strictly inside one of the regions.
  // @param most  how many edges may be looked at, about; then it ends and returns false.
  bool mark_inside(std::span<const ObstacleId> regions, std::span<const VertexId> which, std::size_t most) {
    const Stretches stretches = stretches_of(which);
    const BoxTree stretch_tree(stretches.boxes);
    Box asked;
    for (const Box& stretch : stretches.boxes) asked.extend(stretch);
    // Region by region, so that the tree over the edges of a large one lives only for its turn.
    for (const ObstacleId region : regions) {
      const Box& around = is_bounds(region) ? box : boxes[region];  // what is outside of the bounds is covered
      if (!around.overlaps(asked)) continue;
      RegionSearch search(*this, region);
      const bool is_done = stretch_tree.visit_overlaps(around, [&](std::uint32_t i) {
        ++search.looks;
        const auto stretch = which.subspan(stretches.starts[i], stretches.starts[i + 1] - stretches.starts[i]);
        if (obstacle_of[stretch.front()] == region) return true;
        for (const VertexId v : stretch)
          if (!covered[v] && around.contains(vertices[v])) covered[v] = search.locate(v) == PointLocation::kInside;
        return search.looks <= most;
      });
      if (!is_done) return false;
      most -= std::min(most, search.looks);
    }
    return true;
  }

  // Where points lie in one region, many of them.
  struct RegionSearch {
    RegionSearch(const Data& the_data, ObstacleId the_region) : data(the_data), region(the_region) {}

    PointLocation locate(VertexId v) {
      const Vec2& p = data.vertices[v];
      const VertexId first = data.region_starts[region], last = data.region_starts[region + 1];
      if (!data.boxes[region].contains(p)) return data.locate(p, region);
      if (last - first <= kScanVertices) {
        looks += last - first;
        return data.locate(p, region);
      }
      if (edge_tree.size() == 0) build_edge_tree(first, last);
      RayParity parity(p);
      edge_tree.visit_overlaps(parity.ray_box(), [&](std::uint32_t e) {
        ++looks;
        parity.add(data.edges[first + e].a, data.edges[first + e].b);
        return true;
      });
      return data.side_of(parity.location(), region);
    }

    void build_edge_tree(VertexId first, VertexId last) {
      std::vector<Box> edge_boxes;
      edge_boxes.reserve(last - first);
      for (VertexId v = first; v < last; ++v) edge_boxes.push_back(arcway::box_of(data.edges[v]));
      edge_tree = BoxTree(edge_boxes);
    }

    const Data& data;
    ObstacleId region;
    BoxTree edge_tree;
    std::size_t looks = 0;  // at edges, about
  };
};

World::World(std::vector<Polygon> obstacles, std::optional<Ring> bounds) {
  auto data = std::make_shared<Data>();
  const std::size_t vertex_count = vertex_count_of(obstacles) + (bounds ? bounds->size() : 0);
  const auto obstacle_count = static_cast<ObstacleId>(obstacles.size());
  require_vertex_count(vertex_count, obstacle_count);
  data->vertices.reserve(vertex_count);
  data->next.reserve(vertex_count);
  data->previous.reserve(vertex_count);
  data->obstacle_of.reserve(vertex_count);
  Data::Touches touches;
  for (ObstacleId o = 0; o < obstacle_count; ++o) {
    data->add_region(obstacles[o], require_region(obstacles[o], o, false), false, touches);
    obstacles[o] = {};
  }
  if (bounds) {
    const Polygon polygon{std::move(*bounds), {}};
    data->has_bounds = true;
    data->add_region(polygon, require_region(polygon, obstacle_count, true), true, touches);
  }
  data->connect(0, std::move(touches));
  data->derive_edges();
  data->mark_all_covered();
  data->list_convex_vertices();
  data->begin_history();
  data_ = std::move(data);
}

World World::from_snapshot(WorldSnapshot snapshot) {
  require_world(snapshot);
  auto data = std::make_shared<Data>();
  const auto n = static_cast<VertexId>(snapshot.vertices.size());
  data->previous.resize(n);
  for (VertexId v = 0; v < n; ++v) data->previous[snapshot.next[v]] = v;
  data->has_bounds = snapshot.has_bounds;
  data->obstacle_of.reserve(n);
  const std::size_t regions = snapshot.region_rings.size() - 1;
  for (std::size_t region = 0; region < regions; ++region) {
    const std::size_t end_ring = snapshot.region_rings[region + 1];
    const VertexId first = snapshot.ring_starts[snapshot.region_rings[region]];
    const VertexId last = end_ring < snapshot.ring_starts.size() ? snapshot.ring_starts[end_ring] : n;
    Box region_box;
    for (VertexId v = first; v < last; ++v) region_box.extend(snapshot.vertices[v]);
    data->obstacle_of.resize(last, static_cast<ObstacleId>(region));
    data->region_starts.push_back(last);
    data->region_rings.push_back(end_ring);
    data->boxes.push_back(region_box);
    data->stamps.push_back(next_stamp());
    data->box.extend(region_box);
  }
  data->vertices.assign(snapshot.vertices.begin(), snapshot.vertices.end());
  snapshot.vertices = {};
  data->next.assign(snapshot.next.begin(), snapshot.next.end());
  data->ring_starts = std::move(snapshot.ring_starts);
  data->covered.assign(snapshot.covered.begin(), snapshot.covered.end());
  data->contacts = std::move(snapshot.self_contacts);
  data->sort_contacts();
  data->derive_edges();
  data->list_convex_vertices();
  data->begin_history();
  World world(std::vector<Polygon>{});
  world.data_ = std::move(data);
  world.zones_ = Zones::of(std::move(snapshot.zones), snapshot.keep_outs);
  return world;
}

WorldSnapshot World::snapshot() const {
  WorldSnapshot snapshot;
  snapshot.vertices.assign(data_->vertices.begin(), data_->vertices.end());
  snapshot.next.assign(data_->next.begin(), data_->next.end());
  snapshot.covered.assign(data_->covered.begin(), data_->covered.end());
  snapshot.ring_starts = data_->ring_starts;
  snapshot.region_rings.assign(data_->region_rings.begin(), data_->region_rings.end());
  snapshot.self_contacts = data_->contacts;
  snapshot.has_bounds = data_->has_bounds;
  add_zones(snapshot);
  return snapshot;
}

World World::with_obstacles_changed(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) const {
  const Data& old = *data_;
  const auto obstacles = static_cast<ObstacleId>(obstacle_count());
  for (std::size_t i = 0; i < removed.size(); ++i) {
    if (removed[i] >= obstacles)
      throw std::invalid_argument("removed obstacle " + std::to_string(removed[i]) + ": the world has " +
                                  std::to_string(obstacles));
    if (i > 0 && removed[i] <= removed[i - 1])
      throw std::invalid_argument("removed obstacle " + std::to_string(removed[i]) + " follows " +
                                  std::to_string(removed[i - 1]) + ": they must ascend");
  }
  old.index_obstacles();
  std::vector<VertexRange> gone;
  for (const ObstacleId o : removed) gone.push_back(vertices_of(o));
  const auto change_with = [&](VertexRange new_ones) { return VertexMap(gone, new_ones); };
  VertexId left = old.region_starts[obstacles];  // vertices of obstacles
  for (const VertexRange& range : gone) left -= range.last - range.first;
  std::vector<Box> places;
  std::unique_ptr<Data> data =
      Data::begin_change(old, removed, old.history.map().then(change_with({left, left})), places);
  data->reserve(old.vertices.size() + vertex_count_of(added));
  const std::size_t common = data->boxes.size();
  for (const ObstacleId o : removed) places.push_back(old.boxes[o]);
  Data::visit_kept(removed, obstacles, common,
                   [&](ObstacleId begin, ObstacleId end) { data->copy_regions(old, begin, end); });
  const auto first_added = static_cast<VertexId>(data->vertices.size());
  data->box = old.box_without(removed);
  Data::Touches touches;
  for (const Polygon& polygon : added) {
    const auto id = static_cast<ObstacleId>(data->boxes.size());
    data->add_region(polygon, require_region(polygon, id, false), false, touches);
    places.push_back(data->boxes.back());
  }
  const auto end_added = static_cast<VertexId>(data->vertices.size());
  data->connect(first_added, std::move(touches));
  data->covered.resize(end_added);
  data->derive_edges();
  if (old.has_bounds) {
    data->has_bounds = true;
    data->copy_regions(old, obstacles, obstacles + 1);
    data->sort_contacts();
  }
  require_vertex_count(data->vertices.size(), static_cast<ObstacleId>(data->boxes.size()));
  data->take_keys(old, removed, common);
  data->follow(old, change_with({first_added, end_added}), places);
  World world = *this;
  world.data_ = Data::shared(std::move(data));
  return world;
}

std::span<const Vec2> World::vertices() const { return data_->vertices; }
std::span<const LineSegment> World::edges() const { return data_->edges; }
VertexId World::next(VertexId v) const { return data_->next[v]; }
VertexId World::previous(VertexId v) const { return data_->previous[v]; }
std::span<const SelfContact> World::self_contacts() const { return data_->contacts; }

std::span<const SelfContact> World::self_contacts_on(VertexId edge) const {
  if (data_->contacts.empty()) return {};
  const auto& all = data_->contacts;
  const auto first = std::ranges::lower_bound(all, edge, {}, &SelfContact::edge);
  return {first, std::ranges::upper_bound(first, all.end(), edge, {}, &SelfContact::edge)};
}

VertexId World::edge_touched_by(VertexId v) const {
  const auto& contacts = data_->contacts_by_vertex;
  if (contacts.empty()) return kNone;
  const auto at = std::ranges::lower_bound(contacts, v, {}, &SelfContact::vertex);
  return at != contacts.end() && at->vertex == v ? at->edge : kNone;
}

ObstacleId World::obstacle_of(VertexId v) const { return data_->obstacle_of[v]; }
bool World::is_convex(VertexId v) const { return data_->convex[v]; }
bool World::is_covered(VertexId v) const { return data_->covered[v]; }
bool World::is_graph_vertex(VertexId v) const { return data_->is_graph_vertex(v); }
std::span<const VertexId> World::convex_vertices() const { return data_->convex_vertices; }
std::size_t World::obstacle_count() const { return data_->obstacle_count(); }
ObstacleKey World::key_of(ObstacleId o) const { return data_->key_of(o); }

ObstacleId World::obstacle_with(ObstacleKey key) const {
  const std::vector<ObstacleKey>& keys = data_->keys;
  if (!data_->next_key) return key < obstacle_count() ? static_cast<ObstacleId>(key) : kNone;
  const auto at = std::ranges::lower_bound(keys, key);
  return at != keys.end() && *at == key ? static_cast<ObstacleId>(at - keys.begin()) : kNone;
}

bool World::has_bounds() const { return data_->has_bounds; }

World::VertexRange World::vertices_of(ObstacleId o) const {
  return {data_->region_starts[o], data_->region_starts[o + 1]};
}

std::span<const VertexId> World::ring_starts(ObstacleId o) const {
  const std::size_t first = data_->region_rings[o];
  return std::span(data_->ring_starts).subspan(first, data_->region_rings[o + 1] - first);
}

const Box& World::box_of(ObstacleId o) const { return data_->boxes[o]; }
const Box& World::box() const { return data_->box; }
std::vector<ObstacleId> World::regions_meeting(std::span<const Box> boxes) const {
  return data_->regions_meeting(boxes);
}
const WorldHistory& World::history() const { return data_->history; }
PointLocation World::locate(const Vec2& p, ObstacleId o) const { return data_->locate(p, o); }

World World::from_polygons(std::vector<Polygon> obstacles, std::optional<Ring> bounds) {
  return World(std::move(obstacles), std::move(bounds));
}

World World::from_polygons(std::vector<Polygon> obstacles, const Polygon& bounds) {
  if (!bounds.holes.empty())
    throw WorldError("bounds: a polygon with " + std::to_string(bounds.holes.size()) +
                         (bounds.holes.size() == 1 ? " hole" : " holes") + ", must have none; make holes obstacles",
                     static_cast<ObstacleId>(obstacles.size()));
  return World(std::move(obstacles), bounds.outer);
}

World World::from_polygons(const std::vector<Ring>& obstacles, std::optional<Ring> bounds) {
  std::vector<Polygon> polygons;
  polygons.reserve(obstacles.size());
  for (const Ring& ring : obstacles) polygons.push_back({ring, {}});
  return World(std::move(polygons), std::move(bounds));
}

std::string to_string(const World& world) {
  const std::size_t obstacles = world.obstacle_count(), vertices = world.vertices().size();
  return std::to_string(obstacles) + (obstacles == 1 ? " obstacle of " : " obstacles of ") + std::to_string(vertices) +
         (vertices == 1 ? " vertex" : " vertices") + (world.has_bounds() ? " within bounds" : "");
}

}  // namespace arcway
