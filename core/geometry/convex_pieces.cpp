#include "core/geometry/convex_pieces.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

struct Diagonal {
  std::size_t from, to;
  int resolved;    // number of reflex angles that it leaves none of
  double length2;  // square of its length
  [[nodiscard]] bool is_better_than(const Diagonal& other) const {
    return resolved != other.resolved ? resolved > other.resolved : length2 < other.length2;
  }
};

// A ring by its cyclic index.
struct Corners {
  const Ring& ring;
  [[nodiscard]] std::size_t size() const { return ring.size(); }
  const Vec2& operator[](std::size_t i) const { return ring[i % ring.size()]; }
  [[nodiscard]] const Vec2& before(std::size_t i) const { return ring[(i + ring.size() - 1) % ring.size()]; }
  [[nodiscard]] bool is_reflex(std::size_t i) const { return orientation(before(i), ring[i], (*this)[i + 1]) < 0; }
  // Whether the angle at a vertex towards another one lies in the ring.
  [[nodiscard]] bool opens_to(std::size_t i, const Vec2& p) const {
    return in_open_cone(before(i), ring[i], (*this)[i + 1], p);
  }
  // Whether a reflex vertex has no reflex angle to either side of the way to a point.
  [[nodiscard]] bool is_resolved(std::size_t i, const Vec2& p) const {
    return is_reflex(i) && orientation(before(i), ring[i], p) >= 0 && orientation(p, ring[i], (*this)[i + 1]) >= 0;
  }
};

bool is_inside(const Corners& corners, std::size_t from, std::size_t to) {
  const LineSegment diagonal{corners[from], corners[to]};
  if (!corners.opens_to(from, diagonal.b) || !corners.opens_to(to, diagonal.a)) return false;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (i == from || i == to || next == from || next == to) continue;
    if (relate({corners[i], corners[next]}, diagonal) != SegmentRelation::kDisjoint) return false;
  }
  return true;
}

// The best diagonal from a reflex vertex; nothing if there is none.
std::optional<Diagonal> best_cut(const Ring& ring) {
  const Corners corners{ring};
  std::optional<Diagonal> best;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!corners.is_reflex(i)) continue;
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const int resolved = int{corners.is_resolved(i, ring[j])} + int{corners.is_resolved(j, ring[i])};
      const Diagonal cut{i, j, resolved, (ring[j] - ring[i]).squaredNorm()};
      if (i != j && (!best || cut.is_better_than(*best)) && is_inside(corners, i, j)) best = cut;
    }
  }
  return best;
}

// The ring from one vertex on up to another.
Ring part_of(const Ring& ring, std::size_t from, std::size_t to) {
  Ring part;
  for (std::size_t i = from; i != to; i = (i + 1) % ring.size()) part.push_back(ring[i]);
  part.push_back(ring[to]);
  return part;
}

// Whether a line through a side of the first one has the second one on its outer side.
bool is_beside(std::span<const Vec2> a, std::span<const Vec2> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 &from = a[i], &to = a[(i + 1) % a.size()];
    if (std::ranges::all_of(b, [&](const Vec2& p) { return orientation(from, to, p) <= 0; })) return true;
  }
  return false;
}

}  // namespace

std::vector<Ring> convex_pieces(const Ring& ring) {
  std::vector<Ring> pieces, open{ring};
  while (!open.empty()) {
    const Ring next = std::move(open.back());
    open.pop_back();
    if (const auto cut = best_cut(next)) {
      open.push_back(part_of(next, cut->from, cut->to));
      open.push_back(part_of(next, cut->to, cut->from));
    } else {
      pieces.push_back(without_straight_corners(next));
    }
  }
  return pieces;
}

Ring without_straight_corners(const Ring& ring) {
  Ring result;
  const Corners corners{ring};
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (orientation(corners.before(i), ring[i], corners[i + 1]) != 0) result.push_back(ring[i]);
  return result;
}

bool interiors_meet(std::span<const Vec2> a, std::span<const Vec2> b) { return !is_beside(a, b) && !is_beside(b, a); }

}  // namespace arcway::internal
