#include "accel/triangulation/short_diagonals.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/prefetch.h"

namespace arcway::internal {

namespace {

// How much shorter a diagonal must become to be flipped.
struct Demand {
  double enough;          // share of the squared length
  double enough_if_long;  // share for long diagonals
  double long_square;     // squared length [m²] from which a diagonal is long
};

// Whether the diagonal c-d surely lies inside the quadrilateral of a, b, c and d, and is short enough to replace a-b.
// Lengths decrease, so flips end.
inline bool is_shorter(const Vec2& c, const Vec2& d, const Vec2& a, const Vec2& b, const Demand& demand) {
  const double ex = b.x() - a.x(), ey = b.y() - a.y();
  const double fx = d.x() - c.x(), fy = d.y() - c.y();
  const double before = ex * ex + ey * ey, after = fx * fx + fy * fy;
  if (!(after < (before > demand.long_square ? demand.enough_if_long : demand.enough) * before)) return false;
  const double a_left = fx * (a.y() - c.y()), a_right = fy * (a.x() - c.x());
  const double b_left = fx * (b.y() - c.y()), b_right = fy * (b.x() - c.x());
  constexpr double kErrorBound = 0x1p-50;
  return a_right - a_left > kErrorBound * (std::abs(a_left) + std::abs(a_right)) &&
         b_left - b_right > kErrorBound * (std::abs(b_left) + std::abs(b_right));
}

double mean_boundary_edge(std::span<const Vec2> points, const Triangulation& t) {
  constexpr std::size_t kStride = 22;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t h = 0; h < t.corners.size(); h += kStride) {
    if (t.twins[h] != kNone) continue;
    sum += (points[t.corners[Triangulation::next(static_cast<std::uint32_t>(h))]] - points[t.corners[h]]).norm();
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

Demand demand_for(Diagonals which, std::span<const Vec2> points, const Triangulation& triangulation) {
  if (which == Diagonals::kAll) return {1.0, 1.0, 0.0};
  const double length = 10.0 * mean_boundary_edge(points, triangulation);
  return {0.12, 0.8, length * length};
}

// Flips diagonals within the half-edges [begin, end) of complete triangles, and touches no others.
class Flipper {
 public:
  Flipper(std::span<const Vec2> points, Triangulation& t, const Demand& demand, std::uint32_t begin, std::uint32_t end)
      : points_(points), corners_(t.corners), twins_(t.twins), demand_(demand), begin_(begin), size_(end - begin) {}

  void flip_all() {
    for (next_ = begin_; next_ < begin_ + size_; ++next_) {
      fetch_ahead();
      if (twins_[next_] != kNone && next_ < twins_[next_]) flip_around(next_);
    }
  }

  void flip_around(std::uint32_t first) {
    suspects_.push_back(first);
    while (!suspects_.empty()) {
      const std::uint32_t h = suspects_.back();
      suspects_.pop_back();
      flip(h);
    }
  }

  /// Half-edges whose flip would have touched others.
  [[nodiscard]] std::span<const std::uint32_t> left_over() const { return left_over_; }

 private:
  // Prefetches what is read soon, without branches that would be mispredicted.
  void fetch_ahead() const {
    constexpr std::uint32_t kFar = 48, kNear = 24;
    if (next_ + kFar >= begin_ + size_) return;
    // Other threads may be flipping beyond the own half-edges.
    const auto beyond = [&](std::uint32_t h) { return is_out(twins_[h]) ? h : twins_[h]; };
    const std::uint32_t far = beyond(next_ + kFar);
    will_need(&corners_[far]);
    will_need(&twins_[far]);
    will_need(&points_[corners_[Triangulation::previous(beyond(next_ + kNear))]]);
  }
  [[nodiscard]] bool is_out(std::uint32_t h) const { return h - begin_ >= size_; }
  [[nodiscard]] bool is_foreign(std::uint32_t h) const { return h != kNone && is_out(h); }

  void flip(std::uint32_t h) {
    const auto next = Triangulation::next;
    const auto previous = Triangulation::previous;
    const std::uint32_t g = twins_[h];
    if (g == kNone) return;
    if (is_out(g)) {
      left_over_.push_back(h);
      return;
    }
    // Triangles (a, b, c) and (b, a, d) lie on both sides of the edge a-b.
    const std::uint32_t bc = next(h), ca = previous(h), ad = next(g), db = previous(g);
    const std::uint32_t a = corners_[h], b = corners_[g], c = corners_[ca], d = corners_[db];
    if (!is_shorter(points_[c], points_[d], points_[a], points_[b], demand_)) return;
    const std::uint32_t beyond_ca = twins_[ca], beyond_db = twins_[db];
    if (is_foreign(beyond_ca) || is_foreign(beyond_db)) {
      left_over_.push_back(h);
      return;
    }
    // They become (d, b, c), in the place of the first, and (c, a, d).
    corners_[h] = d;
    corners_[bc] = b;
    corners_[ca] = c;
    corners_[g] = c;
    corners_[ad] = a;
    corners_[db] = d;
    join(h, beyond_db);
    join(ca, db);
    join(g, beyond_ca);
    // The other two outer edges stay where they are.
    for (const std::uint32_t outer : {h, bc, g, ad}) suspect(outer);
  }

  // Adds a half-edge to check again, unless flip_all is yet to come to it.
  void suspect(std::uint32_t h) {
    if (twins_[h] != kNone && std::min(h, twins_[h]) <= next_) suspects_.push_back(h);
  }

  void join(std::uint32_t h, std::uint32_t twin) {
    twins_[h] = twin;
    if (twin != kNone) twins_[twin] = h;
  }

  std::span<const Vec2> points_;
  BigVector<std::uint32_t>& corners_;
  BigVector<std::uint32_t>& twins_;
  Demand demand_;
  std::uint32_t begin_, size_;
  std::uint32_t next_ = kNone;  // half-edge that flip_all is at
  std::vector<std::uint32_t> suspects_;
  std::vector<std::uint32_t> left_over_;
};

}  // namespace

void shorten_diagonals(std::span<const Vec2> points, Triangulation& triangulation, Diagonals which,
                       const Executor& executor) {
  constexpr std::uint32_t kBlock = 3 * 16384;
  const auto size = static_cast<std::uint32_t>(triangulation.corners.size());
  const std::size_t blocks = (size + kBlock - 1) / kBlock;
  const Demand demand = demand_for(which, points, triangulation);
  std::vector<std::vector<std::uint32_t>> seams(blocks);
  executor.for_ranges(blocks, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      const auto begin = static_cast<std::uint32_t>(block) * kBlock;
      Flipper flipper(points, triangulation, demand, begin, std::min(begin + kBlock, size));
      flipper.flip_all();
      seams[block].assign(flipper.left_over().begin(), flipper.left_over().end());
    }
  });
  Flipper whole(points, triangulation, demand, 0, size);
  for (const auto& seam : seams)
    for (const std::uint32_t h : seam) whole.flip_around(h);
}

}  // namespace arcway::internal
