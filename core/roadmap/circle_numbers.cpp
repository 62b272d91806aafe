#include "core/roadmap/circle_numbers.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace arcway::internal {

ConvexVertices::ConvexVertices(const World& world, std::shared_ptr<const HugeVector<VertexId>> of_origin)
    : of_origin_(std::move(of_origin)) {
  const auto vertices = static_cast<VertexId>(world.vertices().size());
  if (!of_origin_) {
    append_own(world, {0, vertices});
    return;
  }
  world.history().map().visit(
      vertices, [this](const World::VertexRange& range, VertexId before) { append_of_origin(range, before); },
      [&](const World::VertexRange& range) { append_own(world, range); });
}

void ConvexVertices::append_of_origin(const World::VertexRange& range, VertexId begin) {
  const auto first = std::ranges::lower_bound(*of_origin_, begin);
  const auto last = std::lower_bound(first, of_origin_->end(), begin + (range.last - range.first));
  if (first == last) return;
  const auto at = static_cast<std::size_t>(first - of_origin_->begin());
  pieces_.push_back({count_, range.first, at, true, begin - range.first});
  count_ += static_cast<std::size_t>(last - first);
}

void ConvexVertices::append_own(const World& world, const World::VertexRange& range) {
  const std::size_t at = own_.size();
  for (VertexId v = range.first; v < range.last; ++v)
    if (world.is_convex(v)) own_.push_back(v);
  if (own_.size() == at) return;
  pieces_.push_back({count_, range.first, at, false, 0});
  count_ += own_.size() - at;
}

VertexId ConvexVertices::operator[](std::size_t i) const {
  const Piece& piece = *(std::ranges::upper_bound(pieces_, i, {}, &Piece::index) - 1);
  return array_of(piece)[piece.at + i - piece.index] - piece.shift;
}

std::size_t ConvexVertices::index_of(VertexId v) const {
  const auto next = std::ranges::upper_bound(pieces_, v, {}, &Piece::first);
  if (next == pieces_.begin()) return count_;
  const Piece& piece = *(next - 1);
  const std::size_t length = (next == pieces_.end() ? count_ : next->index) - piece.index;
  const auto part = array_of(piece).subspan(piece.at, length);
  const auto at = std::ranges::lower_bound(part, v + piece.shift);
  if (at == part.end() || *at != v + piece.shift) return count_;
  return piece.index + static_cast<std::size_t>(at - part.begin());
}

CircleNumbers::CircleNumbers(const World& world, const TurnCircles& circles, const WorldHistory& later)
    : convex_(world, later.has_origin_of(world.history()) ? later.convex_of_origin() : nullptr) {
  const std::span<const TurnCircle> base = circles.all().first(circles.base_count());
  const auto first_pair = std::ranges::partition_point(base, [](const TurnCircle& c) { return c.second == kNone; });
  pairs_.assign(first_pair, base.end());
  if (convex_.size() > 0) around_ = static_cast<std::size_t>(first_pair - base.begin()) / convex_.size();
}

std::uint32_t CircleNumbers::before(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const {
  const TurnCircle& c = after.all()[circle];
  const VertexId vertex = map.before(c.vertex);
  if (vertex == kNone) return kNone;
  if (c.second == kNone) {
    const std::size_t index = convex_.index_of(vertex);
    if (index == convex_.size()) return kNone;
    return static_cast<std::uint32_t>(index * around_) + circle - after.first_around(c.vertex, Side::kLeft);
  }
  const VertexId second = map.before(c.second);
  const std::pair vertices(vertex, second);
  const auto vertices_of = [](const TurnCircle& pair) { return std::pair(pair.vertex, pair.second); };
  for (auto at = std::ranges::lower_bound(pairs_, vertices, {}, vertices_of);
       at != pairs_.end() && vertices_of(*at) == vertices; ++at)
    if (at->side == c.side && at->radius == c.radius)
      return static_cast<std::uint32_t>(convex_.size() * around_ + static_cast<std::size_t>(at - pairs_.begin()));
  return kNone;
}

std::uint32_t CircleNumbers::after(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const {
  const std::size_t own = convex_.size() * around_;
  if (circle < own) {
    const VertexId vertex = map.after(convex_[circle / around_]);
    if (vertex == kNone || !after.has(vertex)) return kNone;
    return after.first_around(vertex, Side::kLeft) + static_cast<std::uint32_t>(circle % around_);
  }
  const TurnCircle& pair = pairs_[circle - own];
  const VertexId vertex = map.after(pair.vertex), second = map.after(pair.second);
  std::uint32_t found = kNone;
  if (vertex == kNone || second == kNone || !after.has(vertex)) return found;
  after.visit_around(vertex, pair.side, [&](std::uint32_t other) {
    const TurnCircle& o = after.all()[other];
    if (o.vertex == vertex && o.second == second && o.radius == pair.radius) found = other;
  });
  return found;
}

}  // namespace arcway::internal
