#include "accel/embree/embree_queries.h"
#include "core/collision/blocking.h"

namespace arcway::internal::embree {

bool BlocksLineOfSight::operator()(VertexId edge) const { return blocks(world, edge, segment); }

void EmbreeVisibility::do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const {
  scenes_->for_batch(segments.size(), [&](std::size_t begin, std::size_t end) {
    const EdgeScene& edges = scenes_->visibility.edges();
    const LineSegment* located = nullptr;  // segments that share their first end locate it once
    bool is_free = true;
    for (std::size_t i = begin; i < end; ++i) {
      const LineSegment& s = segments[i];
      if (s.a != s.b && scenes_->visibility.any(edges.scaled(s.a), edges.scaled(s.b), {scenes_->world(), s})) {
        visible[i] = 0;
        continue;
      }
      if (located == nullptr || located->a != s.a) {
        located = &s;
        is_free = scenes_->locator.containing(s.a) == kNone;
      }
      visible[i] = is_free ? 1 : 0;
    }
  });
}

}  // namespace arcway::internal::embree
