#include "bench/peers/visibility_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>

#include "arcway/datasets/catalog.h"
#include "arcway/query_set.h"
#include "arcway/visibility_graph.h"
#include "bench/cpu_clock.h"
#include "bench/peers/ours.h"
#include "core/roadmap/tangent_edges.h"
#include "datasets/io/random.h"
#ifdef ARCWAY_PEER_CGAL
#include "bench/peers/cgal_peer.h"
#endif
#ifdef ARCWAY_WITH_ACCEL
#include "accel/expansion/tangent_neighbors.h"
#include "arcway/accel/parallel.h"
#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/accel/visibility_map.h"
#endif

namespace arcway::internal::peers {
namespace {

/// Lists of vertices one after the other: the form of all answers, so that they can be compared.
struct Rows {
  std::vector<std::uint64_t> starts{0};
  std::vector<VertexId> values;

  void add(std::span<const VertexId> row) {
    values.insert(values.end(), row.begin(), row.end());
    starts.push_back(values.size());
  }
  friend bool operator==(const Rows&, const Rows&) = default;
};

/// What both sides of a duel do with a world.
struct Contest {
  std::string task, ours, peer;
  std::function<Rows(const World&)> our_answer, peer_answer;
  double exponent;  ///< growth of the slower one over the obstacles, to leave out what would take too long
  bool comparable = true;
  std::size_t threads = 1;  ///< ours
};

std::string world_name(std::size_t obstacles) { return "clutter/convex/n" + std::to_string(obstacles) + "/m10/f30/s1"; }

/// A hundred vertices in no order, the same for both sides.
std::vector<VertexId> some_vertices(const World& world) {
  Random random(1);
  std::vector<VertexId> vertices;
  const auto convex = world.convex_vertices();
  for (int i = 0; i < 100; ++i) vertices.push_back(convex[random.below(convex.size())]);
  return vertices;
}

Rows rows_of(const VisibilityGraph& graph) {
  return {{graph.row_starts().begin(), graph.row_starts().end()}, {graph.targets().begin(), graph.targets().end()}};
}

Rows reduced_by_brute_force(const World& world) {
  return rows_of(build_reduced_visibility_graph(world, *make_reference_queries(world).visibility));
}

/// Lines of sight from some vertices to the 200 that follow them in the numbering.
Rows lines_of_sight(const World& world, const QuerySet& queries) {
  Rows rows;
  for (const VertexId u : some_vertices(world)) {
    const std::size_t count = world.vertices().size();
    std::vector<LineSegment> lines;
    for (std::size_t i = 1; i <= 200; ++i)
      lines.push_back({world.vertex(u), world.vertex(static_cast<VertexId>((u + i) % count))});
    std::vector<std::uint8_t> visible(lines.size());
    queries.visibility->visible(lines, visible);
    rows.add(std::vector<VertexId>(visible.begin(), visible.end()));
  }
  return rows;
}

#ifdef ARCWAY_PEER_CGAL
std::span<const VertexId> above(VertexId u, const std::vector<VertexId>& ascending) {
  return {std::ranges::upper_bound(ascending, u), ascending.end()};
}

Rows full_by_cgal(const World& world) {
  const CgalVisibility visibility(world);
  Rows rows;
  for (VertexId u = 0; u < world.vertices().size(); ++u) rows.add(above(u, visibility.visible_from(u)));
  return rows;
}

std::vector<VertexId> tangent_ones(const World& world, VertexId u, const std::vector<VertexId>& seen) {
  std::vector<VertexId> kept;
  for (const VertexId v : seen)
    if (world.is_convex(v) && is_tangent(world, u, world.vertex(v)) && is_tangent(world, v, world.vertex(u)))
      kept.push_back(v);
  return kept;
}

Rows reduced_by_cgal(const World& world) {
  const CgalVisibility visibility(world);
  Rows rows;
  for (VertexId u = 0; u < world.vertices().size(); ++u) {
    if (world.is_convex(u)) {
      rows.add(above(u, tangent_ones(world, u, visibility.visible_from(u))));
    } else {
      rows.add({});
    }
  }
  return rows;
}
#endif

std::vector<Contest> contests() {
  std::vector<Contest> all;
  all.push_back({"reduced graph", kOurReducedBuilder, "brute force",
                 [](const World& w) { return rows_of(our_reduced_graph(w)); }, reduced_by_brute_force, 2.5});
  all.push_back({"20,000 lines of sight", kOurQueries, "brute force",
                 [](const World& w) { return lines_of_sight(w, our_queries(w)); },
                 [](const World& w) { return lines_of_sight(w, make_reference_queries(w)); }, 1.0});
#ifdef ARCWAY_PEER_CGAL
  all.push_back({"reduced graph", kOurReducedBuilder, "CGAL expansion",
                 [](const World& w) { return rows_of(our_reduced_graph(w)); }, reduced_by_cgal, 1.3});
  all.push_back({"full graph", kOurFullBuilder, "CGAL expansion",
                 [](const World& w) { return rows_of(our_full_graph(w)); }, full_by_cgal, 1.3});
#ifdef ARCWAY_WITH_ACCEL
  all.push_back({"tangent neighbors of 100 vertices", kOurReducedBuilder, "CGAL expansion",
                 [](const World& w) {
                   const TangentNeighbors neighbors(w);
                   Rows rows;
                   for (const VertexId u : some_vertices(w)) rows.add(neighbors.of(u));
                   return rows;
                 },
                 [](const World& w) {
                   const CgalVisibility visibility(w);
                   Rows rows;
                   for (const VertexId u : some_vertices(w)) rows.add(tangent_ones(w, u, visibility.visible_from(u)));
                   return rows;
                 },
                 1.2});
  all.push_back({"vertices seen from 100 vertices", kOurFullBuilder, "CGAL expansion",
                 [](const World& w) {
                   const VisibilityMap map(w);
                   Rows rows;
                   for (const VertexId u : some_vertices(w)) rows.add(map.visible_from(u));
                   return rows;
                 },
                 [](const World& w) {
                   const CgalVisibility visibility(w);
                   Rows rows;
                   for (const VertexId u : some_vertices(w)) rows.add(visibility.visible_from(u));
                   return rows;
                 },
                 1.2});
#endif
  const auto triangulation = [](const World& w) { return Rows{{triangulate_by_cgal(w)}, {}}; };
  all.push_back({"reduced graph, against a triangulation alone", kOurReducedBuilder, "CGAL triangulation",
                 [](const World& w) { return rows_of(our_reduced_graph(w)); }, triangulation, 1.1, false});
#ifdef ARCWAY_WITH_ACCEL
  all.push_back({"reduced graph by two threads, against a triangulation alone by one", kOurReducedBuilder,
                 "CGAL triangulation",
                 [](const World& w) {
                   const TbbExecutor two(2);
                   return rows_of(build_reduced_visibility_graph_by_tangent_cones(w, two));
                 },
                 triangulation, 1.1, false, 2});
#endif
#endif
  return all;
}

struct Times {
  double wall, processor;  ///< [s]
};

Times times_of(const std::function<Rows(const World&)>& answer, const World& world, std::size_t times) {
  const bench::CpuClock processor(bench::CpuClock::Of::kProcess);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < times; ++i) (void)answer(world);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count() / static_cast<double>(times), processor.seconds() / static_cast<double>(times)};
}

