#include "accel/expansion/sleeves.h"

#include <algorithm>
#include <atomic>
#include <tuple>
#include <utility>

#include "core/base/prefetch.h"

namespace arcway::internal {

namespace {

using Sleeve = Sleeves::Sleeve;
using Reach = Sleeves::Reach;

// By half-edge that enters the sleeve.
using SleevesByHalfEdge = std::vector<std::pair<std::uint32_t, Sleeve>>;

// Follows triangles with one boundary edge each, and finds the sleeves among them. The side of the boundary edge
// changes all the time, so it is used as a number where possible: branches on it would be mispredicted.
class Tracer {
 public:
  /// @param is_traced    by triangle: whether some thread has traced it.
  /// @param turns, used  storage for the turns of the sleeves found, and how much of it is in use.
  Tracer(const FreeSpaceTriangulation& triangulation, std::span<std::uint8_t> is_traced, std::span<std::uint32_t> turns,
         std::atomic<std::uint32_t>& used)
      : half_edges_(triangulation.half_edges()),
        nodes_(triangulation.nodes()),
        is_simple_(triangulation.is_simple()),
        is_traced_(is_traced),
        turns_(turns),
        used_(used) {}

  [[nodiscard]] bool is_new(std::uint32_t triangle) const {
    if (std::atomic_ref(is_traced_[triangle]).load(std::memory_order_relaxed) != 0) return false;
    const std::uint32_t half_edge = 3 * triangle;
    const FreeSpaceTriangulation::HalfEdge &first = half_edges_[half_edge], &second = half_edges_[half_edge + 1];
    return (first.left == kNone) + (first.right == kNone) + (second.left == kNone) == 1;
  }

  /// Traces the row of triangles that contains a triangle, in the order that the row's first triangle in memory gives.
  /// Returns that first triangle.
  std::uint32_t trace(std::uint32_t triangle) {
    std::uint32_t half_edge = 3 * triangle;
    while (half_edges_[Triangulation::next(half_edge)].left == kNone) ++half_edge;  // skip the boundary edge
    entrances_.clear();
    mark(triangle);
    const bool is_closed = extend<false>(other_diagonal(half_edge), triangle);
    std::reverse(entrances_.begin(), entrances_.end());
    entrances_.push_back(entrance(half_edge));
    if (!is_closed) extend<true>(half_edge, triangle);
    const std::uint32_t first = std::min_element(entrances_.begin(), entrances_.end())->half_edge() / 3;
    return first == triangle ? first : trace(first);
  }

  /// Finds sleeves of at least `least` triangles in the row. They end where a chain turns back, and at the start of a
  /// ring.
  void find_sleeves(std::uint32_t least, SleevesByHalfEdge& found) {
    struct Side {
      bool has_begun = false;
      std::uint32_t point = 0, node = 0;  // reached last
      bool leads_right = false;
    } sides[2];
    std::size_t first = 0;
    const auto end_at = [&](std::size_t end) {
      if (end >= first + least) add(std::span(entrances_).subspan(first, end - first), found);
      first = end + 1;
      sides[0].has_begun = sides[1].has_begun = false;
    };
    for (std::size_t i = 0; i < entrances_.size(); ++i) {
      const FreeSpaceTriangulation::HalfEdge& ahead = half_edges_[entrances_[i].half_edge()];
      const std::uint32_t is_left = entrances_[i].on_left();
      Side& side = sides[is_left];
      if (!side.has_begun) {
        const FreeSpaceTriangulation::HalfEdge& from = half_edges_[other_diagonal(entrances_[i].half_edge())];
        side = {true, from.point, from.node, from.point < ahead.point};
      }
      const bool leads_right = side.point < ahead.point;
      if (leads_right != side.leads_right || !follows(side.node, ahead.node, 2 * static_cast<int>(is_left) - 1))
        end_at(i);
      side = {true, ahead.point, ahead.node, leads_right};
    }
    end_at(entrances_.size());
  }

 private:
  /// A half-edge into a triangle with one boundary edge, and the side of that edge.
  struct Entrance {
    std::uint32_t half_edge_and_side;
    [[nodiscard]] std::uint32_t half_edge() const { return half_edge_and_side >> 1; }
    [[nodiscard]] std::uint32_t on_left() const { return half_edge_and_side & 1; }
    bool operator<(const Entrance& other) const { return half_edge_and_side < other.half_edge_and_side; }
  };
  [[nodiscard]] Entrance entrance(std::uint32_t half_edge) const {
    return {half_edge << 1 | (half_edges_[half_edge].left == kNone ? 1u : 0u)};
  }

