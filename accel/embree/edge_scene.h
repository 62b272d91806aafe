#pragma once

#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "accel/embree/device.h"
#include "arcway/world.h"
#include "core/geometry/box_tree.h"
#include "core/model/vertex_map.h"

namespace arcway::internal::embree {

/// The edges of a world as boxes in Embree. It proposes edges in single precision, for the caller to decide on exactly.
///
/// It may propose an edge that is not wanted, and never fails to propose one that is. In large worlds a box holds a few
/// edges that follow each other, and proposes them together.
///
/// Coordinates are centered and scaled by a power of two so that all boxes lie within [-1, 1]. Each box is larger than
/// its edges by kPad = 2^-18. Traversal errs by less than 2^-19.6 on rays within that square, by the rounding of
/// origin, direction and reciprocal direction (accel/README.md derives it). Rays are cut to the square first.
class EdgeScene {
 public:
  static constexpr double kPad = 0x1p-18;
  /// In half sizes of the map. Beyond it, cutting a ray or measuring from a point is less precise than kPad allows, and
  /// all edges are proposed.
  static constexpr double kFar = 0x1p20;
  /// Number of edges from which boxes hold several. A tree of single edges then takes longer to build and to fetch from
  /// memory than testing some edges in vain.
  static constexpr std::size_t kManyEdges = 100'000;

  struct Options {
    double inflation = 0.0;               ///< how much larger than edges boxes are, for rays that stand for bodies [m]
    std::size_t many_edges = kManyEdges;  ///< boxes hold several edges if the world has more than this
    StopClock clock = {};                 ///< stops the build, which then throws Canceled
  };
  /// @param on_edge  callback that gets the edges near a ray; null if the scene is asked for points only.
  EdgeScene(std::shared_ptr<const Device> device, const World& world, RTCOccludedFunctionN on_edge,
            const Options& options);
  /// The scene of a world after a change, in time that depends on the change only. Embree's boxes are those of the
  /// scene that was built; it passes over removed edges, and looks at obstacles near it that were added. Precondition:
  /// can_change.
  EdgeScene(const EdgeScene& before, const World& after, const VertexMap& change);
  /// Whether few edges would have been added since the scene was built, within the box of its world.
  [[nodiscard]] bool can_change(const World& after, const VertexMap& change) const;
  EdgeScene(const EdgeScene&) = delete;
  EdgeScene& operator=(const EdgeScene&) = delete;

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] double inflation() const { return built_->inflation; }
  [[nodiscard]] RTCScene get() const { return built_->scene.get(); }

  /// A position of the world in Embree's coordinates. Results computed from these are rounded relative to the size of
  /// the map, not to its distance from the origin.
  [[nodiscard]] Vec2 scaled(const Vec2& p) const { return built_->scaled(p); }
  [[nodiscard]] static bool is_near(const Vec2& scaled) { return (scaled.array().abs() <= kFar).all(); }

  /// Prepares the ray between two scaled positions, both near and perhaps equal. False if it stays clear of all boxes.
  static bool aim(const Vec2& a, const Vec2& b, RTCRay& ray);

  /// Calls visit(edge) for the edges of a box, by its number in Embree, until a call returns false.
  template <class Visit>
  void visit_box(unsigned box, Visit&& visit) const {
    const World::VertexRange edges = built_->edges_of(box);
    for (VertexId e = edges.first; e < edges.last; ++e)
      if (const VertexId now = map_ ? map_->after(e) : e; now != kNone && !visit(now)) return;
  }
  /// Calls visit(edge) for the added edges of each obstacle that may come within the inflation of a segment between two
  /// scaled positions, until a call returns false.
  template <class Visit>
  void visit_added(const Vec2& from, const Vec2& to, Visit&& visit) const {
    const Box box = box_of(LineSegment{from, to});
    added_scaled_.visit_overlaps(box, [&](std::uint32_t i) { return visit_range(added_[i], visit); });
  }

  /// Proposes to `visit` every edge that comes within `radius` of p, in any order. visit(edge) returns the radius still
  /// of interest, not larger than before; a negative one ends the visit.
  template <class Visit>
  void visit_near(const Vec2& p, double radius, Visit&& visit) const {
    const Vec2 center = scaled(p);
    if (!is_near(center)) {
      for (VertexId e = 0; e < world_.edges().size() && radius >= 0.0; ++e) radius = visit(e);
      return;
    }
    added_boxes_.visit_if([&](const Box& box) { return box.distance_to(p) * (1.0 - 0x1p-40) <= radius; },
                          [&](std::uint32_t i) {
                            return visit_range(added_[i], [&](VertexId e) { return (radius = visit(e)) >= 0.0; });
                          });
    if (radius < 0.0) return;
    PointVisit<Visit> point{*this, visit, kPad + 0x1p-20 * center.cwiseAbs().maxCoeff(), radius, {}};
    RTCPointQuery query;
    query.x = static_cast<float>(center.x());
    query.y = static_cast<float>(center.y());
    query.z = 0.0f;
    query.time = 0.0f;
    query.radius = point.float_radius();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(get(), &query, &context, &PointVisit<Visit>::on_box, &point);
    if (point.thrown) std::rethrow_exception(point.thrown);
  }

