#include "accel/expansion/line_of_sight_trace.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/geometry/predicates.h"

namespace arcway::internal {

// A ray or segment from p towards q.
class LineOfSightTrace::Line {
 public:
  /// @param passed  gets the points on the line, if it is not nullptr.
  Line(std::span<const Vec2> points, const Vec2& p, const Vec2& q, bool endless,
       std::vector<std::uint32_t>* passed = nullptr)
      : p_(p),
        q_(q),
        axis_(p.x() != q.x() ? 0 : 1),
        rises_(q[axis_] > p[axis_]),
        endless_(endless),
        points_(points),
        passed_(passed) {}

  [[nodiscard]] const Vec2& start() const { return p_; }
  // +1 if a point lies to the left.
  [[nodiscard]] int side(std::uint32_t point) const { return orientation(p_, q_, points_[point]); }
  // Whether the line crosses from the right of one point to the left of another between them.
  [[nodiscard]] bool passes_between(std::uint32_t right, std::uint32_t left) const {
    return side(right) < 0 && side(left) > 0;
  }
  // Whether a point lies on the line, beyond a point on it.
  [[nodiscard]] bool has_beyond(const Vec2& from, std::uint32_t point) const {
    const double here = from[axis_], there = points_[point][axis_];
    return (rises_ ? there > here : there < here) && side(point) == 0;
  }
  // Whether the line ends at a point on it, or before.
  [[nodiscard]] bool ends_before(std::uint32_t point) const {
    const double end = q_[axis_], there = points_[point][axis_];
    return !endless_ && (rises_ ? end <= there : end >= there);
  }
  // Whether it ends on this side of an edge that it crosses, or on it.
  [[nodiscard]] bool ends_before(std::uint32_t right, std::uint32_t left) const {
    return !endless_ && orientation(points_[right], points_[left], q_) >= 0;
  }
  void pass(std::uint32_t point) const {
    if (passed_) passed_->push_back(point);
  }

 private:
  Vec2 p_, q_;
  Eigen::Index axis_;
  bool rises_;
  bool endless_;
  std::span<const Vec2> points_;
  std::vector<std::uint32_t>* passed_;
};

LineOfSightTrace::LineOfSightTrace(const FreeSpaceTriangulation& triangulation) : triangulation_(triangulation) {
  const auto half_edges = static_cast<std::uint32_t>(triangulation.half_edges().size());
  std::vector<Box> boxes(half_edges / 3);
  std::vector<std::uint32_t> points(half_edges);
  for (std::uint32_t d = 0; d < half_edges; ++d) {
    boxes[d / 3].extend(triangulation.half_edges()[d].apex);
    points[d] = corner(d - d % 3, d % 3);
  }
  triangles_ = BoxTree(boxes);
  corners_ = BucketIndex(std::move(points), static_cast<std::uint32_t>(triangulation.points().size()));
}

void LineOfSightTrace::triangles_at(const Vec2& p, std::vector<std::uint32_t>& triangles) const {
  triangles.clear();
  triangles_.visit_overlaps({p, p}, [&](std::uint32_t i) {
    const std::uint32_t t = 3 * i;
    const std::array<Vec2, 3> corners{triangulation_.points()[corner(t, 0)], triangulation_.points()[corner(t, 1)],
                                      triangulation_.points()[corner(t, 2)]};
    bool has = true;
    for (std::size_t k = 0; k < 3 && has; ++k) has = orientation(corners[k], corners[(k + 1) % 3], p) >= 0;
    if (has) triangles.push_back(t);
    return true;
  });
}

std::uint32_t LineOfSightTrace::point_at(const Vec2& p, std::span<const std::uint32_t> triangles) const {
  for (const std::uint32_t t : triangles)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (triangulation_.points()[corner(t, k)] == p) return corner(t, k);
  return kNone;
}

LineOfSightTrace::End LineOfSightTrace::trace(const Vec2& p, const Vec2& q, std::span<const std::uint32_t> triangles,
                                              bool endless) const {
  const Line line(triangulation_.points(), p, q, endless);
  if (const std::uint32_t point = point_at(p, triangles); point != kNone) return trace_from_point(line, point);
  for (const std::uint32_t t : triangles)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t right = corner(t, k), left = corner(t, (k + 1) % 3);
      if (line.has_beyond(p, right))
        return line.ends_before(right) ? End{End::Kind::kReached, kNone, kNone} : trace_from_point(line, right);
      if (orientation(triangulation_.points()[right], triangulation_.points()[left], p) > 0 &&
          line.passes_between(right, left)) {
        std::uint32_t next = kNone;
        const std::optional<End> end = trace_through(line, half_edge_out(t, k), right, left, next);
        return end ? *end : trace_from_point(line, next);
      }
    }
  // The line leads from a boundary edge into the obstacle behind it.
  const std::uint32_t t = triangles.front();
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t a = corner(t, k), b = corner(t, (k + 1) % 3);
    if (orientation(triangulation_.points()[a], triangulation_.points()[b], p) == 0) return boundary_between(a, b);
  }
  return {End::Kind::kFrame, kNone, kNone};
}

