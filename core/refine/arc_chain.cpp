#include "core/refine/arc_chain.h"

#include <algorithm>
#include <cmath>

#include "arcway/angle.h"
#include "core/base/infinity.h"
#include "core/refine/tied_turns.h"

namespace arcway::internal {

namespace {

constexpr double kLongLine = 0.7;    // least length of a line that follows from its circles, in radii of the larger one
constexpr double kLargeTurn = 2.0;   // least turn that is cut into one arc more [rad]
constexpr double kShortest = 1e-3;   // least length of a line that is not tied, in radii of the tightest circle
constexpr double kNoLength = 1e-9;   // length of a line that counts as none, in such radii
constexpr double kOneRadius = 1e-6;  // relative difference of radii that count as one
constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);

void follow_forwards(ArcChain& chain, std::size_t arc) {
  const ArcChain::Line& line = chain.lines[arc];
  const Vec2& ahead = line.ahead;
  chain.arcs[arc].center = chain.before(arc) + line.along() * ahead + chain.offset(arc) * perpendicular(ahead);
}

void follow_backwards(ArcChain& chain, std::size_t arc) {
  const ArcChain::Line& line = chain.lines[arc + 1];
  const Vec2& ahead = line.ahead;
  chain.arcs[arc].center = chain.behind(arc + 1) - line.along() * ahead - chain.offset(arc + 1) * perpendicular(ahead);
}

// Neighboring arcs of which one keeps its place and places the others: the one next to start or goal, or else the
// tightest one.
struct Group {
  std::size_t first, last, kept;
};
// `follows` says whether an arc belongs to the one before it.
template <class Follows>
Group group_from(const ArcChain& chain, std::size_t first, const Follows& follows) {
  const std::size_t n = chain.arcs.size();
  Group group{first, first, first};
  while (group.last + 1 < n && follows(group.last + 1)) ++group.last;
  if (first == 0) return group;
  if (group.last + 1 == n) return {first, group.last, group.last};
  for (std::size_t i = first; i <= group.last; ++i)
    if (chain.arcs[i].radius < chain.arcs[group.kept].radius) group.kept = i;
  return group;
}

bool follow_circles(ArcChain& chain, std::size_t i) {
  ArcChain::Line& line = chain.lines[i];
  const Vec2 d = chain.arcs[i].center - chain.arcs[i - 1].center;
  const double offset = chain.offset(i);
  const double square = d.squaredNorm() - offset * offset;
  if (!(square > 0.0)) return false;
  line.length = std::sqrt(square);
  const double heading = std::atan2(d.y(), d.x()) - std::atan2(offset, line.length);
  line.heading += wrap_signed(heading - line.heading);
  line.ahead = direction_of(line.heading);
  return true;
}

Gear gear_of(double sign) { return sign < 0.0 ? Gear::kReverse : Gear::kForward; }

// Adds a turn on a circle, cut into tied arcs. Returns the heading at its end.
double add_turn(const ArcChain::Arc& arc, double heading, double turn, const TurnCuts& cuts, ArcChain& to) {
  const bool is_whole = turn < cuts.least || arc.radius >= cuts.widest;
  const int parts = is_whole ? 1 : turn > kLargeTurn ? cuts.parts + 1 : cuts.parts;
  for (int k = 0; k < parts; ++k) {
    if (k > 0) to.lines.push_back({heading + arc.turning() * turn * k / parts, 0.0, true, Vec2::Zero(), arc.gear});
    to.arcs.push_back(arc);
  }
  return heading + arc.turning() * turn;
}

}  // namespace

bool ArcChain::join() {
  const std::size_t n = arcs.size();
  std::size_t longest = kNoLine;
  for (std::size_t i = 1; i < n; ++i)
    if (!lines[i].is_tied && (longest == kNoLine || lines[i].length > lines[longest].length)) longest = i;
  if (longest == kNoLine) return false;
  const auto is_long = [&](std::size_t i) {
    const Line& line = lines[i];
    if (i == longest) return true;
    return !line.is_tied && line.length >= kLongLine * std::max(arcs[i - 1].radius, arcs[i].radius);
  };
  for (std::size_t i = 0; i <= n; ++i)
    if (i == 0 || i == n || !is_long(i)) lines[i].ahead = direction_of(lines[i].heading);
  for (std::size_t begin = 0; begin < n;) {
    const auto [first, last, kept] = group_from(*this, begin, [&](std::size_t i) { return !is_long(i); });
    if (first == 0) {
      follow_forwards(*this, 0);
    } else if (last + 1 == n) {
      follow_backwards(*this, last);
    }
    for (std::size_t i = kept + 1; i <= last; ++i) follow_forwards(*this, i);
    for (std::size_t i = kept; i-- > first;) follow_backwards(*this, i);
    begin = last + 1;
  }
  for (std::size_t i = 1; i < n; ++i)
    if (is_long(i) && !follow_circles(*this, i)) return false;
  return true;
}

bool ArcChain::is_drivable() const {
  for (std::size_t i = 0; i < arcs.size(); ++i)
    if (!(turn(i) > 0.0)) return false;
  return std::ranges::all_of(lines, [](const Line& line) { return line.is_tied || line.length > 0.0; });
}

