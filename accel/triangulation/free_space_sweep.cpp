#include "accel/triangulation/free_space_sweep.h"

#include <algorithm>
#include <cassert>

#include "accel/triangulation/gap_order.h"
#include "core/base/prefetch.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

/// Link of a front: the half-edge behind it, as seen from the gap.
using Link = std::uint32_t;
constexpr Link kBoundary = kNone;
/// Bit of a diagonal with the gap on both of its sides; the other bits number it.
constexpr Link kDangling = 0x80000000u;

constexpr std::uint32_t kPointsAhead = 12;     // points
constexpr std::uint32_t kPointsUnasked = 512;  // points between two checks for a stop: some tenths of a millisecond

class Sweep {
 public:
  explicit Sweep(const PlanarMap& map) : map_(map), gap_above_(map.edges.size(), kNone) {
    space_.edge_is_covered.assign(map.edges.size(), 0);
    space_.triangulation.corners.reserve(5 * map.points.size());
    space_.triangulation.twins.reserve(5 * map.points.size());
  }

  std::optional<FreeSpace> run(const Executor& executor) {
    const auto last = static_cast<std::uint32_t>(map_.points.size() - 1);
    const std::uint32_t all = new_gap(0, map_.outside_is_solid ? 1 : 0);
    const std::uint32_t beyond = new_gap(1, 0);
    gaps_[all].above = beyond;
    gaps_[beyond].below = all;
    order_.start(all);
    if (is_free(all)) start_front(all, 0, 1);
    for (std::uint32_t point = 2; point + 1 < last; ++point) {
      if (point % kPointsUnasked == 0) end_if_over(executor);
      fetch_ends(std::min(point + kPointsAhead, last));
      if (!pass(point)) return std::nullopt;
    }
    if (is_free(all)) {
      extend_low_end(all, last - 1, kBoundary);
      extend_high_end(all, last, kBoundary);
    }
    return std::move(space_);
  }

 private:
  struct Gap {
    std::uint32_t edge;          // below the gap
    std::int32_t depth;          // number of valid regions that cover it
    std::uint32_t below, above;  // neighboring gaps
    std::uint32_t low, high;     // ends of the front, on the edges below and above
    std::uint32_t latest;        // rightmost node of the front: visible from the next point
  };
  struct Node {
    std::uint32_t point;
    std::uint32_t below, above;  // nodes
    Link link;                   // to the node above
  };

  [[nodiscard]] bool is_free(std::uint32_t gap) const { return gaps_[gap].depth == 0; }
  [[nodiscard]] const PlanarMap::Edge& edge_below(std::uint32_t gap) const { return map_.edges[gaps_[gap].edge]; }
  [[nodiscard]] int side(const PlanarMap::Edge& e, std::uint32_t point) const {
    return orientation(map_.points[e.low], map_.points[e.high], map_.points[point]);
  }
  [[nodiscard]] bool turns_left(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(map_.points[a], map_.points[b], map_.points[c]) > 0;
  }

  // Prefetches the far ends of the two edges that start just before a point, without branches that would be
  // mispredicted.
  void fetch_ends(std::uint32_t point) const {
    const std::uint32_t end = map_.first_edge[point];
    will_need(&map_.points[map_.edges[end - 1].high]);
    will_need(&map_.points[map_.edges[end - 2].high]);
  }

