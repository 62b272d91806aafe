#include "datasets/grid/simplify.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "core/geometry/box_tree.h"

namespace arcway::internal {
namespace {

using Index = std::uint32_t;

constexpr std::size_t kLongestChain = 1000;  // corners that one edge replaces

// Twice the area of a triangle, positive if counter-clockwise; exact.
std::int64_t area(const Corner& a, const Corner& b, const Corner& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

double distance(const Corner& p, const Corner& a, const Corner& b) {
  const auto vector = [](const Corner& from, const Corner& to) {
    return Vec2(static_cast<double>(to.x) - from.x, static_cast<double>(to.y) - from.y);
  };
  const Vec2 ab = vector(a, b), ap = vector(a, p);
  const double along = std::clamp(ap.dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (ap - along * ab).norm();
}

Box box_around(std::initializer_list<Corner> corners) {
  Box box;
  for (const Corner& c : corners) box.extend(Vec2(c.x, c.y));
  return box;
}

class Simplifier {
 public:
  Simplifier(std::vector<CornerPolygon>& polygons, double tolerance) : polygons_(polygons), tolerance_(tolerance) {
    for (const CornerPolygon& polygon : polygons_) {
      for (const CornerRing& ring : polygon) {
        const auto first = static_cast<Index>(corners_.size());
        const auto n = static_cast<Index>(ring.size());
        for (Index i = 0; i < n; ++i) {
          corners_.push_back(ring[i]);
          next_.push_back(first + (i + 1) % n);
          previous_.push_back(first + (i + n - 1) % n);
          original_next_.push_back(next_.back());
        }
        ring_sizes_.push_back(n);
        ring_of_.resize(corners_.size(), static_cast<Index>(ring_sizes_.size() - 1));
      }
    }
    alive_.assign(corners_.size(), true);
    version_.assign(corners_.size(), 0);
    std::vector<Box> boxes(corners_.size());
    for (std::size_t v = 0; v < corners_.size(); ++v) boxes[v] = box_around({corners_[v]});
    tree_ = BoxTree(boxes);
  }

  void run() {
    for (Index v = 0; v < corners_.size(); ++v) propose(v);
    while (!queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      // If something is in the way now, the corner stays, even if that should go later.
      if (!alive_[best.corner] || best.version != version_[best.corner]) continue;
      if (ring_sizes_[ring_of_[best.corner]] > 3 && is_free(best.corner)) take(best.corner);
    }
    write_back();
  }

 private:
  struct Candidate {
    double deviation;
    std::size_t chain;
    Index corner;
    std::uint32_t version;
    bool operator<(const Candidate& other) const {  // the queue's top is the greatest
      return std::tie(other.deviation, other.chain, other.corner) < std::tie(deviation, chain, corner);
    }
  };

  void propose(Index v) {
    const Index p = previous_[v], q = next_[v];
    if (corners_[p] == corners_[q]) return;
    if (area(corners_[p], corners_[v], corners_[q]) > 0) return;  // it would uncover the triangle
    double deviation = 0.0;
    std::size_t chain = 0;
    for (Index w = original_next_[p]; w != q; w = original_next_[w], ++chain) {
      if (chain == kLongestChain) return;
      deviation = std::max(deviation, distance(corners_[w], corners_[p], corners_[q]));
      if (deviation > tolerance_) return;
    }
    queue_.push({deviation, chain, v, version_[v]});
  }

  // Whether the triangle of v and its neighbors holds no other corner and the new edge is not there already.
  [[nodiscard]] bool is_free(Index v) const {
    const Index p = previous_[v], q = next_[v];
    const Corner &a = corners_[p], &b = corners_[v], &c = corners_[q];
    bool free = true;
    tree_.visit_overlaps(box_around({a, b, c}), [&](std::uint32_t w) {
      if (!alive_[w] || w == p || w == v || w == q) return true;
      const Corner& d = corners_[w];
      if (d == a || d == c) {
        const Corner& other = d == a ? c : a;
        free = corners_[next_[w]] != other && corners_[previous_[w]] != other;
      } else if (d != b) {
        // Clockwise or flat: nothing strictly to the left of a side is in it.
        free = area(a, b, d) > 0 || area(b, c, d) > 0 || area(c, a, d) > 0;
      }
      return free;
    });
    return free;
  }

  void take(Index v) {
    const Index p = previous_[v], q = next_[v];
    alive_[v] = false;
    next_[p] = q;
    previous_[q] = p;
    --ring_sizes_[ring_of_[v]];
    for (const Index w : {p, q}) {
      ++version_[w];
      propose(w);
    }
  }

  void write_back() {
    Index v = 0;
    for (CornerPolygon& polygon : polygons_) {
      for (CornerRing& ring : polygon) {
        const Index end = v + static_cast<Index>(ring.size());
        ring.clear();
        for (; v < end; ++v)
          if (alive_[v]) ring.push_back(corners_[v]);
      }
    }
  }

  std::vector<CornerPolygon>& polygons_;
  double tolerance_;
  std::vector<Corner> corners_;
  std::vector<Index> next_, previous_, original_next_, ring_of_;
  std::vector<std::size_t> ring_sizes_;
  std::vector<bool> alive_;
  std::vector<std::uint32_t> version_;
  BoxTree tree_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

void simplify(std::vector<CornerPolygon>& polygons, double tolerance) {
  if (tolerance > 0.0) Simplifier(polygons, tolerance).run();
}

std::size_t corner_count(const std::vector<CornerPolygon>& polygons) {
  std::size_t count = 0;
  for (const CornerPolygon& polygon : polygons)
    for (const CornerRing& ring : polygon) count += ring.size();
  return count;
}

}  // namespace arcway::internal
