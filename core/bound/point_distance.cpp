#include "core/bound/point_distance.h"

#include <limits>
#include <queue>
#include <unordered_map>
#include <unordered_set>

namespace arcway {

namespace {

enum class Step : std::uint8_t {
  kFromStart,  // a segment from the start to a vertex, not yet asked for
  kEdge,       // an edge of the graph to a vertex
  kToGoal      // a segment from a vertex, or from the start, to the goal, not yet asked for
};

struct Entry {
  double estimate;  // of the whole path
  double length;    // up to the vertex, or up to the goal
  VertexId vertex;  // kNone: the start itself
  Step step;
  bool operator<(const Entry& other) const { return estimate > other.estimate; }  // the queue has the largest on top
};

}  // namespace

PointDistance::PointDistance(const World& world, const VisibilityGraph& graph)
    : world_(world), row_starts_(graph.vertex_count() + 1, 0), neighbors_(2 * graph.edge_count()) {
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) {
      ++row_starts_[u + 1];
      ++row_starts_[v + 1];
    }
  for (std::size_t i = 1; i < row_starts_.size(); ++i) row_starts_[i] += row_starts_[i - 1];
  std::vector<std::uint64_t> next(row_starts_.begin(), row_starts_.end());
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) {
      neighbors_[next[u]++] = v;
      neighbors_[next[v]++] = u;
    }
}

double PointDistance::operator()(const Vec2& start, const Vec2& goal, const VisibilityQuery& visibility) const {
  const auto to_goal = [&](const Vec2& p) { return (goal - p).norm(); };
  std::vector<Entry> entries{{to_goal(start), to_goal(start), kNone, Step::kToGoal}};
  entries.reserve(world_.convex_vertices().size() + 1);
  for (const VertexId v : world_.convex_vertices()) {
    const double length = (world_.vertex(v) - start).norm();
    entries.push_back({length + to_goal(world_.vertex(v)), length, v, Step::kFromStart});
  }
  std::priority_queue<Entry> open(std::less<Entry>(), std::move(entries));
  std::unordered_set<VertexId> closed;
  std::unordered_map<VertexId, double> best;

  while (!open.empty()) {
    const Entry entry = open.top();
    open.pop();
    const Vec2& here = entry.vertex == kNone ? start : world_.vertex(entry.vertex);
    if (entry.step == Step::kToGoal) {
      if (visibility.visible({here, goal})) return entry.length;
      continue;
    }
    if (closed.contains(entry.vertex)) continue;
    if (entry.step == Step::kFromStart &&
        !(is_tangent(world_, entry.vertex, start) && visibility.visible({start, here})))
      continue;
    closed.insert(entry.vertex);
    if (is_tangent(world_, entry.vertex, goal))
      open.push({entry.length + to_goal(here), entry.length + to_goal(here), entry.vertex, Step::kToGoal});
    for (std::uint64_t i = row_starts_[entry.vertex]; i < row_starts_[entry.vertex + 1]; ++i) {
      const VertexId v = neighbors_[i];
      const double length = entry.length + (world_.vertex(v) - here).norm();
      const auto [known, is_new] = best.try_emplace(v, length);
      if (!is_new && known->second <= length) continue;
      known->second = length;
      open.push({length + to_goal(world_.vertex(v)), length, v, Step::kEdge});
    }
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace arcway
