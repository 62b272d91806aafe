#include "core/gaps/minimum_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/geometry/closest_pair.h"

namespace arcway::internal {
namespace {

void lower(ClosestPair& best, const LineSegment& s, const LineSegment& t) {
  if (box_of(s).distance_to(box_of(t)) >= best.distance) return;
  const ClosestPair pair = closest_pair(s, t);
  if (pair.distance < best.distance) best = pair;
}

ClosestPair between(const World& world, const LineSegment& s, ObstacleId o, ClosestPair best = {}) {
  const auto [first, last] = world.vertices_of(o);
  for (VertexId v = first; v < last; ++v) lower(best, s, world.edges()[v]);
  return best;
}

ClosestPair between(const World& world, ObstacleId a, ObstacleId b) {
  ClosestPair best;
  const auto [first, last] = world.vertices_of(a);
  for (VertexId v = first; v < last; ++v) {
    const LineSegment& edge = world.edges()[v];
    if (box_of(edge).distance_to(world.box_of(b)) < best.distance) best = between(world, edge, b, best);
  }
  return best;
}

/// The half-plane of the points p with (p - origin) . normal >= 0.
struct HalfPlane {
  Vec2 origin;
  Vec2 normal;
  [[nodiscard]] double depth(const Vec2& p) const { return (p - origin).dot(normal); }
};

/// The corners of a ring's part in a half-plane [Sutherland and Hodgman 1974].
std::vector<Vec2> clip(const std::vector<Vec2>& ring, const HalfPlane& half_plane) {
  std::vector<Vec2> part;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    const double da = half_plane.depth(a);
    const double db = half_plane.depth(b);
    if (da >= 0.0) part.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) part.emplace_back(a + da / (da - db) * (b - a));
  }
  return part;
}

std::vector<Vec2> outer_ring(const World& world, ObstacleId o) {
  const auto starts = world.ring_starts(o);
  const VertexId last = starts.size() > 1 ? starts[1] : world.vertices_of(o).last;
  return {world.vertices().begin() + starts[0], world.vertices().begin() + last};
}

class Regions {
 public:
  explicit Regions(std::span<const Vec2> path) : path_(path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) directions_.push_back((path[i + 1] - path[i]).normalized());
  }

  /// The side of segment i that an obstacle lies on within the segment's region; nothing if outside of it.
  [[nodiscard]] std::optional<Side> side_of(std::vector<Vec2> ring, std::size_t i) const {
    if (i > 0) ring = clip(ring, {path_[i], along(i)});
    if (i + 1 < directions_.size()) ring = clip(ring, {path_[i + 1], -along(i + 1)});
    double low = 0.0;
    double high = 0.0;
    for (const Vec2& p : ring) {
      const double offset = cross(directions_[i], p - path_[i]);
      low = std::min(low, offset);
      high = std::max(high, offset);
    }
    if (low == 0.0 && high == 0.0) return std::nullopt;
    return high >= -low ? Side::kLeft : Side::kRight;
  }

 private:
  /// Normal of the bisector at turn point i, pointing along the path.
  [[nodiscard]] Vec2 along(std::size_t i) const {
    const Vec2 sum = directions_[i - 1] + directions_[i];
    return sum.norm() > 0.0 ? Vec2(sum.normalized()) : directions_[i - 1];
  }

  std::span<const Vec2> path_;
  std::vector<Vec2> directions_;
};

void check(std::span<const Vec2> path) {
  if (path.size() < 2) {
    throw std::invalid_argument("minimum_distances: the path has " + std::to_string(path.size()) +
                                " points, must have >= 2");
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!path[i].allFinite()) {
      throw std::invalid_argument("minimum_distances: point " + std::to_string(i) + " is not finite");
    }
    if (i > 0 && path[i] == path[i - 1]) {
      throw std::invalid_argument("minimum_distances: point " + std::to_string(i) + " repeats the one before");
    }
  }
}

std::vector<ObstacleId>& of(RadialSet& set, Side side) { return side == Side::kLeft ? set.left : set.right; }

}  // namespace

MinimumDistances minimum_distances(const World& world, std::span<const Vec2> path) {
  check(path);
  const Regions regions(path);
  const std::size_t segments = path.size() - 1;
  MinimumDistances result;
  result.by_segment.resize(segments);

  for (ObstacleId o = 0; o < world.obstacle_count(); ++o) {
    const std::vector<Vec2> ring = outer_ring(world, o);
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<Side> side_there;
    for (std::size_t i = 0; i < segments; ++i) {
      const std::optional<Side> side = regions.side_of(ring, i);
      if (!side) continue;
      of(result.by_segment[i], *side).push_back(o);
      const ClosestPair pair = between(world, {path[i], path[i + 1]}, o);
      result.to_segments.push_back({i, o, *side, pair.distance, pair.a, pair.b});
      if (!side_there || pair.distance < nearest) {
        nearest = pair.distance;
        side_there = side;
      }
    }
    if (side_there) of(result.obstacles, *side_there).push_back(o);
  }
  std::stable_sort(result.to_segments.begin(), result.to_segments.end(),
                   [](const auto& a, const auto& b) { return a.segment < b.segment; });

  std::map<std::pair<ObstacleId, ObstacleId>, ClosestPair> known;  // neighboring regions share pairs
  for (std::size_t i = 0; i < segments; ++i) {
    for (const ObstacleId left : result.by_segment[i].left) {
      for (const ObstacleId right : result.by_segment[i].right) {
        const auto [place, is_new] = known.try_emplace({left, right});
        if (is_new) place->second = between(world, left, right);
        result.pairs.push_back({i, left, right, place->second.distance, place->second.a, place->second.b});
      }
    }
  }
  return result;
}

}  // namespace arcway::internal