std::optional<LineOfSightTrace::End> LineOfSightTrace::trace_along_edges(const Vec2& p, const Vec2& q,
                                                                         bool endless) const {
  const Line line(triangulation_.points(), p, q, endless);
  for (std::uint32_t point = 0; point < triangulation_.points().size(); ++point)
    for (const PlanarMap::Edge& edge : triangulation_.edges_from(point)) {
      if (is_frame(edge.low) || triangulation_.is_covered(edge) ||
          !on_segment(p, {triangulation_.points()[edge.low], triangulation_.points()[edge.high]}))
        continue;
      for (const std::uint32_t end : {edge.low, edge.high})
        if (line.has_beyond(p, end))
          return line.ends_before(end) ? End{End::Kind::kReached, kNone, kNone} : trace_from_point(line, end);
    }
  return std::nullopt;
}

LineOfSightTrace::End LineOfSightTrace::trace_from_point(const Line& line, std::uint32_t point) const {
  while (true) {
    line.pass(point);
    std::uint32_t next = kNone;
    for (std::size_t i = 0; i < corners_at(point).size() && next == kNone; ++i) {
      const std::uint32_t k = corners_at(point)[i] % 3, t = corners_at(point)[i] - k;
      const std::uint32_t right = corner(t, (k + 1) % 3), left = corner(t, (k + 2) % 3);
      if (line.passes_between(right, left)) {
        if (const auto end = trace_through(line, half_edge_out(t, (k + 1) % 3), right, left, next)) return *end;
      } else {
        for (const std::uint32_t spoke : {right, left})
          if (line.has_beyond(triangulation_.points()[point], spoke)) next = spoke;
      }
    }
    if (next == kNone) next = next_along_edge(line, point);
    if (next == kNone) return {is_frame(point) ? End::Kind::kFrame : End::Kind::kCorner, point, point};
    if (line.ends_before(next)) return {End::Kind::kReached, kNone, kNone};
    point = next;
  }
}

std::optional<LineOfSightTrace::End> LineOfSightTrace::trace_through(const Line& line, std::uint32_t half_edge,
                                                                     std::uint32_t right, std::uint32_t left,
                                                                     std::uint32_t& next_point) const {
  while (true) {
    if (line.ends_before(right, left)) return End{End::Kind::kReached, kNone, kNone};
    if (half_edge == kNone) return boundary_between(right, left);
    const FreeSpaceTriangulation::HalfEdge& triangle = triangulation_.half_edges()[half_edge];
    const int side = line.side(triangle.point);
    if (side == 0) {
      if (line.ends_before(triangle.point)) return End{End::Kind::kReached, kNone, kNone};
      next_point = triangle.point;
      return std::nullopt;
    }
    (side > 0 ? left : right) = triangle.point;
    half_edge = side > 0 ? triangle.right : triangle.left;
  }
}

LineOfSightTrace::End LineOfSightTrace::boundary_between(std::uint32_t right, std::uint32_t left) const {
  return {is_frame(right) && is_frame(left) ? End::Kind::kFrame : End::Kind::kBoundary, right, left};
}

void LineOfSightTrace::append_points_on(const Vec2& p, std::uint32_t point, std::vector<std::uint32_t>& points) const {
  (void)trace_from_point(Line(triangulation_.points(), p, triangulation_.points()[point], true, &points), point);
}

// Two obstacles with a common edge have no triangle between them, but the edge itself is a line of sight.
std::uint32_t LineOfSightTrace::next_along_edge(const Line& line, std::uint32_t point) const {
  const Vec2& here = triangulation_.points()[point];
  for (const PlanarMap::Edge& edge : triangulation_.edges_from(point))
    if (line.has_beyond(here, edge.high) && !triangulation_.is_covered(edge)) return edge.high;
  for (const std::uint32_t e : triangulation_.edges_to(point))
    if (line.has_beyond(here, triangulation_.edge(e).low) && !triangulation_.is_covered(triangulation_.edge(e)))
      return triangulation_.edge(e).low;
  return kNone;
}

}  // namespace arcway::internal