 private:
  template <class Visit>
  struct PointVisit {
    const EdgeScene& scene;
    Visit& visit;
    double slack;  // error of the rounded center and of the box distance
    double radius;
    std::exception_ptr thrown;  // by a visit: Embree would take it for an error of its own

    [[nodiscard]] float float_radius() const {
      const auto rounded = static_cast<float>(radius * scene.built_->scale * (1.0 + 0x1p-19) + slack);
      return std::nextafter(rounded, std::numeric_limits<float>::infinity());
    }
    static bool on_box(RTCPointQueryFunctionArguments* a) {
      auto& self = *static_cast<PointVisit*>(a->userPtr);
      if (self.radius < 0.0) return false;
      double radius = self.radius;
      try {
        self.scene.visit_box(a->primID, [&](VertexId e) { return (radius = self.visit(e)) >= 0.0; });
      } catch (...) {
        self.thrown = std::current_exception();
        radius = -1.0;
      }
      if (radius == self.radius) return false;
      self.radius = radius;
      a->query->radius = radius < 0.0 ? 0.0f : self.float_radius();
      return true;
    }
  };

  // What Embree knows. Scenes of changed worlds share it.
  struct Built {
    Built(std::shared_ptr<const Device> the_device, const World& the_world, double the_inflation)
        : device(std::move(the_device)), world(the_world), inflation(the_inflation) {}
    [[nodiscard]] Vec2 scaled(const Vec2& p) const { return (p - center) * scale; }
    [[nodiscard]] World::VertexRange edges_of(unsigned box) const {
      return chains.empty() ? World::VertexRange{box, box + 1} : World::VertexRange{chains[box], chains[box + 1]};
    }
    // Fills `chains`, so that boxes hold several edges each.
    void join_edges();
    static void on_bounds(const RTCBoundsFunctionArguments* arguments);

    std::shared_ptr<const Device> device;
    World world;
    double inflation;
    Vec2 center{0.0, 0.0};
    double scale = 1.0;
    double margin = 0.0;           // of the boxes around their edges, scaled
    std::vector<VertexId> chains;  // first edge of each box, one more than boxes; empty: one edge each
    SceneHandle scene;
  };
  // Whether all calls returned true.
  template <class Visit>
  static bool visit_range(const World::VertexRange& edges, Visit&& visit) {
    for (VertexId e = edges.first; e < edges.last; ++e)
      if (!visit(e)) return false;
    return true;
  }
  [[nodiscard]] VertexMap map_from_built(const VertexMap& change) const { return map_ ? map_->then(change) : change; }

  std::shared_ptr<const Built> built_;
  World world_;
  std::optional<VertexMap> map_;           // from the world that was built, if it was changed since
  std::vector<World::VertexRange> added_;  // edges of each obstacle that was added since
  BoxTree added_boxes_, added_scaled_;     // of these; scaled: with the margin of boxes
};

/// An edge scene with a test that decides: `bool test(VertexId) const`.
template <class Test>
class RayScene {
 public:
  RayScene(std::shared_ptr<const Device> device, const World& world, const EdgeScene::Options& options)
      : edges_(std::move(device), world, &on_edge, options) {}
  /// See EdgeScene.
  RayScene(const RayScene& before, const World& after, const VertexMap& change)
      : edges_(before.edges_, after, change) {}

  [[nodiscard]] const EdgeScene& edges() const { return edges_; }

  /// Whether the test holds for some edge within the scene's inflation of the segment between two scaled positions.
  /// Perhaps also for an edge further away.
  [[nodiscard]] bool any(const Vec2& from, const Vec2& to, const Test& test) const {
    if (!EdgeScene::is_near(from) || !EdgeScene::is_near(to)) {
      for (VertexId e = 0; e < edges_.world().edges().size(); ++e)
        if (test(e)) return true;
      return false;
    }
    bool hit = false;
    edges_.visit_added(from, to, [&](VertexId e) { return !(hit = test(e)); });
    RTCRay ray;
    if (hit || !EdgeScene::aim(from, to, ray)) return hit;
    Query query{{}, edges_, test};
    init(query);
    occluded(edges_.get(), query, ray);
    return ray.tfar < 0.0f;
  }

 private:
  struct Query : RayContext {
    const EdgeScene& edges;
    const Test& test;
  };
  static void on_edge(const RTCOccludedFunctionNArguments* a) {
    if (!a->valid[0]) return;
    const Query& query = *static_cast<const Query*>(a->context);
    bool hit = false;
    query.edges.visit_box(a->primID, [&](VertexId e) { return !(hit = query.test(e)); });
    if (hit) RTCRayN_tfar(a->ray, a->N, 0) = -std::numeric_limits<float>::infinity();
    a->valid[0] = hit ? -1 : 0;  // Embree 4 reads it
  }

  EdgeScene edges_;
};

}  // namespace arcway::internal::embree
