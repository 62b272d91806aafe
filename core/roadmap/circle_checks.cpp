#include "core/roadmap/circle_checks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "core/geometry/quick_direction.h"
#include "core/roadmap/may_contain.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

// A turn round the thinnest vertex begins and ends at a right angle to the heading at the vertex; and a little more.
constexpr double kTurnAtVertex = 0.55 * kPi;

const CircleRadii& checked_radii(const CircleRadii& radii) {
  const auto is_radius = [](double radius) { return radius > 0.0 && std::isfinite(radius); };
  const auto ascend = [&](Side side, auto&& in_order) { return std::ranges::is_sorted(radii.of(side), in_order); };
  bool are_right =
      radii.size() > 0 && (ascend(Side::kLeft, std::less_equal<>()) || ascend(Side::kRight, std::less_equal<>()));
  for (const Side side : {Side::kLeft, Side::kRight})
    are_right = are_right && std::ranges::all_of(radii.of(side), is_radius) && ascend(side, std::less<>());
  if (!are_right)
    throw std::invalid_argument("feasible graph: radii must be positive, finite and ascending, at least one");
  return radii;
}

// Whether the body has its reach to a side right beside the reference point, which lies on it.
bool is_round(const Body& body, Side side) {
  return body.covers({0.0, 0.0}) && body.covers({0.0, sign_of(side) * body.beside(side)});
}

}  // namespace

CircleChecks::CircleChecks(const FeasibleGraphInputs& inputs, const Executor& executor)
    : CircleChecks(inputs, checked_radii(inputs.radii).front(),
                   TurnCircles(inputs.world, *inputs.rows, checked_radii(inputs.radii),
                               inputs.vehicle.footprint(inputs.vehicle.safety_margin()), executor)) {}

CircleChecks::CircleChecks(const CircleChecks& before, const VertexMap& change, const FeasibleGraphInputs& after,
                           std::span<const VertexId> may_differ)
    : CircleChecks(after, before.smallest_radii_,
                   TurnCircles(before.circles_, change, after.world, *after.rows, may_differ, after.radii,
                               after.vehicle.footprint(after.vehicle.safety_margin()))) {}

CircleChecks::CircleChecks(const CircleChecks& base, const Vehicle& vehicle, const AddedCircles& added,
                           const StopClock& clock)
    : CircleChecks({base.world_, vehicle, base.rows_, base.queries_, {}}, base.smallest_radii_,
                   TurnCircles(base.circles_, added, clock)) {}

CircleChecks::CircleChecks(const FeasibleGraphInputs& inputs, const SideRadii& smallest_radii, TurnCircles circles)
    : world_(inputs.world),
      queries_(inputs.queries),
      vehicle_(inputs.vehicle),
      body_(vehicle_.body(0.5 * vehicle_.safety_margin())),
      is_round_{is_round(body_, Side::kLeft), is_round(body_, Side::kRight)},
      smallest_radii_(smallest_radii),
      rows_(inputs.rows),
      circles_(std::move(circles)),
      destinations_(world_, *rows_, circles_) {}

HeadingSet CircleChecks::free_headings(std::uint32_t circle) const {
  if (!circles_.is_used(circle)) return {};
  HeadingSet found = queries_.sweep->free_headings(body_on(circle));
  keep_at_vertex(circle, found);
  return found;
}

void CircleChecks::free_headings(std::span<const std::uint32_t> circles, std::span<HeadingSet> found) const {
  std::vector<TurningBody> bodies;
  bodies.reserve(circles.size());
  for (const std::uint32_t c : circles) bodies.push_back(body_on(c));
  queries_.sweep->free_headings(bodies, found);
  for (std::size_t i = 0; i < circles.size(); ++i) keep_at_vertex(circles[i], found[i]);
}

