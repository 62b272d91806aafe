#include "core/graph/feasible_graph.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace arcway {

namespace {

enum class Verdict : std::uint8_t { kKept, kOverlap, kDeparture, kArrival, kStraight };

struct Candidate {
  FeasibleGraph::Link link;
  Verdict verdict;
};

}  // namespace

FeasibleGraph::FeasibleGraph(const World& world, const Vehicle& vehicle, const VisibilityGraph& graph,
                             const QuerySet& queries, std::span<const double> radii, const Executor& executor) {
  const Footprint planned = vehicle.footprint(vehicle.safety_margin());
  const Footprint checked = vehicle.footprint(0.5 * vehicle.safety_margin());
  const std::span<const VertexId> vertices = world.convex_vertices();
  const std::size_t radius_count = radii.size();

  std::vector<std::uint32_t> first_circle(world.vertices().size(), kNone);
  for (const VertexId v : vertices) {
    first_circle[v] = static_cast<std::uint32_t>(circles_.size());
    for (const double radius : radii)
      for (const Side side : {Side::kLeft, Side::kRight})
        circles_.push_back(turn_circle(world, v, radius, side, planned));
  }
  free_headings_.resize(circles_.size());
  executor.for_ranges(circles_.size(), 16, [&](std::size_t begin, std::size_t end) {
    std::vector<TurningBody> bodies;
    for (std::size_t c = begin; c < end; ++c)
      bodies.push_back({circles_[c].center, circles_[c].radius, circles_[c].side, checked});
    queries.sweep->free_headings(bodies, std::span(free_headings_).subspan(begin, end - begin));
  });

  const auto circle_of = [&](VertexId v, std::size_t radius, Side side) {
    return first_circle[v] + static_cast<std::uint32_t>(2 * radius + (side == Side::kLeft ? 0 : 1));
  };
  std::vector<Candidate> candidates(graph.edge_count() * radius_count * radius_count * 2);
  executor.for_ranges(graph.vertex_count(), 16, [&](std::size_t begin, std::size_t end) {
    std::vector<SweptRectangle> rectangles;
    std::vector<std::size_t> waiting;
    std::vector<std::uint8_t> free;
    for (std::size_t i = begin; i < end; ++i) {
      const auto u = static_cast<VertexId>(i);
      std::size_t next = graph.row_starts()[u] * radius_count * radius_count * 2;
      rectangles.clear();
      waiting.clear();
      const auto consider = [&](std::uint32_t from, std::uint32_t to) {
        Candidate& candidate = candidates[next];
        candidate.link = {from, to, 0.0, 0.0};
        const auto bitangent = directed_bitangent(circles_[from], circles_[to]);
        if (!bitangent) {
          candidate.verdict = Verdict::kOverlap;
        } else {
          candidate.link.heading = bitangent->start.heading;
          candidate.link.length = bitangent->length;
          if (!free_headings_[from].contains(bitangent->start.heading)) {
            candidate.verdict = Verdict::kDeparture;
          } else if (!free_headings_[to].contains(bitangent->start.heading)) {
            candidate.verdict = Verdict::kArrival;
          } else {
            rectangles.push_back(swept_rectangle(bitangent->start, bitangent->length, checked));
            waiting.push_back(next);
          }
        }
        ++next;
      };
      for (const VertexId v : graph.row(u)) {
        const Side side_u = obstacle_side(world, u, world.vertex(v));  // seen from v, so opposite when leaving u
        const Side side_v = obstacle_side(world, v, world.vertex(u));
        for (std::size_t ru = 0; ru < radius_count; ++ru)
          for (std::size_t rv = 0; rv < radius_count; ++rv) {
            consider(circle_of(u, ru, opposite(side_u)), circle_of(v, rv, side_v));
            consider(circle_of(v, rv, opposite(side_v)), circle_of(u, ru, side_u));
          }
      }
      free.resize(rectangles.size());
      queries.sweep->straight_free(rectangles, free);
      for (std::size_t k = 0; k < waiting.size(); ++k)
        candidates[waiting[k]].verdict = free[k] ? Verdict::kKept : Verdict::kStraight;
    }
  });

  counts_.circles = circles_.size();
  for (const HeadingSet& headings : free_headings_) counts_.circles_blocked += headings.empty() ? 1 : 0;
  counts_.candidates = candidates.size();
  for (const Candidate& candidate : candidates) {
    switch (candidate.verdict) {
      case Verdict::kKept:
        links_.push_back(candidate.link);
        break;
      case Verdict::kOverlap:
        ++counts_.rejected_overlap;
        break;
      case Verdict::kDeparture:
        ++counts_.rejected_departure;
        break;
      case Verdict::kArrival:
        ++counts_.rejected_arrival;
        break;
      case Verdict::kStraight:
        ++counts_.rejected_straight;
        break;
    }
  }
  counts_.kept = links_.size();
  std::sort(links_.begin(), links_.end(), [](const Link& a, const Link& b) {
    if (a.from != b.from) return a.from < b.from;
    if (a.heading != b.heading) return a.heading < b.heading;
    return a.to < b.to;
  });
  link_starts_.assign(circles_.size() + 1, 0);
  for (const Link& link : links_) ++link_starts_[link.from + 1];
  for (std::size_t c = 0; c < circles_.size(); ++c) link_starts_[c + 1] += link_starts_[c];
}

}  // namespace arcway
