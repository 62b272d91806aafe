#include "core/search/terminal_links.h"

#include "core/geometry/angle.h"
#include "core/search/horizon.h"

namespace arcway {

void append_circles(const SearchMap& map, std::span<const Terminal> terminals, Direction direction,
                    std::vector<TerminalCircle>& circles) {
  for (std::uint32_t t = 0; t < terminals.size(); ++t)
    for (const double radius : map.radii)
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const Pose& pose = terminals[t].pose;
        const TurnCircle circle = turn_circle(pose, radius, side);
        const Side towards = direction == Direction::kFromStart ? side : opposite(side);
        const HeadingSet free = map.queries.sweep->free_headings({circle.center, radius, side, map.body});
        circles.push_back({t, circle, wrap_positive(pose.heading), free.reach(pose.heading, towards)});
      }
}

void append_links(const SearchMap& map, std::span<const TerminalCircle> circles, std::uint32_t index,
                  Direction direction, std::vector<TerminalLink>& links) {
  const TerminalCircle& own = circles[index];
  if (own.reach < 0.0) return;
  const bool from_start = direction == Direction::kFromStart;
  // A path to the goal, seen from there, runs the other way round the circle.
  const TurnCircle outwards =
      from_start ? own.circle
                 : TurnCircle{own.circle.center, own.circle.radius, opposite(own.circle.side), own.circle.vertex};
  const bool body_covers_reference = map.body.front >= 0.0 && map.body.rear >= 0.0;
  const Horizon horizon = body_covers_reference ? Horizon(map.outlines, outwards) : Horizon();

  const auto consider = [&](std::uint32_t c) {
    const TurnCircle& other = map.graph.circles()[c];
    const auto line = from_start ? directed_bitangent(own.circle, other) : directed_bitangent(other, own.circle);
    if (!line) return;
    const double heading = line->start.heading;
    if (line->length > horizon.reach(from_start ? heading : heading + kPi)) return;
    const double turn = from_start ? turn_between(own.heading, heading, own.circle.side)
                                   : turn_between(heading, own.heading, own.circle.side);
    if (turn <= own.reach) links.push_back({index, c, *line, turn});
  };
  const auto circles_per_vertex = static_cast<std::uint32_t>(2 * map.radii.size());
  for (std::uint32_t r = 0; r < map.radii.size(); ++r) {
    // The straight ends on the vertex's circle, which passes no further from the vertex than this.
    const Vec2 spread = Vec2::Constant(2.0 * map.radii[r] + map.body.front + map.body.rear);
    map.vertices.visit_if(
        [&](const Box& box) {
          return !horizon.hides({box.min - spread, box.max + spread});
        },
        [&](std::uint32_t i) {
          consider(circles_per_vertex * i + 2 * r);
          consider(circles_per_vertex * i + 2 * r + 1);
          return true;
        });
  }
}

}  // namespace arcway
