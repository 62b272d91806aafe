#include "accel/expansion/sight_trace.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/geometry/predicates.h"

namespace arcway::internal {

// From p towards q.
class SightTrace::Line {
 public:
  /// @param passed  gets the sites on the line, if it is not nullptr.
  Line(std::span<const Vec2> sites, const Vec2& p, const Vec2& q, bool endless,
       std::vector<std::uint32_t>* passed = nullptr)
      : p_(p),
        q_(q),
        axis_(p.x() != q.x() ? 0 : 1),
        rises_(q[axis_] > p[axis_]),
        endless_(endless),
        sites_(sites),
        passed_(passed) {}

  [[nodiscard]] const Vec2& start() const { return p_; }
  // +1 if a site lies to the left.
  [[nodiscard]] int side(std::uint32_t site) const { return orientation(p_, q_, sites_[site]); }
  // Whether the line crosses from the right of one site to the left of another between them.
  [[nodiscard]] bool passes_between(std::uint32_t right, std::uint32_t left) const {
    return side(right) < 0 && side(left) > 0;
  }
  // Whether a site lies on the line, beyond a point on it.
  [[nodiscard]] bool has_beyond(const Vec2& point, std::uint32_t site) const {
    const double here = point[axis_], there = sites_[site][axis_];
    return (rises_ ? there > here : there < here) && side(site) == 0;
  }
  // Whether the line ends at a site on it, or before.
  [[nodiscard]] bool ends_before(std::uint32_t site) const {
    const double end = q_[axis_], there = sites_[site][axis_];
    return !endless_ && (rises_ ? end <= there : end >= there);
  }
  // Whether it ends on this side of an edge that it crosses, or on it.
  [[nodiscard]] bool ends_before(std::uint32_t right, std::uint32_t left) const {
    return !endless_ && orientation(sites_[right], sites_[left], q_) >= 0;
  }
  void pass(std::uint32_t site) const {
    if (passed_) passed_->push_back(site);
  }

 private:
  Vec2 p_, q_;
  Eigen::Index axis_;
  bool rises_;
  bool endless_;
  std::span<const Vec2> sites_;
  std::vector<std::uint32_t>* passed_;
};

SightTrace::SightTrace(const SightMap& map) : map_(map) {
  const auto doors = static_cast<std::uint32_t>(map.doors().size());
  std::vector<Box> boxes(doors / 3);
  std::vector<std::uint32_t> sites(doors);
  for (std::uint32_t d = 0; d < doors; ++d) {
    boxes[d / 3].extend(map.doors()[d].apex);
    sites[d] = corner(d - d % 3, d % 3);
  }
  triangles_ = BoxTree(boxes);
  corners_ = BySite(std::move(sites), static_cast<std::uint32_t>(map.sites().size()));
}

void SightTrace::triangles_at(const Vec2& p, std::vector<std::uint32_t>& triangles) const {
  triangles.clear();
  triangles_.visit_overlaps({p, p}, [&](std::uint32_t i) {
    const std::uint32_t t = 3 * i;
    const std::array<Vec2, 3> corners{map_.sites()[corner(t, 0)], map_.sites()[corner(t, 1)],
                                      map_.sites()[corner(t, 2)]};
    bool has = true;
    for (std::size_t k = 0; k < 3 && has; ++k) has = orientation(corners[k], corners[(k + 1) % 3], p) >= 0;
    if (has) triangles.push_back(t);
    return true;
  });
}

std::uint32_t SightTrace::site_at(const Vec2& p, std::span<const std::uint32_t> triangles) const {
  for (const std::uint32_t t : triangles)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (map_.sites()[corner(t, k)] == p) return corner(t, k);
  return kNone;
}

SightTrace::End SightTrace::trace(const Vec2& p, const Vec2& q, std::span<const std::uint32_t> triangles,
                                  bool endless) const {
  const Line line(map_.sites(), p, q, endless);
  if (const std::uint32_t site = site_at(p, triangles); site != kNone) return trace_from_site(line, site);
  for (const std::uint32_t t : triangles)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t right = corner(t, k), left = corner(t, (k + 1) % 3);
      if (line.has_beyond(p, right))
        return line.ends_before(right) ? End{End::Kind::kReached, kNone, kNone} : trace_from_site(line, right);
      if (orientation(map_.sites()[right], map_.sites()[left], p) > 0 && line.passes_between(right, left)) {
        std::uint32_t next = kNone;
        const std::optional<End> end = trace_through(line, door_out(t, k), right, left, next);
        return end ? *end : trace_from_site(line, next);
      }
    }
  // From a wall into the obstacle behind it.
  const std::uint32_t t = triangles.front();
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t a = corner(t, k), b = corner(t, (k + 1) % 3);
    if (orientation(map_.sites()[a], map_.sites()[b], p) == 0) return wall_between(a, b);
  }
  return {End::Kind::kFrame, kNone, kNone};
}

