#include "core/graph/turn_circles.h"

namespace arcway {

TurnCircles::TurnCircles(const World& world, const VisibilityRows& rows, std::span<const double> radii,
                         const Footprint& grown_body)
    : radius_count_(radii.size()), first_(world.vertices().size(), kNone), shared_starts_(first_.size() + 1, 0) {
  for (const VertexId v : world.convex_vertices()) {
    first_[v] = static_cast<std::uint32_t>(circles_.size());
    for (const double radius : radii)
      for (const Side side : {Side::kLeft, Side::kRight})
        circles_.push_back(turn_circle(world, v, radius, side, grown_body));
  }

  const auto leads_back = [&](VertexId u, VertexId w) {
    return (circles_[first_[w]].center - circles_[first_[u]].center).dot(world.vertex(w) - world.vertex(u)) <= 0.0;
  };
  // No circle goes round two vertices that are further apart.
  const double reach = 2.0 * swept_annulus(grown_body, radii[0]).inner * (1.0 + 1e-9);
  for (const auto& [u, w] : rows.pairs_within(reach, leads_back)) {
    const Side side = obstacle_side(world, w, world.vertex(u));  // travelling from u to w
    if (obstacle_side(world, u, world.vertex(w)) == side) continue;
    const auto circle = turn_circle(world, u, w, radii[0], side, grown_body);
    if (!circle) continue;
    for (const VertexId v : {u, w}) ++shared_starts_[v + 1];
    for (const Side turn : {Side::kLeft, Side::kRight}) {
      circles_.push_back(*circle);
      circles_.back().side = turn;
    }
  }
  for (std::size_t v = 0; v < first_.size(); ++v) shared_starts_[v + 1] += shared_starts_[v];
  shared_.resize(shared_starts_.back());
  std::vector<std::uint64_t> next(shared_starts_.begin(), shared_starts_.end() - 1);
  const std::size_t own = 2 * radius_count_ * world.convex_vertices().size();
  for (auto c = static_cast<std::uint32_t>(own); c < circles_.size(); c += 2)
    for (const VertexId v : {circles_[c].vertex, circles_[c].second}) shared_[next[v]++] = c;
}

}  // namespace arcway
