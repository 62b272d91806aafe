#include "accel/backend/make_queries.h"

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "accel/embree/configured_queries.h"
#include "accel/embree/embree_queries.h"
#include "core/base/shortest_text.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

namespace {

double inflation_of(const World& world, double body_half_width) {
  if (body_half_width > 0.0) return body_half_width;
  double sum = 0.0;
  for (const LineSegment& edge : world.edges()) sum += (edge.b - edge.a).norm();
  return world.edges().empty() ? 0.0 : 0.5 * sum / static_cast<double>(world.edges().size());
}

}  // namespace

namespace embree {

Scenes::Scenes(const World& world, const EmbreeOptions& options, const char* device_config, std::size_t many_edges)
    : Scenes(world, options, std::make_shared<const Device>(device_config), many_edges) {}

Scenes::Scenes(const World& world, const EmbreeOptions& options, const std::shared_ptr<const Device>& device,
               std::size_t many_edges)
    : locator(world),
      batches(options.batches),
      visibility(device, world, {.many_edges = many_edges, .clock = options.clock}),
      sweep(device, world, {inflation_of(world, options.body_half_width), many_edges, options.clock}) {}

Scenes::Scenes(const Scenes& before, const World& after, const VertexMap& change)
    : locator(before.locator, after, change),
      batches(before.batches),
      visibility(before.visibility, after, change),
      sweep(before.sweep, after, change) {}

namespace {

QuerySet queries_of(const std::shared_ptr<const Scenes>& scenes) {
  return {std::make_shared<const EmbreeVisibility>(scenes), std::make_shared<const EmbreeDistance>(scenes),
          std::make_shared<const EmbreeSweep>(scenes)};
}

}  // namespace

QuerySet make_configured_queries(const World& world, const EmbreeOptions& options, const char* device_config,
                                 std::size_t many_edges) {
  if (!(options.body_half_width >= 0.0) || !std::isfinite(options.body_half_width))
    throw std::invalid_argument("embree queries: body half width " + shortest_text(options.body_half_width) +
                                " must be >= 0 and finite");
  return queries_of(std::make_shared<const Scenes>(world, options, device_config, many_edges));
}

}  // namespace embree

std::optional<QuerySet> change_embree_queries(const QuerySet& before, const World& after, const WorldChange& change) {
  const auto* visibility = dynamic_cast<const embree::EmbreeVisibility*>(before.visibility.get());
  const VertexMap map(change);
  if (!visibility || !visibility->scenes().can_change(after, map)) return std::nullopt;
  return embree::queries_of(std::make_shared<const embree::Scenes>(visibility->scenes(), after, map));
}

QuerySet make_embree_queries(const World& world, const EmbreeOptions& options) {
  return embree::make_configured_queries(world, options, "", embree::EdgeScene::kManyEdges);
}

}  // namespace arcway::internal