  bool pass(std::uint32_t point) {
    std::uint32_t below, above;  // gaps below and above the point's edges to the left
    const std::uint32_t first = map_.first_edge[point], last = map_.first_edge[point + 1];
    if (map_.incoming[point] != kNone) {
      above = gap_above_[map_.incoming[point]];
      below = gaps_[above].below;
      while (edge_below(below).high == point) below = gaps_[below].below;
      while (edge_below(gaps_[above].above).high == point) above = gaps_[above].above;
      for (std::uint32_t gap = gaps_[below].above; gap != above;) {
        const std::uint32_t next = gaps_[gap].above;
        close(gap, point);
        gap = next;
      }
      link(below, above);
      if (is_free(below)) extend_high_end(below, point, kBoundary);
      if (is_free(above)) extend_low_end(above, point, kBoundary);
    } else {
      bool on_edge = false;
      below = order_.last_with([&](std::uint32_t gap) {
        const int where = side(edge_below(gap), point);
        on_edge = on_edge || where == 0;
        return where >= 0;
      });
      if (on_edge) return false;
      above = split(below, point);
    }
    if (first == last) {
      merge(below, above);
      return may_be_neighbors(below, gaps_[below].above);
    }
    set_edge(above, last - 1);
    std::int32_t depth = gaps_[below].depth;
    for (std::uint32_t e = first, gap = below; e < last; ++e) {
      const PlanarMap::Edge& edge = map_.edges[e];
      space_.edge_is_covered[e] = depth - edge.below > 0;
      depth += edge.above - edge.below;
      if (e + 1 == last) break;
      const std::uint32_t added = new_gap(e, depth);
      order_.insert_behind(gap, added);
      link(gap, added);
      link(added, above);
      if (depth == 0) start_front(added, point);
      gap = added;
    }
    assert(depth == gaps_[above].depth);
    return may_be_neighbors(below, gaps_[below].above) && may_be_neighbors(above, gaps_[above].above);
  }

  // Whether the edges below two neighboring gaps stay clear of each other up to the first end of one of them.
  [[nodiscard]] bool may_be_neighbors(std::uint32_t gap, std::uint32_t next) const {
    const PlanarMap::Edge& lower = edge_below(gap);
    const PlanarMap::Edge& upper = edge_below(next);
    if (lower.high == upper.high) return true;
    return lower.high < upper.high ? side(upper, lower.high) < 0 : side(lower, upper.high) > 0;
  }

  // Gaps.

  std::uint32_t new_gap(std::uint32_t edge, std::int32_t depth) {
    std::uint32_t gap = static_cast<std::uint32_t>(gaps_.size());
    if (free_gaps_.empty()) {
      gaps_.emplace_back();
    } else {
      gap = free_gaps_.back();
      free_gaps_.pop_back();
    }
    gaps_[gap].depth = depth;
    set_edge(gap, edge);
    return gap;
  }
  void set_edge(std::uint32_t gap, std::uint32_t edge) {
    gaps_[gap].edge = edge;
    gap_above_[edge] = gap;
  }
  void link(std::uint32_t below, std::uint32_t above) {
    gaps_[below].above = above;
    gaps_[above].below = below;
  }
  void remove(std::uint32_t gap) {
    order_.erase(gap);
    free_gaps_.push_back(gap);
  }

  // Closes a gap that ends in a point.
  void close(std::uint32_t gap, std::uint32_t point) {
    if (is_free(gap)) {
      extend_low_end(gap, point, kBoundary);
      free_nodes_.push_back(gaps_[gap].high);
      free_nodes_.push_back(gaps_[gap].low);
    }
    remove(gap);
  }

  // Splits a gap in two at a point within it. Returns the upper one, whose edge is yet to be set.
  std::uint32_t split(std::uint32_t gap, std::uint32_t point) {
    const std::uint32_t upper = new_gap(gaps_[gap].edge, gaps_[gap].depth);
    gap_above_[gaps_[gap].edge] = gap;
    order_.insert_behind(gap, upper);
    link(upper, gaps_[gap].above);
    link(gap, upper);
    if (!is_free(gap)) return upper;
    const std::uint32_t latest = gaps_[gap].latest;
    const std::uint32_t copy = new_node(nodes_[latest].point);
    nodes_[copy].link = nodes_[latest].link;
    if (gaps_[gap].high == latest) {
      gaps_[upper].high = copy;
    } else {
      gaps_[upper].high = gaps_[gap].high;
      join(copy, nodes_[latest].above);
    }
    gaps_[upper].low = copy;
    gaps_[gap].high = latest;
    const Link diagonal = kDangling | static_cast<Link>(dangling_.size());
    dangling_.push_back(kNone);
    extend_high_end(gap, point, diagonal);
    extend_low_end(upper, point, diagonal);
    return upper;
  }

