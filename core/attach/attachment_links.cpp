#include "core/attach/attachment_links.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "arcway/angle.h"
#include "core/attach/circle_places.h"
#include "core/attach/circle_table.h"
#include "core/attach/occlusion_horizon.h"
#include "core/collision/arc_query.h"

namespace arcway::internal {

namespace {

constexpr double kRounding = 1e-9;  // share of a length that rounding may change

void sort_near_first(const Vec2& place, const Outlines& outlines, std::vector<std::uint32_t>& pieces) {
  const auto distance = [&](std::uint32_t piece) { return outlines[piece].box.distance_to(place); };
  std::sort(pieces.begin(), pieces.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double to_a = distance(a), to_b = distance(b);
    return to_a != to_b ? to_a < to_b : a < b;
  });
}

}  // namespace

void append_circles(const Roadmap& map, std::span<const Attachment> attachments, std::size_t first, Direction direction,
                    HeadingSet& headings, std::vector<AttachmentCircle>& circles, const StopClock& clock) {
  for (auto t = static_cast<std::uint32_t>(first); t < attachments.size() && !clock.is_over(); ++t) {
    // Maneuvers join by the smallest radius only: they serve narrow places, and their poses are many.
    const bool plain = attachments[t].connection.empty();
    for (const double radius : std::span(map.radii).first(plain ? map.radii.size() : 1))
      for (const Side side : {Side::kLeft, Side::kRight}) {
        if (attachments[t].shared == side) continue;
        const Pose& pose = attachments[t].pose;
        const TurnCircle circle = turn_circle(pose, radius, side);
        const Side towards = direction == Direction::kFromStart ? side : opposite(side);
        const TurningBody body{circle.center, radius, side, map.body};
        circles.push_back(
            {t, circle, wrap_positive(pose.heading), reach(*map.queries.sweep, body, pose.heading, towards, headings)});
      }
  }
}

void append_links(const Roadmap& map, std::span<const AttachmentCircle> circles, std::uint32_t index,
                  Direction direction, const LengthLimit& limit, std::vector<std::uint32_t>& pieces,
                  HugeVector<AttachmentLink>& links) {
  const AttachmentCircle& own = circles[index];
  if (own.reach < 0.0) return;
  const bool from_start = direction == Direction::kFromStart;
  // Backwards from the goal, a path turns in the other direction on the circle.
  const TurnCircle away =
      from_start ? own.circle
                 : TurnCircle{own.circle.center, own.circle.radius, opposite(own.circle.side), own.circle.vertex};
  OcclusionHorizon horizon(away, from_start ? own.heading : own.heading + kPi, own.reach);
  const bool body_covers_reference = map.body.front >= 0.0 && map.body.rear >= 0.0;
  const bool is_limited = limit.length < std::numeric_limits<double>::infinity();
  const double longest = limit.length * (1.0 + kRounding) + own.circle.radius;
  const auto is_far = [&](const Box& box) {
    return is_limited && box.distance_to(limit.other_end) + box.distance_to(own.circle.center) > longest;
  };
  const auto is_far_circle = [&](const TurnCircle& other) {
    return is_limited && (limit.other_end - other.center).norm() + (own.circle.center - other.center).norm() >
                             longest + 2.0 * other.radius;
  };
  pieces.clear();
  std::size_t pieces_circles = 0;
  map.places->visit_near_first(
      own.circle.center, [&](const Box& box) { return !is_far(box) && !horizon.hides(box); },
      [&](const Outlines::Piece& piece, std::uint32_t index_of_piece) {
        if (body_covers_reference) horizon.shorten(piece.points, piece.box);
        pieces.push_back(index_of_piece);
        for (const CirclePlaces::Group& group : map.places->groups(index_of_piece))
          pieces_circles += group.last - group.first;
      });
  if (pieces_circles > limit.most_links) sort_near_first(own.circle.center, *map.outlines, pieces);
  const std::size_t first = links.size();
  const std::span<const TurnCircle> graph_circles = map.graph->circles();
  const auto consider = [&](std::uint32_t circle) {
    const TurnCircle& other = graph_circles[circle];
    if (is_far_circle(other)) return;
    const Side side = from_start ? other.side : opposite(other.side);
    const OcclusionHorizon::TangentLine tangent =
        horizon.tangent_to(TurnCircle{other.center, other.radius, side, kNone});
    if (horizon.hides(tangent)) return;
    // Most other circles are blocked at their heading. An approximate heading shows that, and exact ones are far
    // slower.
    const double about = from_start ? tangent.heading : tangent.heading + (tangent.heading < kPi ? kPi : -kPi);
    if (tangent.length > 0.0 && !map.circles->may_be_free(circle, about, OcclusionHorizon::kTangentError)) return;
    const auto line = from_start ? directed_bitangent(own.circle, other) : directed_bitangent(other, own.circle);
    if (!line) return;
    const double heading = line->start.heading;
    if (line->length > horizon.reach(from_start ? heading : heading + kPi)) return;
    if (!map.circles->is_lazy() && !map.graph->free_headings(circle).contains(heading)) return;
    const double turn = from_start ? turn_between(own.heading, heading, own.circle.side)
                                   : turn_between(heading, own.heading, own.circle.side);
    if (turn <= own.reach) links.push_back({index, circle, *line, turn});
  };
  for (const std::uint32_t piece : pieces) {
    if (links.size() - first >= limit.most_links) break;
    for (const CirclePlaces::Group& group : map.places->groups(piece)) {
      if (is_far(group.box) || horizon.hides(group.box)) continue;
      const Sectors outwards = horizon.sectors_towards(group.box);
      const Sectors sectors = from_start ? outwards : std::rotl(outwards, 32);
      for (const std::uint32_t c : map.places->circles(group))
        if ((map.circles->free_sectors(c) & sectors) != 0) consider(c);
    }
  }
  links.resize(first + std::min(links.size() - first, limit.most_links));
  // The order does not depend on that of the pieces.
  std::sort(links.begin() + static_cast<std::ptrdiff_t>(first), links.end(),
            [](const AttachmentLink& a, const AttachmentLink& b) { return a.circle < b.circle; });
}

}  // namespace arcway::internal
