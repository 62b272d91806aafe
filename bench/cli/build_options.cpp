#include <algorithm>
#include <memory>
#include <thread>

#include "bench/cli/arguments.h"
#ifdef ARCWAY_WITH_ACCEL
#include "arcway/accel/accel_backend.h"
#include "arcway/accel/graph_builder.h"
#include "arcway/accel/parallel.h"
#include "arcway/accel/visibility_map.h"
#endif

namespace arcway::internal::cli {
namespace {

#ifdef ARCWAY_WITH_ACCEL
constexpr bool kHasAccel = true;
#else
constexpr bool kHasAccel = false;
#endif

}  // namespace

BuildOptions::BuildOptions() : backend(kHasAccel ? "embree" : "reference") {}

void BuildOptions::add_to(CLI::App& command) {
  command.add_option("--backend", backend, "What answers the geometric queries: embree, or reference (brute force)")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--builder", builder, "How the visibility graph is built: pairwise, tangent-cones, or auto")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--threads", threads, "Threads to compute with; default: all with embree, one with reference")
      ->type_name("N");
}

void BuildOptions::check() const {
  if (backend != "reference" && backend != "embree") {
    throw UsageError("--backend: unknown backend " + in_quotes(backend) +
                     "; this build has: " + (kHasAccel ? "embree, reference" : "reference"));
  }
  if (builder != "auto" && builder != "pairwise" && builder != "tangent-cones") {
    throw UsageError("--builder: expected auto, pairwise or tangent-cones, got " + in_quotes(builder));
  }
  if (!kHasAccel && backend == "embree") {
    throw UsageError("--backend: this build has no embree backend; use --backend reference");
  }
  if (!kHasAccel && builder == "tangent-cones") {
    throw UsageError("--builder: this build has no tangent-cone builder; use --builder pairwise");
  }
  const std::size_t count = threads_asked_for();
  if (count < 1) throw UsageError("--threads: at least 1, got " + in_quotes(threads));
  if (!kHasAccel && count > 1) throw UsageError("--threads: this build has one thread, got " + in_quotes(threads));
  if (count > 1024) throw UsageError("--threads: at most 1024, got " + in_quotes(threads));
}

std::size_t BuildOptions::threads_asked_for() const {
  if (!threads.empty()) return parse_count(threads, "--threads");
  return backend == "embree" ? std::max(1u, std::thread::hardware_concurrency()) : 1;
}

std::string BuildOptions::summary(const World& world) const {
  const std::size_t count = thread_count();
  return builder_name(world) + ", " + backend + ", " + count_text(count) + (count == 1 ? " thread" : " threads");
}

#ifdef ARCWAY_WITH_ACCEL

std::size_t BuildOptions::thread_count() const { return TbbExecutor(threads_asked_for()).threads(); }

QuerySet BuildOptions::queries(const World& world, const Executor& executor) const {
  return backend_for(world, executor, kSingleProcess).queries();
}

std::unique_ptr<const Executor> BuildOptions::executor() const {
  return std::make_unique<const TbbExecutor>(threads_asked_for());
}

std::string BuildOptions::builder_name(const World& world) const {
  if (prepared) return "prepared";
  if (builder != "auto") return builder;
  return name_of(backend == "reference" ? GraphBuilder::kPairwise : faster_graph_builder(world));
}

Backend BuildOptions::backend_for(const World& world, const Executor& executor,
                                  const ProcessGroup& process_group) const {
  const bool reference = backend == "reference";
  if (reference && builder != "tangent-cones") return backend_of(world, make_reference_queries(world), executor);
  AccelOptions options{.reference_queries = reference, .process_group = &process_group};
  if (builder != "auto")
    options.builder = builder == "tangent-cones" ? GraphBuilder::kTangentCones : GraphBuilder::kPairwise;
  return accel_backend(world, executor, options);
}

VisibilityGraph BuildOptions::full_graph_of(const World& world, const Executor& executor) const {
  if (builder_name(world) == "tangent-cones") return build_full_visibility_graph_by_expansion(world, executor);
  return build_full_visibility_graph(world, *queries(world, executor).visibility, executor);
}

#else

std::size_t BuildOptions::thread_count() const { return 1; }
std::string BuildOptions::builder_name(const World&) const { return prepared ? "prepared" : "pairwise"; }

QuerySet BuildOptions::queries(const World& world, const Executor&) const { return make_reference_queries(world); }
std::unique_ptr<const Executor> BuildOptions::executor() const { return std::make_unique<const SerialExecutor>(); }
Backend BuildOptions::backend_for(const World& world, const Executor& executor, const ProcessGroup&) const {
  return backend_of(world, make_reference_queries(world), executor);
}
VisibilityGraph BuildOptions::full_graph_of(const World& world, const Executor& executor) const {
  return build_full_visibility_graph(world, *queries(world, executor).visibility, executor);
}

#endif

VisibilityGraph BuildOptions::reduced_graph_of(const World& world, const Executor& executor,
                                               const ProcessGroup& process_group) const {
  return *backend_for(world, executor, process_group).reduced_graph();
}

}  // namespace arcway::internal::cli
