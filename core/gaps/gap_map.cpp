#include "core/gaps/gap_map.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "arcway/executor.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/closest_pair.h"
#include "core/geometry/distance.h"
#include "core/geometry/ray_parity.h"

namespace arcway::internal {
namespace {

// How far a third edge has to enter a gap's circle, as shares of its radius and of the largest coordinate: by more than
// distances are rounded. Otherwise each of two edges that follow each other may divide the other's gap.
constexpr double kInside = 1.0 - 1e-6;
constexpr double kGapRounding = 0x1p-48;

bool follow_each_other(const World& world, VertexId a, VertexId b) { return world.next(a) == b || world.next(b) == a; }

// A spatial index of edges, in pieces of consecutive ones.
class EdgePieces {
 public:
  struct Piece {
    VertexId first, last;
    Box box;
  };

  EdgePieces(const World& world, const StopClock& clock) : edges_(world.edges()) {
    StopTicker ticker(clock);
    for (ObstacleId region = 0; region < world.region_count(); ++region) {
      const auto [first, last] = world.vertices_of(region);
      for (VertexId begin = first; begin < last; begin += kMostEdges) {
        end_if_over(ticker);
        add(begin, std::min(begin + kMostEdges, last));
      }
    }
    std::vector<Box> boxes;
    boxes.reserve(pieces_.size());
    for (const Piece& piece : pieces_) boxes.push_back(piece.box);
    tree_ = BoxTree(boxes, clock);
  }

  // Calls visit(a, b) once for any two edges a < b whose boxes are near each other. It goes place by place, so that
  // neighbors of one piece are in the cache for the next.
  template <class Visitor>
  void visit_pairs(double distance, StopTicker& ticker, Visitor&& visit) const {
    const auto visit_those_of = [&](const Piece& piece) {
      end_if_over(ticker);
      tree_.visit_overlaps(piece.box.grown(distance), [&](std::uint32_t p) {
        const Piece& other = pieces_[p];
        if (other.first < piece.first) return true;
        for (VertexId a = piece.first; a < piece.last; ++a) {
          const Box near = box_of(edges_[a]).grown(distance);
          if (!near.overlaps(other.box)) continue;
          for (VertexId b = std::max(a + 1, other.first); b < other.last; ++b)
            if (near.overlaps(box_of(edges_[b]))) visit(a, b);
        }
        return true;
      });
    };
    tree_.visit_if([](const Box&) { return true; },
                   [&](std::uint32_t p) {
                     visit_those_of(pieces_[p]);
                     return true;
                   });
  }

  // Whether some edge that meets a box passes a test.
  template <class Test>
  [[nodiscard]] bool any(const Box& box, Test&& passes) const {
    return !tree_.visit_overlaps(box, [&](std::uint32_t p) {
      for (VertexId e = pieces_[p].first; e < pieces_[p].last; ++e)
        if (box_of(edges_[e]).overlaps(box) && passes(e)) return false;
      return true;
    });
  }

 private:
  static constexpr VertexId kMostEdges = 12;

  void add(VertexId first, VertexId last) {
    Piece piece{first, last, {}};
    for (VertexId e = first; e < last; ++e) piece.box.extend(box_of(edges_[e]));
    pieces_.push_back(piece);
  }

  std::span<const LineSegment> edges_;
  std::vector<Piece> pieces_;
  BoxTree tree_;
};

// Whether a third edge comes into the circle that has the gap for a diameter.
bool is_divided(const World& world, const EdgePieces& pieces, const Gap& gap) {
  const Vec2 middle = 0.5 * (gap.on_a + gap.on_b);
  const double largest = world.box().min.cwiseAbs().cwiseMax(world.box().max.cwiseAbs()).maxCoeff();
  const double radius = 0.5 * gap.width * kInside - kGapRounding * largest;
  if (!(radius > 0.0)) return false;
  const auto divides = [&](VertexId e) {
    return e != gap.edge_a && e != gap.edge_b && distance(middle, world.edges()[e]) < radius;
  };
  // A gap across an obstacle is mostly divided by an edge beside its own.
  for (const VertexId edge : {gap.edge_a, gap.edge_b})
    if (divides(world.next(edge)) || divides(world.previous(edge))) return true;
  return pieces.any(Box{middle, middle}.grown(radius), divides);
}

// Tells two points apart by the parity of crossings with rays from them: a loop that parts them is odd.
class Parting {
 public:
  Parting(const Vec2& from, const Vec2& to) : rays_{ray(from), ray(to)} {}