/// Enough repetitions in a row that the clock's steps and a cold cache do not matter.
std::size_t times_for(double seconds) {
  constexpr double kLeast = 0.02;
  return static_cast<std::size_t>(std::clamp(std::ceil(kLeast / std::max(seconds, 1e-9)), 1.0, 1e4));
}

/// @return  seconds of the slower side; the times are in the duel.
double fight(const Contest& contest, const World& world, std::size_t repetitions, report::Duel& duel) {
  const bench::CpuClock clock(bench::CpuClock::Of::kProcess);
  const Rows ours = contest.our_answer(world);
  const double our_guess = clock.seconds();
  const Rows peers = contest.peer_answer(world);
  const double peer_guess = clock.seconds() - our_guess;
  if (contest.comparable && ours != peers) {
    duel.error = "the answers differ";
    return std::max(our_guess, peer_guess);
  }
  for (std::size_t i = 0; i < repetitions; ++i) {
    const Times our_times = times_of(contest.our_answer, world, times_for(our_guess));
    const Times peer_times = times_of(contest.peer_answer, world, times_for(peer_guess));
    duel.our_seconds.push_back(our_times.processor);
    duel.our_wall_seconds.push_back(our_times.wall);
    duel.peer_seconds.push_back(peer_times.processor);
    duel.peer_wall_seconds.push_back(peer_times.wall);
  }
  return std::max(std::ranges::min(duel.our_seconds), std::ranges::min(duel.peer_seconds));
}

}  // namespace

std::vector<report::Duel> visibility_study(const VisibilityStudyOptions& options,
                                           const std::function<void(const std::string&)>& progress) {
  std::vector<report::Duel> duels;
  for (const Contest& contest : contests()) {
    double last = 0.0, last_size = 0.0;
    for (const std::size_t n : options.obstacles) {
      const auto size = static_cast<double>(n);
      const World world = catalog_world(world_name(n));
      report::Duel duel{contest.task,
                        world_name(n),
                        static_cast<double>(world.vertices().size()),
                        contest.ours,
                        contest.peer,
                        {},
                        {},
                        {}};
      duel.threads = contest.threads;
      const double expected = last_size > 0.0 ? last * std::pow(size / last_size, contest.exponent) : 0.0;
      if (expected > options.limit) {
        char text[96];
        std::snprintf(text, sizeof text, "left out: about %.4g s a run expected, the limit is %.3g s", expected,
                      options.limit);
        duel.error = text;
      } else {
        progress(contest.task + ", " + contest.peer + ", " + duel.world);
        last = fight(contest, world,
                     expected > 1.0 ? std::min<std::size_t>(options.repetitions, 3) : options.repetitions, duel);
        last_size = size;
      }
      duels.push_back(std::move(duel));
      if (expected > options.limit) break;
    }
  }
  return duels;
}

}  // namespace arcway::internal::peers
