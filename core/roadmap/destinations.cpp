#include "core/roadmap/destinations.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "arcway/executor.h"
#include "arcway/visibility_graph.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

// The direction of the bitangent, not normalized; nothing if there is none.
std::optional<Vec2> line_between(const TurnCircle& from, const TurnCircle& to) {
  const Vec2 d = to.center - from.center;
  const double offset = sign_of(to.side) * to.radius - sign_of(from.side) * from.radius;
  const double square = d.squaredNorm() - offset * offset;
  if (!(square > 0.0)) return std::nullopt;
  return std::sqrt(square) * d - offset * perpendicular(d);
}

// Whether a path by three circles turns to the side of the middle one, forwards, by less than a right angle.
bool bends_round(const TurnCircle& from, const TurnCircle& middle, const TurnCircle& to) {
  const auto arriving = line_between(from, middle);
  const auto leaving = line_between(middle, to);
  return arriving && leaving && sign_of(middle.side) * cross(*arriving, *leaving) > 0.0 &&
         arriving->dot(*leaving) > 0.0;
}

}  // namespace

std::vector<Destinations::Arrival> Destinations::from(const TurnCircle& circle, const StopClock& clock) const {
  const std::span<const Vec2> vertices = world_.vertices();
  std::vector<Arrival> arrivals;
  const auto add = [&](VertexId from, Side departure, VertexId to, std::uint32_t passed, bool may_be_known) {
    // Seen from `to`, the obstacle at `from` lies on the other side than seen when leaving towards `to`.
    if (obstacle_side(world_, from, vertices[to]) == departure) return;
    const Side side = obstacle_side(world_, to, vertices[from]);
    if (may_be_known)
      for (const Arrival& known : arrivals)
        if (known.vertex == to && known.side == side) return;
    arrivals.push_back({to, side, from, passed});
  };
  for (const VertexId u : {circle.vertex, circle.second})
    if (u != kNone)
      for (const VertexId v : rows_.of(u)) add(u, circle.side, v, 0, u == circle.second);
  append_beside(circle, arrivals);
  StopTicker ticker(clock);
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    const Arrival at = arrivals[i];
    if (at.passed == kMostPassed) break;  // so have all that follow
    const TurnCircle& middle = own_circle(at.vertex, at.side);
    const auto line = line_between(circle, middle);
    if (!line) continue;
    const Vec2 here = vertices[at.vertex], across = sign_of(at.side) * perpendicular(*line);
    // A bitangent begins and ends within two radii of its vertices. A path to a vertex farther to this side than that
    // turns to this side, not away. Among sparse obstacles that is nearly every vertex.
    const double other = own_circle(at.vertex, opposite(at.side)).radius;
    const double far = 2.0 * (middle.radius + std::max(middle.radius, other)) * across.norm();
    for (const VertexId next : rows_.of(at.vertex)) {
      end_if_over(ticker);
      if (across.dot(vertices[next] - here) > far) continue;
      const int turn = orientation(vertices[at.before], here, vertices[next]);
      if (turn == (at.side == Side::kLeft ? -1 : 1)) continue;
      const TurnCircle& behind = own_circle(next, obstacle_side(world_, next, here));
      const auto onwards = line_between(middle, behind);
      if (onwards && sign_of(at.side) * cross(*line, *onwards) < 0.0)
        add(at.vertex, at.side, next, at.passed + 1, true);
    }
  }
  return arrivals;
}

// A line past an obstacle's vertices may be free for a point but bend around the next vertex for a body. The bitangents
// then lead from that vertex to the far end or, seen backwards, to the vertex before the far end.
void Destinations::append_beside(const TurnCircle& circle, std::vector<Arrival>& arrivals) const {
  const auto add = [&arrivals](const Arrival& arrival) {
    const bool known = std::any_of(arrivals.begin(), arrivals.end(), [&arrival](const Arrival& a) {
      return a.vertex == arrival.vertex && a.side == arrival.side;
    });
    if (!known) arrivals.push_back(arrival);
  };
  for (const VertexId u : {circle.vertex, circle.second}) {
    const VertexId before = u == kNone ? kNone : vertex_before(u, circle.side);
    if (before == kNone) continue;
    for (const VertexId w : rows_.of(before)) {
      if (w == u || obstacle_side(world_, before, world_.vertex(w)) == circle.side) continue;
      const Side side = obstacle_side(world_, w, world_.vertex(before));
      if (bends_round(own_circle(before, circle.side), circle, own_circle(w, side))) add({w, side, before, 0});
    }
  }
  for (std::size_t i = 0, count = arrivals.size(); i < count; ++i) {
    const Arrival at = arrivals[i];
    const VertexId before = vertex_before(at.vertex, at.side);
    if (before == kNone || before == circle.vertex || before == circle.second) continue;
    if (bends_round(circle, own_circle(before, at.side), own_circle(at.vertex, at.side)))
      add({before, at.side, at.before, 0});
  }
}

VertexId Destinations::vertex_before(VertexId v, Side side) const {
  const VertexId before = side == Side::kLeft ? world_.previous(v) : world_.next(v);
  const auto row = rows_.of(v);
  return circles_.has(before) && std::binary_search(row.begin(), row.end(), before) ? before : kNone;
}

}  // namespace arcway::internal
