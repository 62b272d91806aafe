#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "accel/backend/make_queries.h"
#include "accel/embree/edge_scene.h"
#include "accel/embree/embree_queries.h"
#include "accel/graphs/pairwise_graph.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/collision/blocking.h"
#include "datasets/io/random.h"

// Do packets of rays or sorting pay? Times exact lines of sight one by one and in packets of eight. The pairs are those
// of the pairwise builder, in its order, in random order, and sorted by position and direction.
namespace arcway::internal::bench::accel_packets_suite {
namespace {

constexpr std::size_t kRays = 1 << 14;
constexpr std::size_t kLanes = 8;

struct PacketContext : embree::RayContext {
  const World* world;
  const LineSegment* segments;  // segment of ray 0
};

void on_edge(const RTCOccludedFunctionNArguments* a) {
  const auto& context = *static_cast<const PacketContext*>(a->context);
  for (unsigned i = 0; i < a->N; ++i) {
    if (!a->valid[i]) continue;
    const bool hit =
        blocks(*context.world, static_cast<VertexId>(a->primID), context.segments[RTCRayN_id(a->ray, a->N, i)]);
    if (hit) RTCRayN_tfar(a->ray, a->N, i) = -std::numeric_limits<float>::infinity();
    a->valid[i] = hit ? -1 : 0;
  }
}

void occluded8(const int* valid, RTCScene scene, PacketContext& context, RTCRay8& rays) {
#if EMBREE_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded8(valid, scene, &rays, &arguments);
#else
  rtcOccluded8(valid, scene, &context, &rays);
#endif
}

class PacketScene {
 public:
  // An edge a box, as worlds of this size have anyway.
  explicit PacketScene(const World& world)
      : edges_(std::make_shared<const embree::Device>(), world, &on_edge,
               {.many_edges = std::numeric_limits<std::size_t>::max()}) {}

  // blocked[i] = 1 if an edge blocks segments[i]; ends differ and lie in the map.
  void blocked(std::span<const LineSegment> segments, std::span<std::uint8_t> result) const {
    for (std::size_t first = 0; first < segments.size(); first += kLanes) {
      const std::size_t count = std::min(kLanes, segments.size() - first);
      alignas(32) std::array<int, kLanes> valid{};
      RTCRay8 rays;
      for (std::size_t i = 0; i < count; ++i) {
        RTCRay ray;
        const LineSegment& segment = segments[first + i];
        valid[i] = edges_.aim(edges_.scaled(segment.a), edges_.scaled(segment.b), ray) ? -1 : 0;
        rays.org_x[i] = ray.org_x, rays.org_y[i] = ray.org_y, rays.org_z[i] = ray.org_z;
        rays.dir_x[i] = ray.dir_x, rays.dir_y[i] = ray.dir_y, rays.dir_z[i] = ray.dir_z;
        rays.tnear[i] = ray.tnear, rays.tfar[i] = ray.tfar, rays.time[i] = ray.time;
        rays.mask[i] = ray.mask, rays.id[i] = static_cast<unsigned>(i), rays.flags[i] = ray.flags;
      }
      PacketContext context{{}, &edges_.world(), &segments[first]};
      embree::init(context);
      occluded8(valid.data(), edges_.get(), context, rays);
      for (std::size_t i = 0; i < count; ++i) result[first + i] = valid[i] != 0 && rays.tfar[i] < 0.0f ? 1 : 0;
    }
  }

 private:
  embree::EdgeScene edges_;
};

class SingleScene {
 public:
  explicit SingleScene(const World& world)
      : scene_(std::make_shared<const embree::Device>(), world, embree::EdgeScene::Options{}) {}
  void blocked(std::span<const LineSegment> segments, std::span<std::uint8_t> result) const {
    const embree::EdgeScene& edges = scene_.edges();
    for (std::size_t i = 0; i < segments.size(); ++i)
      result[i] =
          scene_.any(edges.scaled(segments[i].a), edges.scaled(segments[i].b), {edges.world(), segments[i]}) ? 1 : 0;
  }

