#include "core/model/outlines.h"

#include <numeric>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kPieceEdges = 12;
// Share of the pieces that were built which may be removed or added since. A visit looks at removed ones in vain.
constexpr std::size_t kMostChangedOf = 8;

// The obstacles that were added, ascending.
std::vector<ObstacleId> added_obstacles(const World& after, const VertexMap& map) {
  std::vector<ObstacleId> added;
  for (const World::VertexRange& range : map.added()) added.push_back(after.obstacle_of(range.first));
  return added;
}

std::vector<ObstacleId> all_regions(const World& world) {
  std::vector<ObstacleId> all(world.region_count());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

Outlines::Pieces::Pieces(const World& world, std::span<const ObstacleId> regions) {
  const std::span<const Vec2> vertices = world.vertices();
  const auto add_ring = [&](VertexId first, VertexId last) {
    const VertexId edges = last - first;
    for (VertexId begin = 0; begin < edges; begin += kPieceEdges) {
      Box box;
      starts.push_back({first + begin, static_cast<std::uint32_t>(points.size())});
      for (VertexId i = begin; i <= std::min(begin + static_cast<VertexId>(kPieceEdges), edges); ++i) {
        points.push_back(vertices[first + i % edges]);
        box.extend(points.back());
      }
      boxes.push_back(box);
    }
  };
  for (const ObstacleId o : regions) {
    const auto rings = world.ring_starts(o);
    for (std::size_t r = 0; r < rings.size(); ++r)
      add_ring(rings[r], r + 1 < rings.size() ? rings[r + 1] : world.vertices_of(o).last);
  }
  starts.push_back({kNone, static_cast<std::uint32_t>(points.size())});
  tree = BoxTree(boxes);
}

Outlines::Changed::Changed(const World& after, const VertexMap& the_map)
    : world(after), map(the_map), added(after, added_obstacles(after, map)) {}

Outlines::Outlines(const World& world) : built_(std::make_shared<const Pieces>(world, all_regions(world))) {}

Outlines::Outlines(const Outlines& before, const World& after, const VertexMap& change)
    : built_(before.built_),
      changed_(std::make_shared<const Changed>(after, before.changed_ ? before.changed_->map.then(change) : change)) {}

bool Outlines::can_change(const VertexMap& change) const {
  const VertexMap map = changed_ ? changed_->map.then(change) : change;
  const std::size_t added = map.added_count() / kPieceEdges;
  return kMostChangedOf * (map.removed().size() + added) <= built_count();
}

std::size_t Outlines::size() const { return built_count() + (changed_ ? changed_->added.boxes.size() : 0); }

bool Outlines::has(std::uint32_t i) const {
  return !changed_ || i >= built_count() || changed_->map.after(built_->starts[i].vertex) != kNone;
}

Outlines::Piece Outlines::operator[](std::uint32_t i) const {
  if (!changed_) return (*built_)[i];
  if (i < built_count()) return now(i, changed_->map.after(built_->starts[i].vertex));
  return changed_->added[i - static_cast<std::uint32_t>(built_count())];
}

std::uint32_t Outlines::index_of(VertexId v) const {
  if (!changed_) return built_->index_of(v);
  const VertexId before = changed_->map.before(v);
  if (before != kNone) return built_->index_of(before);
  return static_cast<std::uint32_t>(built_count()) + changed_->added.index_of(v);
}

const VertexMap* Outlines::change() const { return changed_ ? &changed_->map : nullptr; }

const Outlines& Outlines::as_new() const {
  if (!changed_) return *this;
  return **changed_->anew.get(StopClock(), [&] { return std::make_unique<const Outlines>(changed_->world); });
}

}  // namespace arcway::internal
