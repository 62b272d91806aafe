#include "core/alternatives.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/geometry/angle.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "core/path/speed_profile.h"
#include "core/query/walled_sweep.h"

namespace arcway {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPieceTurn = 1.5;         // of the pieces that arcs are taken in, less than half a circle [rad]
constexpr std::size_t kMostPassages = 10;  // of a path, the narrowest ones
constexpr double kSamplesPerSegment = 8.0;

// Where a path goes through between two obstacles.
struct Passage {
  ObstacleId left, right;  // kNone: nothing on that side
  double width;
  std::array<LineSegment, 2> walls;  // from the path to either side
};

// What is nearest to a point on one side of a line through it.
struct Nearest {
  double distance = kInfinity;
  Vec2 point{0.0, 0.0};
  ObstacleId region = kNone;
};

Nearest nearest_on_side(const World& world, const Vec2& from, const Vec2& normal) {
  Nearest nearest;
  for (VertexId e = 0; e < world.edges().size(); ++e) {
    LineSegment edge = world.edges()[e];
    const double a = normal.dot(edge.a - from);
    const double b = normal.dot(edge.b - from);
    if (a <= 0.0 && b <= 0.0) continue;
    if (a < 0.0) edge.a += a / (a - b) * (edge.b - edge.a);
    if (b < 0.0) edge.b += b / (b - a) * (edge.a - edge.b);
    const Vec2 point = closest_point(from, edge);
    const double distance = (point - from).norm();
    if (distance < nearest.distance) nearest = {distance, point, world.obstacle_of(e)};
  }
  if (nearest.region != kNone) return nearest;
  const Box& box = world.box();
  const double far = box.empty() ? 0.0 : 4.0 * (box.max - box.min).norm() + (from - box.min).norm();
  return {far, from + far * normal, kNone};
}

std::vector<Passage> passages_of(const PlanResult& plan, const Planner& planner) {
  const World& world = planner.world();
  const Footprint body = planner.vehicle().footprint(planner.vehicle().safety_margin());
  const std::array<SweptRectangle, 2> ends = {swept_rectangle(plan.start, 0.0, body),
                                              swept_rectangle(plan.goal, 0.0, body)};
  std::vector<Passage> passages;
  for (const TimedSegment& timed : plan.segments) {
    const PathSegment& s = timed.segment;
    for (double i = 1.0; i <= kSamplesPerSegment; ++i) {
      const Pose pose = s.at(s.length * (i / kSamplesPerSegment));
      const Vec2 side = perpendicular(direction_of(pose.heading));
      const Nearest left = nearest_on_side(world, pose.position(), side);
      const Nearest right = nearest_on_side(world, pose.position(), -side);
      if (left.region == right.region) continue;
      const Passage passage{left.region,
                            right.region,
                            left.distance + right.distance,
                            {LineSegment{pose.position(), left.point}, LineSegment{pose.position(), right.point}}};
      const bool at_an_end = std::any_of(passage.walls.begin(), passage.walls.end(), [&](const LineSegment& wall) {
        return intersects(wall, ends[0]) || intersects(wall, ends[1]);
      });
      if (at_an_end) continue;
      const auto known = std::find_if(passages.begin(), passages.end(), [&](const Passage& p) {
        return p.left == passage.left && p.right == passage.right;
      });
      if (known == passages.end()) {
        passages.push_back(passage);
      } else if (passage.width < known->width) {
        *known = passage;
      }
    }
  }
  std::stable_sort(passages.begin(), passages.end(),
                   [](const Passage& a, const Passage& b) { return a.width < b.width; });
  if (passages.size() > kMostPassages) passages.resize(kMostPassages);
  return passages;
}

// Whether a point lies between an arc of less than half a circle and its chord.
bool is_cut_off(const PathSegment& arc, const Vec2& from, const Vec2& to, const Vec2& point) {
  const double side = sign_of(arc.gear) * arc.curvature;  // > 0: the arc lies to the right of its chord
  if (orientation(from, to, point) * side >= 0.0) return false;
  const Vec2 center = arc.start.position() + perpendicular(direction_of(arc.start.heading)) / arc.curvature;
  return (point - center).norm() * std::abs(arc.curvature) < 1.0;
}

// How far a path turns about a point, seen from there [rad]: an arc as its chord does, but the other way round what
// lies between the two.
double turn_about(std::span<const PathSegment> path, const Vec2& point) {
  double turn = 0.0;
  for (const PathSegment& s : path) {
    const double pieces = std::max(1.0, std::ceil(s.length * std::abs(s.curvature) / kPieceTurn));
    Vec2 from = s.start.position();
    for (double i = 1.0; i <= pieces; ++i) {
      const Vec2 to = s.at(s.length * (i / pieces)).position();
      const Vec2 a = from - point, b = to - point;
      turn += std::atan2(cross(a, b), a.dot(b));
      if (!s.is_line() && is_cut_off(s, from, to, point)) turn += std::copysign(kTwoPi, sign_of(s.gear) * s.curvature);
      from = to;
    }
  }
  return turn;
}

class AlternativeSearch {
 public:
  AlternativeSearch(const Planner& planner, const PlanRequest& request, const PlanLimits& limits)
      : planner_(planner), request_(request), limits_(limits) {}

