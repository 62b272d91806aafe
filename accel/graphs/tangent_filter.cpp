#include "accel/graphs/tangent_filter.h"

#include <algorithm>
#include <cmath>

#include "arcway/visibility_graph.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

TangentFilter::TangentFilter(const World& world)
    : world_(world), vertices_(world_.convex_vertices()), starts_(world.region_count() + 1, 0) {
  const Box& box = world_.box();
  Vec2 center(0.0, 0.0);
  double scale = 1.0;
  if (!box.empty()) {
    center = box.min + 0.5 * (box.max - box.min);
    scale = 2.0 / (box.max - box.min).maxCoeff();
  }
  for (const VertexId v : vertices_) {
    const Vec2& p = world_.vertex(v);
    const Vec2 at = (p - center) * scale;
    const Vec2 back = world_.vertex(world_.previous(v)) - p;
    const Vec2 ahead = world_.vertex(world_.next(v)) - p;
    x_.push_back(static_cast<float>(at.x()));
    y_.push_back(static_cast<float>(at.y()));
    back_x_.push_back(static_cast<float>(back.x() / back.lpNorm<1>()));
    back_y_.push_back(static_cast<float>(back.y() / back.lpNorm<1>()));
    ahead_x_.push_back(static_cast<float>(ahead.x() / ahead.lpNorm<1>()));
    ahead_y_.push_back(static_cast<float>(ahead.y() / ahead.lpNorm<1>()));
    ++starts_[world_.obstacle_of(v) + 1];
  }
  for (std::size_t o = 1; o < starts_.size(); ++o) starts_[o] += starts_[o - 1];
  for (std::vector<float>* values : {&x_, &y_, &back_x_, &back_y_, &ahead_x_, &ahead_y_})
    values->resize(vertices_.size() + kBlock, 0.0f);
}

std::array<float, TangentFilter::kBlock> TangentFilter::refuse(std::size_t u, std::size_t first) const {
  const float ux = x_[u], uy = y_[u];
  const float u_back_x = back_x_[u], u_back_y = back_y_[u];
  const float u_ahead_x = ahead_x_[u], u_ahead_y = ahead_y_[u];
  const float* x = &x_[first];
  const float* y = &y_[first];
  const float* back_x = &back_x_[first];
  const float* back_y = &back_y_[first];
  const float* ahead_x = &ahead_x_[first];
  const float* ahead_y = &ahead_y_[first];
  // The smaller magnitude of two numbers of opposite signs; negative for equal signs.
  const auto opposite = [](float s, float t) {
    const float down = s < -t ? s : -t;
    const float up = -s < t ? -s : t;
    return down > up ? down : up;
  };
  std::array<float, kBlock> result;
  for (std::size_t k = 0; k < kBlock; ++k) {
    const float dx = x[k] - ux;
    const float dy = y[k] - uy;
    const float at_v = opposite(dx * back_y[k] - dy * back_x[k], dx * ahead_y[k] - dy * ahead_x[k]);
    const float at_u = opposite(dx * u_back_y - dy * u_back_x, dx * u_ahead_y - dy * u_ahead_x);
    result[k] = at_v > at_u ? at_v : at_u;
  }
  return result;
}

bool TangentFilter::is_tangent_pair(std::size_t u, std::size_t v) const {
  const VertexId a = vertices_[u];
  const VertexId b = vertices_[v];
  return is_tangent(world_, a, world_.vertex(b)) && is_tangent(world_, b, world_.vertex(a));
}

}  // namespace arcway::internal
