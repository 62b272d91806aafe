#include "core/search/manoeuvres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <set>

#include "core/geometry/angle.h"

namespace arcway {

namespace {

constexpr double kStepTurn = kPi / 8.0;
constexpr double kLeastTurn = 1e-3;

// Poses in one cell count as the same.
struct Grid {
  double size;
  int headings;
};

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Pose& pose, const Grid& grid) {
  return {std::llround(pose.x / grid.size), std::llround(pose.y / grid.size),
          std::llround(wrap_positive(pose.heading) / kTwoPi * grid.headings) % grid.headings};
}

struct Node {
  Terminal terminal;
  double length;
};

}  // namespace

std::vector<Terminal> find_manoeuvres(const Pose& pose, Direction direction, const Vehicle& vehicle, double radius,
                                      const SweepQuery& sweep, std::size_t max_poses, Spread spread) {
  const bool forwards = direction == Direction::kFromStart;
  const Footprint body = vehicle.footprint(0.5 * vehicle.safety_margin());
  const double step = radius * kStepTurn;
  const Grid grid = spread == Spread::kDense ? Grid{0.5 * step, 128} : Grid{0.5 * radius, 32};

  std::vector<Node> nodes{{{pose, {}}, 0.0}};
  using Waiting = std::pair<double, std::size_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> open;
  open.push({0.0, 0});
  std::set<Cell> seen{cell_of(pose, grid)};

  const auto reach = [&](std::size_t from, const PathSegment& segment, const Pose& reached) {
    if (!seen.insert(cell_of(reached, grid)).second) return;
    Node node{{reached, nodes[from].terminal.connection}, nodes[from].length + segment.length};
    Path& connection = node.terminal.connection;
    connection.insert(forwards ? connection.end() : connection.begin(), segment);
    nodes.push_back(std::move(node));
    open.push({nodes.back().length, nodes.size() - 1});
  };

  while (!open.empty() && nodes.size() < max_poses) {
    const std::size_t at = open.top().second;
    open.pop();
    const Pose here = nodes[at].terminal.pose;
    const Vec2 ahead = direction_of(here.heading);
    for (const double length : {step, 4.0 * step, 16.0 * step}) {
      const Vec2 other = here.position() + (forwards ? length : -length) * ahead;
      const Pose reached{other.x(), other.y(), here.heading};
      const PathSegment line{forwards ? here : reached, length, 0.0};
      if (!sweep.straight_free(swept_rectangle(line.start, length, body))) break;
      reach(at, line, reached);
    }
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Vec2 center = here.position() + sign_of(side) * radius * perpendicular(ahead);
      const HeadingSet free = sweep.free_headings(TurningBody{center, radius, side, body});
      const double room = free.reach(here.heading, forwards ? side : opposite(side));
      // Where an obstacle ends the turn early, the way on may lie in a narrow range of headings before its end.
      const bool hemmed = room < kStepTurn;
      for (const double share : {1.0, 0.75, 0.5, 0.25}) {
        const double angle = hemmed ? share * room : kStepTurn;
        if (angle < kLeastTurn) break;
        const double turn = (forwards ? 1.0 : -1.0) * sign_of(side) * angle;
        const Pose reached = pose_on(TurnCircle{center, radius, side, kNone}, here.heading + turn);
        const PathSegment arc{forwards ? here : reached, radius * angle, sign_of(side) / radius};
        reach(at, arc, reached);
        if (!hemmed) break;
      }
    }
  }
  std::vector<Terminal> terminals;
  terminals.reserve(nodes.size());
  for (Node& node : nodes) terminals.push_back(std::move(node.terminal));
  return terminals;
}

}  // namespace arcway
