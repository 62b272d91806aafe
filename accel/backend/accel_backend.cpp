#include "arcway/accel/accel_backend.h"

#include <memory>
#include <optional>
#include <utility>

#include "accel/backend/make_queries.h"
#include "accel/graphs/changed_graph.h"
#include "accel/graphs/lazy_rows.h"
#include "accel/graphs/pairwise_graph.h"
#include "arcway/accel/graph_builder.h"
#include "arcway/accel/parallel.h"
#include "arcway/accel/tangent_cone_graph.h"

namespace arcway {

using namespace internal;

namespace {

using Graph = Backend::Graph;

Graph shared(VisibilityGraph graph) { return std::make_shared<const VisibilityGraph>(std::move(graph)); }

// Embree uses the threads of the arena that it is called in.
QuerySet make_queries(const Backend& backend) {
  QuerySet queries;
  backend.executor().for_ranges(1, 1, [&](std::size_t, std::size_t) {
    queries = make_embree_queries(backend.world(), {.clock = backend.executor().clock()});
  });
  return queries;
}

Backend::Parts parts_of(const World& world, const AccelOptions& options) {
  Backend::Parts parts;
  parts.changed_parts = [builder = options.builder, reference_queries = options.reference_queries](
                            const Backend& before, const World& after, const WorldChange& change) {
    Backend::Parts changed = parts_of(after, {builder, reference_queries});
    if (std::optional<QuerySet> queries = change_embree_queries(before.queries(), after, change))
      changed.queries = [queries = *std::move(queries)](const Backend&) { return queries; };
    return changed;
  };
  parts.queries = make_queries;
  if (options.reference_queries) parts.queries = [](const Backend& b) { return make_reference_queries(b.world()); };
  if (options.builder.value_or(faster_graph_builder(world)) == GraphBuilder::kPairwise) {
    parts.reduced_graph = [](const Backend& b) {
      return shared(build_pairwise_visibility_graph(b.world(), *b.queries().visibility, b.executor()));
    };
    return parts;
  }
  parts.reduced_graph = [process_group = options.process_group](const Backend& b) {
    return shared(build_reduced_visibility_graph_by_tangent_cones(b.world(), b.executor(), nullptr,
                                                                  process_group ? *process_group : kSingleProcess));
  };
  parts.lazy_rows = [](const Backend& b) { return make_lazy_rows(b.world(), b.executor()); };
  parts.changed_graph = [](const Backend& b, const VisibilityGraph& before, const WorldChange& change) {
    return shared(change_reduced_visibility_graph(before, b.world(), change, b.executor()));
  };
  return parts;
}

}  // namespace

Backend accel_backend(const World& world) {
  return {world, parts_of(world, {}), std::make_shared<const TbbExecutor>()};
}

Backend accel_backend(const World& world, const Executor& executor, const AccelOptions& options) {
  return {world, parts_of(world, options), executor};
}

}  // namespace arcway
