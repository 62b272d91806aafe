#include "core/refine/circle_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

// Share of the coordinates and radii within which circles count as touching.
constexpr double kChainUlps = 64.0 * std::numeric_limits<double>::epsilon();

TurnCircle circle_of(const PathSegment& arc) {
  const Side side = arc.curvature > 0.0 ? Side::kLeft : Side::kRight;
  return turn_circle(arc.start, 1.0 / std::abs(arc.curvature), side);
}

Pose advanced(const Pose& pose, double length) { return PathSegment{pose, length, 0.0}.end(); }

}  // namespace

std::optional<Bitangent> joint_of(const TurnCircle& from, const TurnCircle& to) {
  if (const auto line = directed_bitangent(from, to)) return line;
  // Circles that touch meet on the line of their centers.
  const Vec2 d = to.center - from.center;
  const double offset = sign_of(to.side) * to.radius - sign_of(from.side) * from.radius;
  const double scale =
      std::max({from.radius, to.radius, from.center.cwiseAbs().maxCoeff(), to.center.cwiseAbs().maxCoeff()});
  if (std::abs(d.norm() - std::abs(offset)) > kChainUlps * scale || d.norm() <= kChainUlps * scale) return std::nullopt;
  const Vec2 t = -offset * perpendicular(d);
  return Bitangent{pose_on(from, wrap_positive(std::atan2(t.y(), t.x()))), 0.0};
}

TurnCircle CircleChain::first_circle(double lead, double radius, Side side) const {
  return turn_circle(advanced(start, lead), radius, side);
}

TurnCircle CircleChain::last_circle(double lead, double radius, Side side) const {
  return turn_circle(advanced(goal, -lead), radius, side);
}

Bitangent CircleChain::last_line(double lead) const { return {advanced(goal, -lead), lead}; }

void CircleChain::place_ends() {
  circles.front() = first_circle(lead_in, circles.front().radius, circles.front().side);
  circles.back() = last_circle(lead_out, circles.back().radius, circles.back().side);
}

bool chain_of(std::span<const PathSegment> path, const Pose& start, const Pose& goal, CircleChain& chain) {
  chain.start = start;
  chain.goal = goal;
  chain.lead_in = chain.lead_out = 0.0;
  chain.circles.clear();
  double curvature = 0.0;  // of the segment before
  for (const PathSegment& segment : path) {
    if (!segment.is_line()) {
      if (segment.curvature != curvature) chain.circles.push_back(circle_of(segment));
      chain.lead_out = 0.0;
    } else if (chain.circles.empty()) {
      chain.lead_in += segment.length;
    } else {
      chain.lead_out += segment.length;
    }
    curvature = segment.curvature;
  }
  if (chain.circles.size() < 2) return false;
  chain.place_ends();
  return true;
}

std::optional<CircleChain> chain_of(std::span<const PathSegment> path, const Pose& start, const Pose& goal) {
  CircleChain chain;
  if (!chain_of(path, start, goal, chain)) return std::nullopt;
  return chain;
}

bool lines_of(const CircleChain& chain, std::vector<Bitangent>& lines) {
  lines.clear();
  lines.reserve(chain.circles.size() + 1);
  lines.push_back({chain.start, chain.lead_in});
  for (std::size_t i = 0; i + 1 < chain.circles.size(); ++i) {
    const auto line = joint_of(chain.circles[i], chain.circles[i + 1]);
    if (!line) return false;
    lines.push_back(*line);
  }
  lines.push_back(chain.last_line(chain.lead_out));
  return true;
}

std::optional<std::vector<Bitangent>> lines_of(const CircleChain& chain) {
  std::vector<Bitangent> lines;
  if (!lines_of(chain, lines)) return std::nullopt;
  return lines;
}

void path_of(const CircleChain& chain, std::span<const Bitangent> lines, Path& path) {
  path.clear();
  path.reserve(2 * chain.circles.size() + 1);
  const auto append = [&path](const Pose& start, double length, double curvature) {
    if (length > 0.0) path.push_back({start, length, curvature});
  };
  append(lines[0].start, lines[0].length, 0.0);
  for (std::size_t i = 0; i < chain.circles.size(); ++i) {
    const TurnCircle& circle = chain.circles[i];
    const double heading = lines[i].start.heading;
    const double turn = turn_between(heading, lines[i + 1].start.heading, circle.side);
    append(pose_on(circle, heading), turn * circle.radius, sign_of(circle.side) / circle.radius);
    append(lines[i + 1].start, lines[i + 1].length, 0.0);
  }
}

Path path_of(const CircleChain& chain, std::span<const Bitangent> lines) {
  Path path;
  path_of(chain, lines, path);
  return path;
}

}  // namespace arcway::internal
