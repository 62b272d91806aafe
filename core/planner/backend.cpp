#include "arcway/backend.h"

#include <mutex>
#include <stdexcept>
#include <utility>

namespace arcway {

namespace {

using Graph = Backend::Graph;

Graph shared(VisibilityGraph graph) { return std::make_shared<const VisibilityGraph>(std::move(graph)); }

Graph build_reference_graph(const Backend& backend) {
  return shared(build_reduced_visibility_graph(backend.world(), *backend.queries().visibility, backend.executor()));
}

Backend::Parts reference_parts() {
  return {.queries = [](const Backend& backend) { return make_reference_queries(backend.world()); },
          .reduced_graph = build_reference_graph,
          .changed_parts = [](const Backend&, const World&, const WorldChange&) { return reference_parts(); }};
}

}  // namespace

struct Backend::Data {
  Data(const World& w, Parts p, std::shared_ptr<const Executor> e)
      : world(w), parts(std::move(p)), executor(std::move(e)) {
    if (!parts.queries) throw std::invalid_argument("backend: no maker of queries");
    if (!parts.reduced_graph && !parts.lazy_rows)
      throw std::invalid_argument("backend: no maker of reduced graphs, nor of their rows");
  }

  World world;
  Parts parts;
  std::shared_ptr<const Executor> executor;
  mutable std::once_flag made;
  mutable QuerySet queries;
};

Backend::Backend(const World& world, Parts parts, std::shared_ptr<const Executor> executor)
    : data_(std::make_shared<const Data>(world, std::move(parts), std::move(executor))) {}

// Without a count of users: the caller keeps it.
Backend::Backend(const World& world, Parts parts, const Executor& executor)
    : Backend(world, std::move(parts), std::shared_ptr<const Executor>(std::shared_ptr<const void>(), &executor)) {}

const World& Backend::world() const { return data_->world; }
const Executor& Backend::executor() const { return *data_->executor; }

const QuerySet& Backend::queries() const {
  const Data& d = *data_;
  std::call_once(d.made, [&] {
    QuerySet queries = d.parts.queries(*this);
    if (!queries.visibility || !queries.distance || !queries.sweep)
      throw std::invalid_argument("queries: one of visibility, distance and sweep is missing");
    d.queries = std::move(queries);
  });
  return d.queries;
}

bool Backend::has_lazy_rows() const { return data_->parts.lazy_rows != nullptr; }
bool Backend::has_graphs() const { return data_->parts.reduced_graph != nullptr; }
std::shared_ptr<const VisibilityRows> Backend::lazy_rows() const { return data_->parts.lazy_rows(*this); }
Graph Backend::reduced_graph() const { return data_->parts.reduced_graph(*this); }

Graph Backend::changed_graph(const VisibilityGraph& before, const WorldChange& change) const {
  return data_->parts.changed_graph ? data_->parts.changed_graph(*this, before, change) : reduced_graph();
}

Backend Backend::changed(const World& after, const WorldChange& change) const {
  if (!data_->parts.changed_parts)
    throw std::invalid_argument(
        "backend: its parts are of its own world; make a backend of the changed world for Planner::changed");
  return {after, data_->parts.changed_parts(*this, after, change), data_->executor};
}

Backend reference_backend(const World& world) { return {world, reference_parts(), kSerialExecutor}; }

Backend backend_of(const World& world, const QuerySet& queries, const Executor& executor) {
  return {world,
          {.queries = [queries](const Backend&) { return queries; }, .reduced_graph = build_reference_graph},
          executor};
}

Backend backend_of(const World& world, const QuerySet& queries, VisibilityGraph graph, const Executor& executor) {
  return {world,
          {.queries = [queries](const Backend&) { return queries; },
           .reduced_graph = [given = shared(std::move(graph))](const Backend&) { return given; }},
          executor};
}

Backend backend_of(const World& world, const QuerySet& queries, std::shared_ptr<const VisibilityRows> rows,
                   const Executor& executor) {
  if (!rows) throw std::invalid_argument("rows: none are given");
  return {world,
          {.queries = [queries](const Backend&) { return queries; },
           .lazy_rows = [rows = std::move(rows)](const Backend&) { return rows; }},
          executor};
}

}  // namespace arcway