 private:
  embree::RayScene<embree::BlocksLineOfSight> scene_;
};

// Writes down what it is asked.
class Recorder final : public VisibilityQuery {
 public:
  mutable std::vector<LineSegment> segments;

 private:
  void do_visible(std::span<const LineSegment> asked, std::span<std::uint8_t> visible) const override {
    segments.insert(segments.end(), asked.begin(), asked.end());
    std::ranges::fill(visible, std::uint8_t{0});
  }
};

std::vector<LineSegment> builder_segments(const World& world) {
  const Recorder recorder;
  build_pairwise_visibility_graph(world, recorder, SerialExecutor());
  // A stretch from the middle, where vertices have neighbors on all sides and later ones still to ask for.
  const std::size_t count = std::min(kRays, recorder.segments.size());
  const auto first = recorder.segments.begin() + static_cast<std::ptrdiff_t>((recorder.segments.size() - count) / 2);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

enum class Order { kAsAsked, kRandom, kSorted };

// Cell of the first end along a Morton curve, then direction.
void sort_by_place(const World& world, std::vector<LineSegment>& segments) {
  constexpr double kCells = 256.0;
  const Box& box = world.box();
  const double scale = (kCells - 1.0) / (box.max - box.min).maxCoeff();
  const auto key = [&](const LineSegment& s) {
    const Vec2 cell = (s.a - box.min) * scale;
    std::uint32_t code = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
      code |= (static_cast<std::uint32_t>(cell.x()) >> bit & 1u) << (2 * bit);
      code |= (static_cast<std::uint32_t>(cell.y()) >> bit & 1u) << (2 * bit + 1);
    }
    const Vec2 d = s.b - s.a;
    return std::pair(code, std::atan2(d.y(), d.x()));
  };
  std::ranges::sort(segments, {}, key);
}

void put_in(Order order, const World& world, std::vector<LineSegment>& segments) {
  Random random(1);
  if (order == Order::kAsAsked) return;
  for (std::size_t i = segments.size(); i > 1; --i)
    std::swap(segments[i - 1], segments[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(i)))]);
  if (order == Order::kSorted) sort_by_place(world, segments);
}

template <class Scene>
void time_scene(benchmark::State& state, const std::string& world_name, Order order) {
  const World& world = shared_world(world_name);
  std::vector<LineSegment> segments = builder_segments(world);
  put_in(order, world, segments);
  std::vector<std::uint8_t> blocked(segments.size()), visible(segments.size());
  const Scene scene(world);
  scene.blocked(segments, blocked);
  if (corrupting()) blocked.front() ^= 1u;
  make_embree_queries(world).visibility->visible(segments, visible);
  bool right = true;  // no segment begins inside an obstacle
  for (std::size_t i = 0; i < segments.size(); ++i) right = right && (blocked[i] != 0) != (visible[i] != 0);
  if (!require(state, right, "differs from the library's answers")) return;
  for ([[maybe_unused]] auto _ : state) {
    scene.blocked(segments, blocked);
    benchmark::DoNotOptimize(blocked.data());
  }
  state.counters["rays"] =
      benchmark::Counter(static_cast<double>(segments.size()), benchmark::Counter::kIsIterationInvariantRate);
}

void add(Study study) {
  const std::pair<const char*, Order> orders[] = {
      {"as_asked", Order::kAsAsked}, {"random", Order::kRandom}, {"sorted", Order::kSorted}};
  for (const std::size_t n : sizes(study, {100, 1000}, 100, 1000)) {
    const std::string world = clutter_name("convex", n, 10, 30);
    for (const auto& [label, order] : orders) {
      const std::string end = std::string("/") + label + "/n" + std::to_string(n);
      add_benchmark("RayPackets/one" + end,
                    [=, o = order](benchmark::State& state) { time_scene<SingleScene>(state, world, o); });
      add_benchmark("RayPackets/eight" + end,
                    [=, o = order](benchmark::State& state) { time_scene<PacketScene>(state, world, o); });
    }
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_packets_suite
