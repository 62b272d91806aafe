#pragma once

#include <memory>

#include "accel/embree/edge_scene.h"
#include "accel/embree/embree_options.h"
#include "accel/location/region_locator.h"
#include "arcway/distance_query.h"
#include "arcway/sweep_query.h"
#include "arcway/visibility_query.h"
#include "core/collision/swept_shape.h"

namespace arcway::internal::embree {

/// Test of a visibility ray.
struct BlocksLineOfSight {
  bool operator()(VertexId edge) const;
  const World& world;
  const LineSegment& segment;
};

/// Test of a ray along a swept rectangle, or along that which bounds a swept shape.
struct MeetsRectangle {
  bool operator()(VertexId edge) const;
  const World& world;
  const SweptRectangle& rectangle;
  const SweptShape* shape = nullptr;
};

/// Data shared by the queries of one world. Immutable once built.
struct Scenes {
  Scenes(const World& world, const EmbreeOptions& options, const char* device_config, std::size_t many_edges);
  /// The scenes of a world after a change. Precondition: can_change.
  Scenes(const Scenes& before, const World& after, const VertexMap& change);
  [[nodiscard]] bool can_change(const World& after, const VertexMap& change) const {
    return visibility.edges().can_change(after, change);
  }

  RegionLocator locator;
  std::shared_ptr<const Executor> batches;
  RayScene<BlocksLineOfSight> visibility;
  RayScene<MeetsRectangle> sweep;

  [[nodiscard]] const World& world() const { return visibility.edges().world(); }
  /// Runs body(begin, end) over a batch, large ones in parallel.
  template <class Body>
  void for_batch(std::size_t count, const Body& body) const;

 private:
  Scenes(const World& world, const EmbreeOptions& options, const std::shared_ptr<const Device>& device,
         std::size_t many_edges);
};

class EmbreeVisibility final : public VisibilityQuery {
 public:
  explicit EmbreeVisibility(std::shared_ptr<const Scenes> scenes) : scenes_(std::move(scenes)) {}

  [[nodiscard]] const Scenes& scenes() const { return *scenes_; }

 private:
  void do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const override;

  std::shared_ptr<const Scenes> scenes_;
};

class EmbreeDistance final : public DistanceQuery {
 public:
  explicit EmbreeDistance(std::shared_ptr<const Scenes> scenes) : scenes_(std::move(scenes)) {}

 private:
  void do_closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const override;
  void do_closer_than(std::span<const Vec2> points, std::span<const double> distances,
                      std::span<std::uint8_t> closer) const override;
  void do_containing(std::span<const Vec2> points, std::span<ObstacleId> result) const override;

  std::shared_ptr<const Scenes> scenes_;
};

class EmbreeSweep final : public SweepQuery {
 public:
  explicit EmbreeSweep(std::shared_ptr<const Scenes> scenes) : scenes_(std::move(scenes)) {}

 private:
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override;
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override;
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override;
  [[nodiscard]] bool do_arc_free(const TurningBody& body, double heading, double angle,
                                 HeadingSet& memory) const override;
  [[nodiscard]] double do_reach(const TurningBody& body, double heading, Side towards, HeadingSet& all) const override;

  [[nodiscard]] bool is_met(const SweptRectangle& rectangle, const SweptShape* shape = nullptr) const;
  // Finds the free headings. Returns false, with `free` unspecified, if more than `most_edges` edges lie near the
  // circle.
  bool find_headings(const TurningBody& body, std::size_t most_edges, HeadingSet& free) const;
  [[nodiscard]] bool is_outside(const TurningBody& body, double heading) const;

  std::shared_ptr<const Scenes> scenes_;
};

template <class Body>
void Scenes::for_batch(std::size_t count, const Body& body) const {
  constexpr std::size_t kGrain = 64;
  if (batches && count >= 2 * kGrain) {
    batches->for_ranges(count, kGrain, body);
  } else {
    body(std::size_t{0}, count);
  }
}

}  // namespace arcway::internal::embree
