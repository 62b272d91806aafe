#include "accel/triangulation/planar_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/prefetch.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/edge_sweep.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

using Edge = PlanarMap::Edge;

constexpr std::size_t kItemsAhead = 32;  // items to prefetch ahead, as they lie anywhere in memory

struct Keyed {
  std::uint32_t key;
  VertexId vertex;
};

// Sorts vertices by (x, y): a radix sort on x in 2^32 steps, then exactly within equal steps.
BigVector<Keyed> sorted_vertices(const World& world) {
  const std::span<const Vec2> vertices = world.vertices();
  const double low = world.box().min.x();
  const double extent = world.box().max.x() - low;
  const double scale = extent > 0.0 ? 4294967040.0 / extent : 0.0;
  BigVector<Keyed> keyed(vertices.size()), other(vertices.size());
  constexpr int kBits = 11, kDigits = 3;
  const auto digit = [](std::uint32_t key, int i) { return (key >> (i * kBits)) & ((1u << kBits) - 1); };
  std::array<std::array<std::uint32_t, (1u << kBits) + 1>, kDigits> starts{};
  for (VertexId v = 0; v < vertices.size(); ++v) {
    // Monotone in x whatever the rounding; an extent too small for a finite scale leaves one step.
    const double step = std::isfinite(scale) ? (vertices[v].x() - low) * scale : 0.0;
    keyed[v] = {static_cast<std::uint32_t>(step), v};
    for (int i = 0; i < kDigits; ++i) ++starts[i][digit(keyed[v].key, i) + 1];
  }
  for (int i = 0; i < kDigits; ++i) {
    std::partial_sum(starts[i].begin(), starts[i].end(), starts[i].begin());
    for (const Keyed& k : keyed) other[starts[i][digit(k.key, i)]++] = k;
    keyed.swap(other);
  }
  const auto before = [&](const Keyed& a, const Keyed& b) {
    const Vec2& p = vertices[a.vertex];
    const Vec2& q = vertices[b.vertex];
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  };
  for (std::size_t first = 0, last = 0; first < keyed.size(); first = last) {
    while (last < keyed.size() && keyed[last].key == keyed[first].key) ++last;
    if (last - first > 1) std::sort(keyed.begin() + first, keyed.begin() + last, before);
  }
  return keyed;
}

// The frame keeps a distance of the map's size, and one large enough to differ in the last place.
Box frame_of(const Box& box) {
  const Vec2 size = box.max - box.min;
  const double magnitude = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
  const double pad = std::max({size.x(), size.y(), 1e-6 * magnitude, 1.0});
  Box frame;
  frame.min = box.min.array() - pad;
  frame.max = box.max.array() + pad;
  return frame;
}

// Adds points that ascend between the corners of a frame. @param add_points  () adds them to the map's.
template <class AddPoints>
void add_in_frame(const Box& box, PlanarMap& map, const AddPoints& add_points) {
  const Box frame = frame_of(box);
  map.points.push_back(frame.min);
  map.points.emplace_back(frame.min.x(), frame.max.y());
  add_points();
  map.points.emplace_back(frame.max.x(), frame.min.y());
  map.points.push_back(frame.max);
}

void make_points(const World& world, PlanarMap& map) {
  const BigVector<Keyed> sorted = sorted_vertices(world);
  map.points.reserve(sorted.size() + 4);
  map.point_of.resize(sorted.size());
  add_in_frame(world.box(), map, [&] {
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i + kItemsAhead < sorted.size()) {
        will_need(&world.vertices()[sorted[i + kItemsAhead].vertex]);
        will_need(&map.point_of[sorted[i + kItemsAhead].vertex]);
      }
      const Vec2& p = world.vertex(sorted[i].vertex);
      if (i == 0 || p != map.points.back()) map.points.push_back(p);
      map.point_of[sorted[i].vertex] = static_cast<std::uint32_t>(map.points.size() - 1);
    }
  });
}

Edge edge_between(std::uint32_t from, std::uint32_t to, std::int32_t count) {
  // The region lies to the left of its edges.
  return from < to ? Edge{from, to, count, 0} : Edge{to, from, 0, count};
}

