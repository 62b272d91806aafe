#include <algorithm>
#include <string>
#include <vector>

#include "arcway/datasets/geojson.h"
#include "arcway/datasets/map_file.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "datasets/grid/trace.h"
#include "datasets/io/random.h"

// From a file's text to a checked world, and from cells to polygons.
namespace arcway::internal::bench::map_suite {
namespace {

bool same_polygons(const MapFile& a, const MapFile& b) {
  const auto same = [](const Polygon& x, const Polygon& y) { return x.outer == y.outer && x.holes == y.holes; };
  return std::ranges::equal(a.obstacles, b.obstacles, same);
}

void load(benchmark::State& state, const std::string& world_name) {
  const MapFile map = to_map_file(shared_world(world_name));
  const std::string text = to_geojson(map);
  MapFile read = read_geojson(text, "benchmark");
  if (corrupting()) read.obstacles.pop_back();
  if (!require(state, same_polygons(read, map), "what is read is not what was written")) return;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(to_world(read_geojson(text, "benchmark"), "benchmark"));
  state.counters["vertices"] = static_cast<double>(shared_world(world_name).vertices().size());
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * static_cast<std::int64_t>(state.iterations()));
}

// The checks of a map whose boxes nest or overlap all over.
void check_map(benchmark::State& state, const std::string& world_name) {
  const World& right = shared_world(world_name);
  const MapFile map = to_map_file(right);
  MapFile read = map;
  if (corrupting()) read.obstacles.pop_back();
  const auto is_right = [&] {
    return std::ranges::equal(to_world(read, "benchmark").convex_vertices(), right.convex_vertices());
  };
  if (!require(state, is_right(), "the world's graph vertices are others")) return;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(to_world(map, "benchmark"));
  state.counters["vertices"] = static_cast<double>(right.vertices().size());
}

OccupancyGrid random_grid(std::size_t side) {
  Random random(1);
  OccupancyGrid grid;
  grid.width = grid.height = side;
  grid.cells.assign(side * side, Cell::kFree);
  for (std::size_t i = 0; i < side * side / 60; ++i) {  // blocks of 4 x 4 cells
    const std::size_t x = random.below(side - 4), y = random.below(side - 4);
    for (std::size_t k = 0; k < 16; ++k) grid.at(x + k % 4, y + k / 4) = Cell::kOccupied;
  }
  return grid;
}

/// Twice the area inside of the rings, in cells: holes are clockwise and count against it.
std::int64_t double_area(const std::vector<CornerPolygon>& polygons) {
  std::int64_t area = 0;
  for (const CornerPolygon& polygon : polygons)
    for (const CornerRing& ring : polygon)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Corner &a = ring[i], &b = ring[(i + 1) % ring.size()];
        area += static_cast<std::int64_t>(a.x) * b.y - static_cast<std::int64_t>(b.x) * a.y;
      }
  return area;
}

void trace(benchmark::State& state, std::size_t side) {
  const OccupancyGrid grid = random_grid(side);
  std::vector<CornerPolygon> polygons = trace_blocked(grid, false);
  if (corrupting()) polygons.pop_back();
  const auto blocked = std::ranges::count(grid.cells, Cell::kOccupied);
  if (!require(state, double_area(polygons) == 2 * blocked, "the polygons do not cover as much as the cells")) return;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(polygons = trace_blocked(grid, false));
}

void add(Study study) {
  Series loading(study, "LoadMap/geojson", "obstacles", "O(n log n)", 1.1);
  for (const std::size_t n : sizes(study, {10, 100, 1000, 10000, 100000}, 10, 10000))
    loading.add(static_cast<double>(n),
                [n](benchmark::State& state) { load(state, clutter_name("convex", n, 10, 30)); });
  for (const char* kind : {"saw", "spikes", "rings", "nested", "holes"}) {
    Series checking(study, std::string("CheckMap/adversarial/") + kind, "vertices", "O(n log n)", 1.1);
    for (const std::size_t n : sizes(study, {400, 4000, 12649, 40000, 126491, 400000}, 400, 40000))
      checking.add(static_cast<double>(n), [=](benchmark::State& state) {
        check_map(state, std::string("adversarial/") + kind + "/v" + std::to_string(n) + "/s1");
      });
  }
  Series tracing(study, "TraceGrid", "cells", "O(cells)", 1.0);
  for (const std::size_t side : sizes(study, {64, 128, 256, 512, 1024, 2048}, 64, 1024))
    tracing.add(static_cast<double>(side * side), [side](benchmark::State& state) { trace(state, side); });
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::map_suite