  std::vector<PlanResult> run(std::size_t count) {
    taken_.push_back({planner_.plan(request_, limits_), {}});
    while (taken_.back().plan.solved() && taken_.size() < count && !interrupted()) {
      branch(taken_.back());
      const auto best = std::min_element(open_.begin(), open_.end(),
                                         [&](const Way& a, const Way& b) { return cost_of(a.plan) < cost_of(b.plan); });
      if (best == open_.end()) break;
      Way way = std::move(*best);
      open_.erase(best);
      taken_.push_back(std::move(way));
    }
    std::vector<PlanResult> plans;
    for (Way& way : taken_) plans.push_back(std::move(way.plan));
    std::stable_sort(plans.begin(), plans.end(),
                     [&](const PlanResult& a, const PlanResult& b) { return cost_of(a) < cost_of(b); });
    return plans;
  }

 private:
  struct Way {
    PlanResult plan;
    std::vector<LineSegment> walls;  // it was planned with
  };

  using Clock = std::chrono::steady_clock;
  [[nodiscard]] PlanLimits rest() const {
    PlanLimits rest = limits_;
    rest.time -= std::chrono::duration<double>(Clock::now() - begin_).count();
    return rest;
  }
  [[nodiscard]] bool interrupted() const { return limits_.stop.stop_requested() || rest().time <= 0.0; }
  [[nodiscard]] double cost_of(const PlanResult& plan) const {
    return travel_cost(plan.path(), planner_.vehicle(), request_.cusp_cost);
  }

  // Adds the ways that do without one of the passages of a way.
  void branch(const Way& way) {
    const std::vector<LineSegment> walls = way.walls;
    for (const Passage& passage : passages_of(way.plan, planner_)) {
      if (interrupted()) return;
      Way other{{}, walls};
      other.walls.insert(other.walls.end(), passage.walls.begin(), passage.walls.end());
      other.plan = plan_with(other.walls);
      if (other.plan.solved() && is_new(other.plan)) open_.push_back(std::move(other));
    }
  }

  [[nodiscard]] PlanResult plan_with(const std::vector<LineSegment>& walls) const {
    QuerySet queries = planner_.queries();
    queries.sweep = std::make_shared<WalledSweep>(queries.sweep, walls);
    PlannerOptions options = planner_.options();
    options.graph_mode = GraphMode::kLazy;
    const Planner walled(planner_.world(), planner_.vehicle(), queries, planner_.visibility_rows(), options,
                         SerialExecutor());
    PlanLimits limits = rest();
    limits.tree_poses = 0;  // most have no path
    return walled.plan(request_, limits);
  }

  [[nodiscard]] bool is_new(const PlanResult& plan) const {
    const Path path = plan.path();
    const auto same = [&](const Way& way) { return same_way(way.plan.path(), path, planner_.world()); };
    return std::none_of(taken_.begin(), taken_.end(), same) && std::none_of(open_.begin(), open_.end(), same);
  }

  const Planner& planner_;
  const PlanRequest& request_;
  const PlanLimits& limits_;
  Clock::time_point begin_ = Clock::now();
  std::vector<Way> taken_, open_;
};

}  // namespace

std::vector<PlanResult> plan_alternatives(const Planner& planner, const PlanRequest& request, std::size_t count,
                                          const PlanLimits& limits) {
  if (count == 0) throw std::invalid_argument("alternatives: at least one must be asked for");
  return AlternativeSearch(planner, request, limits).run(count);
}

bool same_way(std::span<const PathSegment> a, std::span<const PathSegment> b, const World& world) {
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o) {
    const Vec2& corner = world.vertex(world.vertices_of(o).first);
    if (std::abs(turn_about(a, corner) - turn_about(b, corner)) > kPi) return false;
  }
  return true;
}

}  // namespace arcway