// Sorts edges by point and slope and indexes them; equal edges become one. Returns false if others overlap. Edges are
// computed again at each use, which takes less time than to store them.
template <class EdgeAt>
bool index_edges(std::size_t count, const EdgeAt& edge_at, PlanarMap& map) {
  const auto point_count = static_cast<std::uint32_t>(map.points.size());
  BigVector<std::uint32_t>& first = map.first_edge;
  first.assign(point_count + 1, 0);
  const Edge bottom{0, point_count - 2, 0, 0}, top{1, point_count - 1, 0, 0};
  first[1] = first[2] = 1;
  for (std::size_t i = 0; i < count; ++i) ++first[edge_at(i).low + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  map.edges.resize(count + 2);
  map.edges[0] = bottom;
  map.edges[1] = top;
  for (std::size_t i = 0; i < count; ++i) {
    if (i + 2 * kItemsAhead < count) will_need(&first[edge_at(i + 2 * kItemsAhead).low]);
    if (i + kItemsAhead < count) will_need(map.edges.data() + first[edge_at(i + kItemsAhead).low]);
    const Edge edge = edge_at(i);
    map.edges[first[edge.low]++] = edge;
  }

  const auto slope_order = [&](const Edge& e, const Edge& f) {
    return e.high != f.high && orientation(map.points[e.low], map.points[e.high], map.points[f.high]) > 0;
  };
  std::uint32_t kept = 2;
  for (std::uint32_t s = 2, begin = 2; s < point_count; ++s) {
    const std::uint32_t end = first[s];  // before the shift by kept edges
    if (end + kItemsAhead < map.edges.size()) will_need(&map.points[map.edges[end + kItemsAhead].high]);
    if (end - begin == 2) {
      if (slope_order(map.edges[begin + 1], map.edges[begin])) std::swap(map.edges[begin], map.edges[begin + 1]);
    } else if (end - begin > 2) {
      std::sort(map.edges.begin() + begin, map.edges.begin() + end, slope_order);
    }
    const std::uint32_t first_kept = kept;
    for (std::uint32_t e = begin; e < end; ++e) {
      const Edge edge = map.edges[e];
      if (kept > first_kept) {
        Edge& last = map.edges[kept - 1];
        if (last.high == edge.high) {
          last.above += edge.above;
          last.below += edge.below;
          continue;
        }
        if (!slope_order(last, edge)) return false;
      }
      map.edges[kept++] = edge;
    }
    first[s] = first_kept;
    begin = end;
  }
  first[point_count] = kept;
  map.edges.resize(kept);
  map.incoming.assign(point_count, kNone);
  for (std::uint32_t e = 0; e < kept; ++e) map.incoming[map.edges[e].high] = e;
  return true;
}

// Pairs of overlapping boxes per edge, until one sweep over all edges searches for contacts instead.
constexpr std::size_t kPatience = 64;

// Finds vertices inside edges of a world in which no edges cross.
class ContactSweep final : public EdgeSweep::Visitor {
 public:
  explicit ContactSweep(std::span<const LineSegment> edges) : edges_(edges) {}

  /// Calls found(edge, vertex), where a vertex is given by the edge that starts there.
  /// @return false if edges cross.
  bool finds(std::function<void(VertexId, VertexId)> found) {
    found_ = std::move(found);
    return EdgeSweep(edges_).run(*this);
  }

  bool crosses(std::uint32_t /*e*/, std::uint32_t /*f*/) override { return false; }
  void visit(const EdgeSweep::Event& event) override {
    const auto passes = [&](std::uint32_t e) { return edges_[e].a != event.at && edges_[e].b != event.at; };
    for (const std::uint32_t e : event.left) {
      if (!passes(e)) continue;
      for (const std::uint32_t f : event.ends)
        if (edges_[f].a == event.at) found_(e, f);
    }
  }

 private:
  std::span<const LineSegment> edges_;
  std::function<void(VertexId, VertexId)> found_;
};

// Cuts obstacle edges at the vertices that lie on them, and drops crossing pieces.
class Cutter {
 public:
  Cutter(const World& world, PlanarMap& map) : world_(world), map_(map) {}

  std::vector<Edge> cut() {
    find_contacts();
    std::sort(cuts_.begin(), cuts_.end());
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
    make_pieces();
    drop_crossings();
    invalid_.assign(world_.region_count(), 0);
    for (const auto& [edge, piece] : owners_)
      if (dropped_[piece]) invalid_[world_.obstacle_of(edge)] = 1;
    for (ObstacleId o = 0; o < invalid_.size(); ++o)
      if (invalid_[o]) map_.invalid.push_back(o);
    return count_regions();
  }

 private:
  using Cut = std::pair<VertexId, std::uint32_t>;  // edge, point on it

  struct Piece {
    std::uint32_t low, high;
    friend auto operator<=>(const Piece&, const Piece&) = default;  // NOLINT(modernize-use-nullptr): <compare> has it
  };

  void find_contacts() {
    if (search_boxes(kPatience * world_.edges().size())) return;
    cuts_.clear();
    crossings_.clear();
    ContactSweep sweep(world_.edges());
    if (!sweep.finds([&](VertexId edge, VertexId vertex) { cuts_.emplace_back(edge, map_.point_of[vertex]); }))
      search_boxes(std::numeric_limits<std::size_t>::max());
  }

  // @param most  pairs of boxes to test; beyond them it stops and returns false.
  bool search_boxes(std::size_t most) {
    const std::span<const LineSegment> edges = world_.edges();
    std::vector<Box> boxes;
    boxes.reserve(edges.size());
    for (const LineSegment& edge : edges) boxes.push_back(box_of(edge));
    const BoxTree tree(boxes);
    for (VertexId e = 0; e < edges.size(); ++e) {
      const bool is_done = tree.visit_overlaps(boxes[e], [&](VertexId f) {
        if (most-- == 0) return false;
        if (f <= e) return true;
        const SegmentRelation relation = relate(edges[e], edges[f]);
        if (relation == SegmentRelation::kCrossing) {
          crossings_.emplace_back(e, f);
        } else if (relation == SegmentRelation::kTouchingInterior || relation == SegmentRelation::kOverlapping) {
          for (const VertexId v : {f, world_.next(f)})
            if (on_open_segment(world_.vertex(v), edges[e])) cuts_.emplace_back(e, map_.point_of[v]);
          for (const VertexId v : {e, world_.next(e)})
            if (on_open_segment(world_.vertex(v), edges[f])) cuts_.emplace_back(f, map_.point_of[v]);
        }
        return true;
      });
      if (!is_done) return false;
    }
    return true;
  }

  // Points along an edge, ascending.
  void points_on(VertexId edge, std::vector<std::uint32_t>& points) const {
    points.clear();
    auto cut = std::lower_bound(cuts_.begin(), cuts_.end(), Cut{edge, 0});
    for (; cut != cuts_.end() && cut->first == edge; ++cut) points.push_back(cut->second);
    const std::uint32_t a = map_.point_of[edge], b = map_.point_of[world_.next(edge)];
    points.insert(points.begin(), std::min(a, b));
    points.push_back(std::max(a, b));
  }

  void make_pieces() {
    std::vector<std::uint32_t> points;
    std::vector<std::pair<Piece, VertexId>> owned;
    owned.reserve(world_.edges().size() + cuts_.size());
    for (VertexId e = 0; e < world_.edges().size(); ++e) {
      points_on(e, points);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) owned.push_back({{points[i], points[i + 1]}, e});
    }
    std::sort(owned.begin(), owned.end());
    owners_.reserve(owned.size());
    for (const auto& [piece, edge] : owned) {
      if (pieces_.empty() || pieces_.back() != piece) pieces_.push_back(piece);
      owners_.emplace_back(edge, static_cast<std::uint32_t>(pieces_.size() - 1));
    }
    dropped_.assign(pieces_.size(), 0);
  }

  // The piece of one edge that crosses another edge properly; kNone if they cross in a point of the map.
  std::uint32_t piece_across(VertexId edge, VertexId other) {
    points_on(edge, points_);
    const LineSegment& line = world_.edges()[other];
    const auto side = [&](std::uint32_t point) { return orientation(line.a, line.b, map_.points[point]); };
    const int before = side(points_.front());
    const auto across = std::partition_point(points_.begin(), points_.end(), [&](auto s) { return side(s) == before; });
    if (side(*across) == 0) return kNone;
    const Piece piece{*(across - 1), *across};
    return static_cast<std::uint32_t>(std::lower_bound(pieces_.begin(), pieces_.end(), piece) - pieces_.begin());
  }

  // Drops one of two pieces that cross: the one with more crossings.
  void drop_crossings() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<std::uint32_t> count(pieces_.size(), 0);
    for (const auto& [e, f] : crossings_) {
      const std::uint32_t a = piece_across(e, f), b = piece_across(f, e);
      if (a == kNone || b == kNone) continue;
      pairs.emplace_back(a, b);
      ++count[a];
      ++count[b];
    }
    for (const auto& [a, b] : pairs)
      if (!dropped_[a] && !dropped_[b]) dropped_[count[a] > count[b] ? a : b] = 1;
  }

  [[nodiscard]] std::vector<Edge> count_regions() const {
    std::vector<Edge> edges;
    edges.reserve(owners_.size());
    for (const auto& [e, p] : owners_) {
      if (dropped_[p]) continue;
      const bool right = map_.point_of[e] < map_.point_of[world_.next(e)];
      const std::int32_t whole = invalid_[world_.obstacle_of(e)] ? 0 : 1;
      const Piece& piece = pieces_[p];
      edges.push_back(right ? edge_between(piece.low, piece.high, whole) : edge_between(piece.high, piece.low, whole));
    }
    return edges;
  }

  const World& world_;
  PlanarMap& map_;
  std::vector<Cut> cuts_;
  std::vector<std::pair<VertexId, VertexId>> crossings_;
  std::vector<Piece> pieces_;                               // ascending
  std::vector<std::pair<VertexId, std::uint32_t>> owners_;  // edge and one of its pieces
  std::vector<std::uint8_t> dropped_;                       // by piece
  std::vector<std::uint8_t> invalid_;                       // by region
  std::vector<std::uint32_t> points_;
};

}  // namespace