LinkRow CircleChecks::departures(std::uint32_t circle, const HeadingSet& free, const StopClock& clock,
                                 Box* around) const {
  const TurnCircle& from = circles_.all()[circle];
  LinkRow row;
  StopTicker ticker(clock);
  visit_destinations(circle, clock, around, [&](std::uint32_t to) {
    end_if_over(ticker);
    ++row.counts.candidates;
    const auto line = line_of_bitangent(from, circles_.all()[to]);
    if (!line) {
      ++row.counts.overlaps;
      return;
    }
    // Most headings are blocked by far, which one that is nearly right shows.
    const bool may_be_free = may_contain(free, quick_angle_of(line->along), kQuickAngleError);
    const double heading = may_be_free ? line->heading() : 0.0;
    if (may_be_free && free.contains(heading)) {
      row.links.push_back({circle, to, heading, line->length});
    } else {
      ++row.counts.departures;
    }
  });
  std::sort(row.links.begin(), row.links.end(), [](const FeasibleLink& a, const FeasibleLink& b) {
    if (a.heading != b.heading) return a.heading < b.heading;
    return a.to < b.to;
  });
  // Circles that know two vertices are found at both.
  const auto repeated = std::unique(row.links.begin(), row.links.end(),
                                    [](const FeasibleLink& a, const FeasibleLink& b) { return a.to == b.to; });
  row.counts.repeated = static_cast<std::uint32_t>(row.links.end() - repeated);
  row.links.erase(repeated, row.links.end());
  return row;
}

bool CircleChecks::is_free(const FeasibleLink& link) const { return queries_.sweep->straight_free(swept_by(link)); }

void CircleChecks::are_free(std::span<const FeasibleLink> links, std::span<std::uint8_t> free) const {
  std::vector<StraightBody> bodies;
  bodies.reserve(links.size());
  for (const FeasibleLink& link : links) bodies.push_back(swept_by(link));
  queries_.sweep->straight_free(bodies, free);
}

TurningBody CircleChecks::body_on(std::uint32_t circle) const {
  const TurnCircle& c = circles_.all()[circle];
  return {c.center, c.radius, c.side, body_};
}

StraightBody CircleChecks::swept_by(const FeasibleLink& link) const {
  return {pose_on(circles_.all()[link.from], link.heading), link.length, body_};
}

// Keeps the headings of a wide circle near its vertex. Away from the vertex, smaller circles serve the same turns.
void CircleChecks::keep_at_vertex(std::uint32_t circle, HeadingSet& found) const {
  const TurnCircle& c = circles_.all()[circle];
  if (c.radius == smallest_radii_.of(c.side) || !is_round_[c.side == Side::kLeft ? 0 : 1]) return;
  found = found.around(heading_at_vertex(world_, c), kTurnAtVertex);
}

// Calls visit(circle) for those that a straight from a circle may lead to, for some of them repeatedly.
template <class Visitor>
void CircleChecks::visit_destinations(std::uint32_t circle, const StopClock& clock, Box* around,
                                      Visitor&& visit) const {
  const TurnCircle& from = circles_.all()[circle];
  const auto extend = [&](VertexId v) {
    if (around && v != kNone) around->extend(world_.vertex(v));
  };
  if (!circles_.is_of_gap_straight(circle)) {
    for (const VertexId u : {from.vertex, from.second}) {
      extend(u);
      if (around && u != kNone) extend(destinations_.vertex_before(u, from.side));
    }
    for (const Destinations::Arrival& arrival : destinations_.from(from, clock)) {
      extend(arrival.vertex);
      circles_.visit_around(arrival.vertex, arrival.side, visit);
    }
  } else if (!circles_.is_exit(circle)) {
    return circles_.visit_exits_behind(circle, visit);
  }
  if (circles_.base_count() == circles_.all().size()) return;
  for (const VertexId u : {from.vertex, from.second}) {
    if (u == kNone) continue;
    circles_.visit_entries(u, visit);
    for (const VertexId v : rows_->of(u)) circles_.visit_entries(v, visit);
    if (!circles_.is_of_gap_straight(circle)) continue;
    for (const Side side : {Side::kLeft, Side::kRight}) circles_.visit_around(u, side, visit);
    for (const VertexId v : rows_->of(u)) circles_.visit_around(v, obstacle_side(world_, v, world_.vertex(u)), visit);
  }
}

}  // namespace arcway::internal
