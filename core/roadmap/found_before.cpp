#include "core/roadmap/found_before.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/roadmap/circle_change.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal {

namespace {

// No less than how far a body reaches from a vertex of a circle on that circle: at most an inner and an outer radius.
double largest_reach(const FeasibleGraphInputs& inputs) {
  const Footprint grown_body = inputs.vehicle.footprint(inputs.vehicle.safety_margin());
  double largest = 0.0;
  for (const Side side : {Side::kLeft, Side::kRight})
    for (const double radius : inputs.radii.of(side))
      largest = std::max(largest, 2.0 * swept_annulus(grown_body, side, radius).outer);
  return largest;
}

NearBoxes boxes_of(const World& world, std::span<const VertexId> vertices) {
  std::vector<Box> boxes;
  boxes.reserve(vertices.size());
  for (const VertexId v : vertices) boxes.push_back({world.vertex(v), world.vertex(v)});
  return NearBoxes(boxes);
}

// The index of a circle among those of another world; kNone if there is none.
template <class MapVertex>
std::uint32_t counterpart(std::uint32_t c, const TurnCircles& circles, const TurnCircles& others,
                          const MapVertex& vertex_of) {
  const TurnCircle& circle = circles.all()[c];
  const VertexId v = vertex_of(circle.vertex);
  if (v == kNone || !others.has(v)) return kNone;
  if (circle.second == kNone)
    return others.first_around(v, Side::kLeft) + c - circles.first_around(circle.vertex, Side::kLeft);
  const VertexId second = vertex_of(circle.second);
  std::uint32_t found = kNone;
  if (second == kNone) return found;
  others.visit_around(v, circle.side, [&](std::uint32_t other) {
    const TurnCircle& o = others.all()[other];
    if (o.vertex == v && o.second == second && o.radius == circle.radius) found = other;
  });
  return found;
}

std::size_t graphs_behind(const FeasibleGraph& graph) {
  const auto* lazy = dynamic_cast<const LazyFeasibleGraph*>(&graph);
  return lazy ? lazy->graphs_behind() : 0;
}

}  // namespace

FoundBefore::FoundBefore(std::shared_ptr<const FeasibleGraph> before, const FeasibleGraphInputs& inputs,
                         const CircleChecks& after, const WorldChange& change, std::span<const VertexId> may_differ)
    : before_(std::move(before)),
      graphs_(1 + graphs_behind(*before_)),
      after_(after),
      map_(change),
      places_(places_of(change, largest_reach(inputs))),
      differing_(boxes_of(after.world(), may_differ)) {}

std::uint32_t FoundBefore::before_of(std::uint32_t circle) const {
  return counterpart(circle, after_.circles(), before_->turn_circles(), [this](VertexId v) { return map_.before(v); });
}

std::uint32_t FoundBefore::after_of(std::uint32_t circle_before) const {
  return counterpart(circle_before, before_->turn_circles(), after_.circles(),
                     [this](VertexId v) { return map_.after(v); });
}

const HeadingSet* FoundBefore::headings(std::uint32_t circle) const {
  const Vec2& vertex = after_.world().vertex(after_.circles().all()[circle].vertex);
  if (places_.may_meet(Box{vertex, vertex})) return nullptr;
  const std::uint32_t was = before_of(circle);
  return was == kNone ? nullptr : before_->known_headings(was);
}

std::optional<CheckedRow> FoundBefore::row(std::uint32_t circle) const {
  const std::uint32_t was = before_of(circle);
  std::optional<CheckedRow> known = was == kNone ? std::nullopt : before_->known_row(was);
  if (!known || known->around.empty() || places_.may_meet(known->around) || differing_.may_meet(known->around))
    return std::nullopt;
  for (FeasibleLink& link : known->row.links) {
    link.from = circle;
    link.to = after_of(link.to);
  }
  return known;
}

}  // namespace arcway::internal