std::optional<SightTrace::End> SightTrace::trace_along_edges(const Vec2& p, const Vec2& q, bool endless) const {
  const Line line(map_.sites(), p, q, endless);
  for (std::uint32_t site = 0; site < map_.sites().size(); ++site)
    for (const PlanarMap::Edge& edge : map_.edges_from(site)) {
      if (is_frame(edge.low) || map_.is_covered(edge) ||
          !on_segment(p, {map_.sites()[edge.low], map_.sites()[edge.high]}))
        continue;
      for (const std::uint32_t end : {edge.low, edge.high})
        if (line.has_beyond(p, end))
          return line.ends_before(end) ? End{End::Kind::kReached, kNone, kNone} : trace_from_site(line, end);
    }
  return std::nullopt;
}

SightTrace::End SightTrace::trace_from_site(const Line& line, std::uint32_t site) const {
  while (true) {
    line.pass(site);
    std::uint32_t next = kNone;
    for (std::size_t i = 0; i < corners_at(site).size() && next == kNone; ++i) {
      const std::uint32_t k = corners_at(site)[i] % 3, t = corners_at(site)[i] - k;
      const std::uint32_t right = corner(t, (k + 1) % 3), left = corner(t, (k + 2) % 3);
      if (line.passes_between(right, left)) {
        if (const auto end = trace_through(line, door_out(t, (k + 1) % 3), right, left, next)) return *end;
      } else {
        for (const std::uint32_t spoke : {right, left})
          if (line.has_beyond(map_.sites()[site], spoke)) next = spoke;
      }
    }
    if (next == kNone) next = next_along_edge(line, site);
    if (next == kNone) return {is_frame(site) ? End::Kind::kFrame : End::Kind::kCorner, site, site};
    if (line.ends_before(next)) return {End::Kind::kReached, kNone, kNone};
    site = next;
  }
}

std::optional<SightTrace::End> SightTrace::trace_through(const Line& line, std::uint32_t door, std::uint32_t right,
                                                         std::uint32_t left, std::uint32_t& next_site) const {
  while (true) {
    if (line.ends_before(right, left)) return End{End::Kind::kReached, kNone, kNone};
    if (door == kNone) return wall_between(right, left);
    const SightMap::Door& triangle = map_.doors()[door];
    const int side = line.side(triangle.site);
    if (side == 0) {
      if (line.ends_before(triangle.site)) return End{End::Kind::kReached, kNone, kNone};
      next_site = triangle.site;
      return std::nullopt;
    }
    (side > 0 ? left : right) = triangle.site;
    door = side > 0 ? triangle.right : triangle.left;
  }
}

SightTrace::End SightTrace::wall_between(std::uint32_t right, std::uint32_t left) const {
  return {is_frame(right) && is_frame(left) ? End::Kind::kFrame : End::Kind::kWall, right, left};
}

void SightTrace::append_sites_on(const Vec2& p, std::uint32_t site, std::vector<std::uint32_t>& sites) const {
  (void)trace_from_site(Line(map_.sites(), p, map_.sites()[site], true, &sites), site);
}

// Between two obstacles that have an edge in common there is no triangle.
std::uint32_t SightTrace::next_along_edge(const Line& line, std::uint32_t site) const {
  const Vec2& here = map_.sites()[site];
  for (const PlanarMap::Edge& edge : map_.edges_from(site))
    if (line.has_beyond(here, edge.high) && !map_.is_covered(edge)) return edge.high;
  for (const std::uint32_t e : map_.edges_to(site))
    if (line.has_beyond(here, map_.edge(e).low) && !map_.is_covered(map_.edge(e))) return map_.edge(e).low;
  return kNone;
}

}  // namespace arcway::internal
