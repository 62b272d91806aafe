#include "accel/triangulation/delaunay_flips.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace arcway {

namespace {

// Whether d surely lies inside the circle through the counter-clockwise triangle a, b, c.
bool surely_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double ax = a.x() - d.x(), ay = a.y() - d.y();
  const double bx = b.x() - d.x(), by = b.y() - d.y();
  const double cx = c.x() - d.x(), cy = c.y() - d.y();
  const double bxcy = bx * cy, cxby = cx * by;
  const double cxay = cx * ay, axcy = ax * cy;
  const double axby = ax * by, bxay = bx * ay;
  const double a_lift = ax * ax + ay * ay;
  const double b_lift = bx * bx + by * by;
  const double c_lift = cx * cx + cy * cy;
  const double determinant = a_lift * (bxcy - cxby) + b_lift * (cxay - axcy) + c_lift * (axby - bxay);
  const double magnitude = (std::abs(bxcy) + std::abs(cxby)) * a_lift + (std::abs(cxay) + std::abs(axcy)) * b_lift +
                           (std::abs(axby) + std::abs(bxay)) * c_lift;
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kErrorBound = (10.0 + 96.0 * kEpsilon) * kEpsilon;  // [Shewchuk 1997, section 4.4]
  constexpr double kUnderflow = 1e-300;  // differences of coordinates are 0 or above 1e-116: only the last products
  return determinant > kErrorBound * magnitude + kUnderflow;
}

// Flips within the half-edges [begin, end) of whole triangles, and touches no others.
class Flipper {
 public:
  Flipper(std::span<const Vec2> sites, Triangulation& t, std::uint32_t begin, std::uint32_t end)
      : sites_(sites), corners_(t.corners), twins_(t.twins), begin_(begin), size_(end - begin) {}

  void flip_all() {
    for (std::uint32_t h = begin_; h < begin_ + size_; ++h)
      if (twins_[h] != kNone && h < twins_[h]) flip_around(h);
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
    // Triangles (a, b, c) and (b, a, d) on both sides of the edge a-b.
    const std::uint32_t bc = next(h), ca = previous(h), ad = next(g), db = previous(g);
    const std::uint32_t a = corners_[h], b = corners_[g], c = corners_[ca], d = corners_[db];
    if (!surely_in_circle(sites_[a], sites_[b], sites_[c], sites_[d])) return;
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
    suspects_.insert(suspects_.end(), {h, bc, g, ad});
  }

  void join(std::uint32_t h, std::uint32_t twin) {
    twins_[h] = twin;
    if (twin != kNone) twins_[twin] = h;
  }

  std::span<const Vec2> sites_;
  std::vector<std::uint32_t>& corners_;
  std::vector<std::uint32_t>& twins_;
  std::uint32_t begin_, size_;
  std::vector<std::uint32_t> suspects_;
  std::vector<std::uint32_t> left_over_;
};

}  // namespace

void flip_towards_delaunay(std::span<const Vec2> sites, Triangulation& triangulation, const Executor& executor) {
  constexpr std::uint32_t kBlock = 3 * 16384;
  const auto size = static_cast<std::uint32_t>(triangulation.corners.size());
  const std::size_t blocks = (size + kBlock - 1) / kBlock;
  std::vector<std::vector<std::uint32_t>> seams(blocks);
  executor.for_ranges(blocks, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      const auto begin = static_cast<std::uint32_t>(block) * kBlock;
      Flipper flipper(sites, triangulation, begin, std::min(begin + kBlock, size));
      flipper.flip_all();
      seams[block].assign(flipper.left_over().begin(), flipper.left_over().end());
    }
  });
  Flipper whole(sites, triangulation, 0, size);
  for (const auto& seam : seams)
    for (const std::uint32_t h : seam) whole.flip_around(h);
}

}  // namespace arcway