  // Merges two gaps that no edge separates any more.
  void merge(std::uint32_t below, std::uint32_t above) {
    assert(gaps_[below].depth == gaps_[above].depth);
    if (is_free(below)) {
      const std::uint32_t low = gaps_[above].low;
      const std::uint32_t end = gaps_[below].high;
      nodes_[end].link = nodes_[low].link;
      join(end, nodes_[low].above);
      gaps_[below].high = gaps_[above].high;
      gaps_[below].latest = end;
      free_nodes_.push_back(low);
    }
    link(below, gaps_[above].above);
    remove(above);
  }

  // Fronts.

  std::uint32_t new_node(std::uint32_t point) {
    std::uint32_t node = static_cast<std::uint32_t>(nodes_.size());
    if (free_nodes_.empty()) {
      nodes_.emplace_back();
    } else {
      node = free_nodes_.back();
      free_nodes_.pop_back();
    }
    nodes_[node].point = point;
    return node;
  }
  void join(std::uint32_t lower, std::uint32_t upper) {
    nodes_[lower].above = upper;
    nodes_[upper].below = lower;
  }
  void start_front(std::uint32_t gap, std::uint32_t point) {
    gaps_[gap].low = gaps_[gap].high = gaps_[gap].latest = new_node(point);
  }
  void start_front(std::uint32_t gap, std::uint32_t low, std::uint32_t high) {
    gaps_[gap].low = new_node(low);
    gaps_[gap].high = gaps_[gap].latest = new_node(high);
    nodes_[gaps_[gap].low].link = kBoundary;
    join(gaps_[gap].low, gaps_[gap].high);
  }

  // Adds a point before the lower end of a front, after the triangles that it sees. `behind`: half-edge beyond the line
  // from the point to the end.
  void extend_low_end(std::uint32_t gap, std::uint32_t point, Link behind) {
    std::uint32_t end = gaps_[gap].low;
    while (end != gaps_[gap].high && turns_left(nodes_[end].point, point, nodes_[nodes_[end].above].point)) {
      const std::uint32_t above = nodes_[end].above;
      const std::uint32_t h = add_triangle(nodes_[end].point, point, nodes_[above].point);
      connect(h, behind);
      connect(h + 2, nodes_[end].link);
      behind = h + 1;
      free_nodes_.push_back(end);
      end = above;
    }
    const std::uint32_t node = new_node(point);
    join(node, end);
    nodes_[node].link = behind;
    gaps_[gap].low = gaps_[gap].latest = node;
  }

  void extend_high_end(std::uint32_t gap, std::uint32_t point, Link behind) {
    std::uint32_t end = gaps_[gap].high;
    while (end != gaps_[gap].low && turns_left(nodes_[nodes_[end].below].point, point, nodes_[end].point)) {
      const std::uint32_t below = nodes_[end].below;
      const std::uint32_t h = add_triangle(nodes_[below].point, point, nodes_[end].point);
      connect(h + 1, behind);
      connect(h + 2, nodes_[below].link);
      behind = h;
      free_nodes_.push_back(end);
      end = below;
    }
    const std::uint32_t node = new_node(point);
    join(end, node);
    nodes_[end].link = behind;
    gaps_[gap].high = gaps_[gap].latest = node;
  }

  std::uint32_t add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Triangulation& t = space_.triangulation;
    const auto h = static_cast<std::uint32_t>(t.corners.size());
    t.corners.insert(t.corners.end(), {a, b, c});
    t.twins.insert(t.twins.end(), {kNone, kNone, kNone});
    return h;
  }

  void connect(std::uint32_t h, Link link) {
    if (link == kBoundary) return;
    if (link & kDangling) {
      Link& other = dangling_[link & ~kDangling];
      if (other == kNone) {
        other = h;
        return;
      }
      link = other;
    }
    space_.triangulation.twins[h] = link;
    space_.triangulation.twins[link] = h;
  }

  const PlanarMap& map_;
  FreeSpace space_;
  GapOrder order_;
  std::vector<Gap> gaps_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_gaps_, free_nodes_;
  std::vector<Link> dangling_;
  std::vector<std::uint32_t> gap_above_;  // by edge that meets the sweep line
};

}  // namespace

std::optional<FreeSpace> triangulate_free_space(const PlanarMap& map, const Executor& executor) {
  return Sweep(map).run(executor);
}

}  // namespace arcway::internal