  template <std::size_t kPoints>
  [[nodiscard]] bool is_odd(const Vec2 (&chain)[kPoints]) const {
    bool odd = false;
    for (StepParity ray : rays_) {
      for (std::size_t i = 0; i + 1 < kPoints; ++i) ray.add(chain[i], chain[i + 1]);
      odd = odd != ray.inside();
    }
    return odd;
  }

 private:
  static StepParity ray(const Vec2& p) { return {p, {p.x() + 1.0, p.y()}}; }

  StepParity rays_[2];
};

// Items joined by even and odd links [union-find with parities].
class ParityForest {
 public:
  explicit ParityForest(std::size_t size) : parent_(size), odd_(size, 0) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  // False if the two were joined by links of the other parity before: an odd loop.
  bool join(std::uint32_t a, std::uint32_t b, bool odd) {
    const bool odd_a = odd_to_root(a);
    const bool odd_b = odd_to_root(b);
    const std::uint32_t root_a = parent_[a], root_b = parent_[b];
    if (root_a == root_b) return odd == (odd_a != odd_b);
    parent_[root_b] = root_a;
    odd_[root_b] = odd != (odd_a != odd_b) ? 1 : 0;
    return true;
  }

 private:
  // Links all items on the path to the root directly to it.
  bool odd_to_root(std::uint32_t a) {
    std::uint32_t root = a;
    bool odd = false;
    for (; parent_[root] != root; root = parent_[root]) odd = odd != (odd_[root] != 0);
    const bool whole = odd;
    while (parent_[a] != root) {
      const std::uint32_t next = parent_[a];
      const bool rest = odd != (odd_[a] != 0);
      parent_[a] = root;
      odd_[a] = odd ? 1 : 0;
      odd = rest;
      a = next;
    }
    return whole;
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> odd_;  // the way to the parent
};

double room_around(const World& world, const Vec2& p, StopTicker& ticker) {
  double least = std::numeric_limits<double>::infinity();
  for (const LineSegment& edge : world.edges()) {
    end_if_over(ticker);
    least = std::min(least, distance(p, edge));
  }
  return 2.0 * least;
}

}  // namespace

GapMap::GapMap(const World& world, double widest, const StopClock& clock) : world_(world) {
  const std::span<const LineSegment> edges = world.edges();
  const EdgePieces pieces(world, clock);
  StopTicker ticker(clock);
  pieces.visit_pairs(widest, ticker, [&](VertexId a, VertexId b) {
    end_if_over(ticker);
    if (follow_each_other(world, a, b)) return;
    const ClosestPair pair = closest_pair(edges[a], edges[b]);
    const Gap gap{pair.distance, a, b, pair.a, pair.b};
    if (gap.width <= widest && !is_divided(world, pieces, gap)) gaps_.push_back(gap);
  });
  std::sort(gaps_.begin(), gaps_.end(), [&ticker](const Gap& a, const Gap& b) {
    end_if_over(ticker);
    return std::tie(a.width, a.edge_a, a.edge_b) < std::tie(b.width, b.edge_a, b.edge_b);
  });
}

std::optional<Gap> GapMap::bottleneck(const Vec2& from, const Vec2& to, const StopClock& clock) const {
  if (from == to) return std::nullopt;
  StopTicker ticker(clock);
  const Parting parting(from, to);
  ParityForest forest(world_.edges().size());  // an edge stands for its first vertex
  for (VertexId v = 0; v < world_.edges().size(); ++v) {
    end_if_over(ticker);
    const auto& [a, b] = world_.edges()[v];
    if (!forest.join(v, world_.next(v), parting.is_odd({a, b}))) return Gap{0.0, v, world_.next(v), b, b};
  }
  const double room = std::min(room_around(world_, from, ticker), room_around(world_, to, ticker));
  for (const Gap& gap : gaps_) {
    end_if_over(ticker);
    if (gap.width >= room) break;
    const bool odd = parting.is_odd({world_.vertex(gap.edge_a), gap.on_a, gap.on_b, world_.vertex(gap.edge_b)});
    if (!forest.join(gap.edge_a, gap.edge_b, odd)) return gap;
  }
  return std::nullopt;
}

}  // namespace arcway::internal