  /// The half-edge that leads on from the triangle behind a half-edge. The other candidate is kNone, which has all bits
  /// set.
  [[nodiscard]] std::uint32_t onward(std::uint32_t half_edge) const {
    static_assert(~kNone == 0);
    return half_edges_[half_edge].left & half_edges_[half_edge].right;
  }
  /// The half-edge back into the triangle behind a half-edge, through its other diagonal.
  [[nodiscard]] std::uint32_t other_diagonal(std::uint32_t half_edge) const {
    return half_edges_[half_edge].left == kNone ? Triangulation::next(half_edge) : Triangulation::previous(half_edge);
  }
  void mark(std::uint32_t triangle) { std::atomic_ref(is_traced_[triangle]).store(1, std::memory_order_relaxed); }

  /// Appends the triangles that follow the one behind a half-edge, as half-edges that lead onward or back. Returns
  /// whether the row closes at `start`.
  template <bool kOn>
  bool extend(std::uint32_t half_edge, std::uint32_t start) {
    half_edge = onward(half_edge);
    while ((half_edges_[half_edge].left == kNone) != (half_edges_[half_edge].right == kNone)) {
      if (half_edge / 3 == start) return true;
      mark(half_edge / 3);
      entrances_.push_back(entrance(kOn ? half_edge : other_diagonal(half_edge)));
      half_edge = onward(half_edge);
    }
    return false;
  }

  /// Whether the chain goes from a node to the next or the previous one; false where a ring begins.
  [[nodiscard]] bool follows(std::uint32_t from, std::uint32_t to, int step) const {
    if (from == kNone || to == kNone || to != from + static_cast<std::uint32_t>(step)) return false;
    return is_simple_ || (nodes_[from].is_simple() && nodes_[to].is_simple());
  }

  /// Adds a sleeve in both directions.
  void add(std::span<const Entrance> entrances, SleevesByHalfEdge& found) {
    const std::uint32_t first_turn =
        used_.fetch_add(static_cast<std::uint32_t>(entrances.size()), std::memory_order_relaxed);
    std::uint32_t left = 0, right = 0;
    for (const Entrance e : entrances) {
      turns_[first_turn + left] = right;
      left += e.on_left();
      right += 1 - e.on_left();
    }
    const std::uint32_t half_edge = entrances.front().half_edge(),
                        back_half_edge = other_diagonal(entrances.back().half_edge());
    Sleeve there{{}, {}, onward(entrances.back().half_edge()), first_turn, false};
    Sleeve back{{}, {}, onward(other_diagonal(half_edge)), first_turn, true};
    const auto is_left = [](const Entrance e) { return e.on_left() != 0; };
    if (left > 0) {
      const auto from = std::find_if(entrances.begin(), entrances.end(), is_left);
      const auto to = std::find_if(entrances.rbegin(), entrances.rend(), is_left);
      std::tie(there.left, back.right) = reaches(from->half_edge(), to->half_edge(), left, 1);
    }
    if (right > 0) {
      const auto from = std::find_if_not(entrances.begin(), entrances.end(), is_left);
      const auto to = std::find_if_not(entrances.rbegin(), entrances.rend(), is_left);
      std::tie(there.right, back.left) = reaches(from->half_edge(), to->half_edge(), right, -1);
    }
    found.push_back({half_edge, there});
    found.push_back({back_half_edge, back});
  }

  /// The chain in both directions.
  /// @param first, last  half-edges into the triangles with the chain's first and last edge.
  /// @param turning      1: counter-clockwise; -1: clockwise.
  [[nodiscard]] std::pair<Reach, Reach> reaches(std::uint32_t first, std::uint32_t last, std::uint32_t count,
                                                int turning) const {
    const auto edge_behind = [&](std::uint32_t half_edge) {
      return (half_edges_[half_edge].apex - half_edges_[other_diagonal(half_edge)].apex).normalized().eval();
    };
    const Vec2 from = edge_behind(first), to = edge_behind(last);
    const double quarters = turning > 0 ? Sleeves::quarters_of_turn(from, to) : Sleeves::quarters_of_turn(to, from);
    const double nodes = quarters > 0.0 ? (count - 1) / quarters : 0.0;
    const auto reach = [&](std::uint32_t half_edge, const Vec2& edge) {
      return Reach{half_edges_[half_edge].node, count, static_cast<float>(edge.x()), static_cast<float>(edge.y()),
                   static_cast<float>(nodes)};
    };
    return {reach(first, from), reach(other_diagonal(last), -to)};
  }