bool cut_turns(const CircleChain& chain, std::span<const Bitangent> lines, const TurnCuts& cuts, ArcChain& result) {
  result.is_joined = true;
  result.start = chain.start;
  result.goal = chain.goal;
  result.arcs.clear();
  result.lines.clear();
  const std::size_t n = chain.circles.size();
  const double shortest = kShortest * std::ranges::min_element(chain.circles, {}, &TurnCircle::radius)->radius;
  double heading = chain.start.heading;
  for (std::size_t i = 0; i < n; ++i) {
    const TurnCircle& circle = chain.circles[i];
    const double sign = sign_of(circle.side);
    const double turn = turn_between(lines[i].start.heading, lines[i + 1].start.heading, circle.side);
    const bool is_tied = i > 0 && are_tied(chain, lines, i - 1);
    result.lines.push_back({heading, is_tied ? 0.0 : std::max(lines[i].length, shortest), is_tied});
    heading = add_turn({circle.center, circle.radius, sign, 0.0, 0.0}, heading, turn, cuts, result);
  }
  result.lines.push_back({heading, std::max(lines[n].length, shortest), false});
  return result.join() && result.is_drivable();
}

bool cut_turns(std::span<const PathSegment> path, const TurnCuts& cuts, ArcChain& result) {
  result.is_joined = false;
  result.arcs.clear();
  result.lines.clear();
  double tightest = kInfinity;
  for (const PathSegment& s : path)
    if (!s.is_line()) tightest = std::min(tightest, 1.0 / std::abs(s.curvature));
  result.start = path.front().start;
  result.goal = path.back().end();
  const double shortest = kShortest * tightest;
  double heading = result.start.heading, along = 0.0;  // since the arc before
  const auto add_line = [&](double sign, double gear) {
    const bool has_length = std::abs(along) > kNoLength * tightest;
    const ArcChain::Arc* before = result.arcs.empty() ? nullptr : &result.arcs.back();
    const bool changes_gear = before != nullptr && before->gear != gear;
    if (!has_length && before != nullptr && (changes_gear || before->sign == sign)) {
      result.lines.push_back({heading, 0.0, true, Vec2::Zero(), changes_gear ? 0.0 : gear});
    } else {
      const double at = before == nullptr ? result.start.heading : heading;
      result.lines.push_back({at, std::max(std::abs(along), shortest), false, Vec2::Zero(),
                              has_length ? std::copysign(1.0, along) : gear});
    }
    along = 0.0;
  };
  for (const PathSegment& s : path) {
    const double gear = sign_of(s.gear);
    if (s.length < shortest || s.is_line()) {
      along += gear * s.length;
      heading += gear * s.length * s.curvature;  // the arc before turns so much more
      continue;
    }
    const double radius = 1.0 / std::abs(s.curvature), sign = std::copysign(1.0, s.curvature);
    add_line(sign, gear);
    const Vec2 center = s.start.position() + sign * radius * perpendicular(direction_of(heading));
    heading = add_turn({center, radius, sign, 0.0, 0.0, gear}, heading, s.length / radius, cuts, result);
  }
  if (result.arcs.empty()) return false;
  const ArcChain::Arc& last = result.arcs.back();
  add_line(-last.sign, last.gear);  // the goal is tied to no arc
  return true;
}

PathSegment segment_of(const ArcChain& chain, std::size_t part) {
  const std::size_t i = part / 2;
  const ArcChain::Line& line = chain.lines[i];
  const Vec2 left = perpendicular(direction_of(line.heading));
  const Vec2 begin = chain.before(i) - chain.sideways(i) * left;
  const Pose at_line{begin.x(), begin.y(), line.heading};
  if (part % 2 == 0) return {at_line, line.length, 0.0, gear_of(line.gear)};
  const ArcChain::Arc& arc = chain.arcs[i];
  const Vec2 place = arc.center - arc.sign * arc.radius * left;
  return {{place.x(), place.y(), line.heading}, arc.radius * chain.turn(i), arc.sign / arc.radius, gear_of(arc.gear)};
}

void path_of(const ArcChain& chain, Path& path) {
  path.clear();
  for (std::size_t part = 0; part <= 2 * chain.arcs.size(); ++part) {
    const PathSegment segment = segment_of(chain, part);
    if (segment.length > 0.0) path.push_back(segment);
  }
}

void circles_of(const ArcChain& arcs, CircleChain& result) {
  result.start = arcs.start;
  result.goal = arcs.goal;
  result.lead_in = arcs.lines.front().length;
  result.lead_out = arcs.lines.back().length;
  result.circles.clear();
  const std::size_t n = arcs.arcs.size();
  const auto circle = [&](std::size_t i) {
    const ArcChain::Arc& arc = arcs.arcs[i];
    return TurnCircle{arc.center, arc.radius, arc.sign > 0.0 ? Side::kLeft : Side::kRight, kNone};
  };
  const auto touching = [&](const TurnCircle& other, std::size_t line, std::size_t i) {
    return turn_circle(pose_on(other, arcs.lines[line].heading), arcs.arcs[i].radius, other.side);
  };
  for (std::size_t begin = 0; begin < n;) {
    const auto [first, last, kept] = group_from(arcs, begin, [&](std::size_t i) { return arcs.lines[i].is_tied; });
    TurnCircle base = circle(kept);
    if (first == 0) {
      base = result.first_circle(result.lead_in, base.radius, base.side);
    } else if (last + 1 == n) {
      base = result.last_circle(result.lead_out, base.radius, base.side);
    }
    const auto is_same = [](double a, double b) { return std::abs(a - b) <= kOneRadius * std::min(a, b); };
    const auto at = result.circles.size();
    result.circles.push_back(base);
    for (std::size_t i = kept; i-- > first;) {
      const TurnCircle& next = result.circles[at];
      if (!is_same(next.radius, arcs.arcs[i].radius))
        result.circles.insert(result.circles.begin() + static_cast<std::ptrdiff_t>(at), touching(next, i + 1, i));
    }
    for (std::size_t i = kept + 1; i <= last; ++i) {
      const TurnCircle& previous = result.circles.back();
      if (!is_same(previous.radius, arcs.arcs[i].radius)) result.circles.push_back(touching(previous, i, i));
    }
    begin = last + 1;
  }
}

}  // namespace arcway::internal