bool make_uncut_map(const World& world, PlanarMap& map) {
  map = {};
  make_points(world, map);
  map.outside_is_solid = world.has_bounds();
  const auto edge_at = [&](std::size_t i) {
    const auto v = static_cast<VertexId>(i);
    return edge_between(map.point_of[v], map.point_of[world.next(v)], 1);
  };
  return index_edges(world.edges().size(), edge_at, map);
}

PlanarMap make_cut_map(const World& world) {
  PlanarMap map;
  make_points(world, map);
  const std::vector<Edge> pieces = Cutter(world, map).cut();
  index_edges(
      pieces.size(), [&](std::size_t i) { return pieces[i]; }, map);
  const auto bounds = static_cast<ObstacleId>(world.obstacle_count());
  map.outside_is_solid = world.has_bounds() && !std::binary_search(map.invalid.begin(), map.invalid.end(), bounds);
  return map;
}

PlanarMap make_map_inside(std::span<const Vec2> points,
                          std::span<const std::pair<std::uint32_t, std::uint32_t>> edges) {
  PlanarMap map;
  Box box;
  for (const Vec2& p : points) box.extend(p);
  add_in_frame(box, map, [&] { map.points.insert(map.points.end(), points.begin(), points.end()); });
  constexpr std::uint32_t kFirst = 2;        // behind two corners of the frame
  const auto edge_at = [&](std::size_t i) {  // what is solid lies on the other side
    return edge_between(kFirst + edges[i].second, kFirst + edges[i].first, 1);
  };
  index_edges(edges.size(), edge_at, map);
  map.outside_is_solid = true;
  return map;
}

}  // namespace arcway::internal