  std::span<const FreeSpaceTriangulation::HalfEdge> half_edges_;
  std::span<const FreeSpaceTriangulation::Node> nodes_;
  bool is_simple_;
  std::span<std::uint8_t> is_traced_;
  std::span<std::uint32_t> turns_;
  std::atomic<std::uint32_t>& used_;
  std::vector<Entrance> entrances_;  // into the triangles of the row traced last
};

bool has_long_convex_chains(const World& world) {
  constexpr std::ptrdiff_t kLong = 32;
  const std::span<const VertexId> convex = world.convex_vertices();
  std::ptrdiff_t count = 0;
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const auto [first, last] = world.vertices_of(o);
    const std::ptrdiff_t size = last - first;
    if (size < kLong) continue;
    const auto turns =
        std::lower_bound(convex.begin(), convex.end(), last) - std::lower_bound(convex.begin(), convex.end(), first);
    if (10 * turns >= 9 * size) count += size;
  }
  return 2 * count > std::ssize(world.vertices());
}

}  // namespace

Sleeves::Sleeves(const FreeSpaceTriangulation& triangulation, std::uint32_t least, const Executor& executor) {
  constexpr std::size_t kTrianglesAtOnce = 1 << 14;
  constexpr std::size_t kTrianglesAhead = 4000;  // triangles to prefetch ahead; neighbors lie in a few tiles of the map
  const std::size_t triangles = triangulation.half_edges().size() / 3;
  turns_.resize(triangles);
  std::atomic<std::uint32_t> turns = 0;
  std::vector<std::uint8_t> is_traced(triangles, 0), is_taken(triangles, 0);
  std::vector<SleevesByHalfEdge> parts(triangles / kTrianglesAtOnce + 1);
  executor.for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    Tracer tracer(triangulation, is_traced, turns_, turns);
    for (std::size_t p = begin; p < end; ++p) {
      const std::size_t behind = std::min((p + 1) * kTrianglesAtOnce, triangles);
      for (auto triangle = static_cast<std::uint32_t>(p * kTrianglesAtOnce); triangle < behind; ++triangle) {
        if (triangle + kTrianglesAhead < triangles) {
          will_need(&triangulation.half_edges()[3 * (triangle + kTrianglesAhead)]);
          will_need(&triangulation.half_edges()[3 * (triangle + kTrianglesAhead) + 2]);
        }
        if (!tracer.is_new(triangle)) continue;
        // Two threads may trace the same row.
        const std::uint32_t first = tracer.trace(triangle);
        if (std::atomic_ref(is_taken[first]).exchange(1, std::memory_order_relaxed) == 0)
          tracer.find_sleeves(least, parts[p]);
      }
    }
  });

  SleevesByHalfEdge all;
  for (const SleevesByHalfEdge& part : parts) all.insert(all.end(), part.begin(), part.end());
  if (all.empty()) return;
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  marks_.resize(triangulation.half_edges().size() / kHalfEdgesPerMark + 1);
  sleeves_.reserve(all.size());
  for (const auto& [half_edge, sleeve] : all) {
    marks_[half_edge / kHalfEdgesPerMark].half_edges |= std::uint64_t{1} << half_edge % kHalfEdgesPerMark;
    sleeves_.push_back(sleeve);
  }
  std::uint32_t before = 0;
  for (Mark& mark : marks_) {
    mark.before = before;
    before += static_cast<std::uint32_t>(std::popcount(mark.half_edges));
  }
}

Sleeves worthwhile_sleeves(const World& world, const FreeSpaceTriangulation& triangulation, const Executor& executor) {
  constexpr std::uint32_t kLeast = 6;
  return has_long_convex_chains(world) ? Sleeves(triangulation, kLeast, executor) : Sleeves();
}

}  // namespace arcway::internal
