#include "accel/embree/edge_scene.h"

#include <algorithm>

namespace arcway::internal::embree {

namespace {

constexpr VertexId kMostTogether = 5;
constexpr double kLongestBox = 4.0;  // longest side of a box of several edges, in mean edge lengths of the world

// Share of a scene's edges that may have been removed, and as many added, since it was built; some in any case, and
// never more than that. Each change makes a tree of all added obstacles.
constexpr std::size_t kMostChangedOf = 16;
constexpr std::size_t kMostChangedOfAny = 512, kMostChanged = 8192;

constexpr double kLimit = 1.0 + 0x1p-10;  // rays are cut to this; more than the padded boxes reach

float round_down(double x) {
  const auto f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float round_up(double x) { return -round_down(-x); }

// Cuts [t0, t1] to the part where p + t d lies within one axis's range.
bool cut(double p, double d, double& t0, double& t1) {
  if (d == 0.0) return std::abs(p) <= kLimit;
  const double low = (-kLimit - p) / d;
  const double high = (kLimit - p) / d;
  t0 = std::max(t0, std::min(low, high));
  t1 = std::min(t1, std::max(low, high));
  return t0 <= t1;
}

}  // namespace

EdgeScene::EdgeScene(std::shared_ptr<const Device> device, const World& world, RTCOccludedFunctionN on_edge,
                     const Options& options)
    : world_(world) {
  const auto built = std::make_shared<Built>(std::move(device), world, options.inflation);
  if (!world.box().empty()) {
    built->center = world.box().min + 0.5 * (world.box().max - world.box().min);
    // The rounded center may be off the middle by as much as a small map far from the origin is large.
    const double reach =
        std::max((world.box().max - built->center).maxCoeff(), (built->center - world.box().min).maxCoeff());
    built->scale = std::exp2(-std::ceil(std::log2(reach + built->inflation)));
  }
  built->margin = built->inflation * built->scale + kPad;

  if (world.edges().size() > options.many_edges) built->join_edges();
  const std::size_t boxes = built->chains.empty() ? world.edges().size() : built->chains.size() - 1;

  const RTCDevice embree = built->device->get();
  const GeometryHandle geometry(rtcNewGeometry(embree, RTC_GEOMETRY_TYPE_USER));
  built->device->check();
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes));
  rtcSetGeometryUserData(geometry.get(), built.get());
  rtcSetGeometryBoundsFunction(geometry.get(), &Built::on_bounds, nullptr);
  if (on_edge != nullptr) rtcSetGeometryOccludedFunction(geometry.get(), on_edge);
  rtcCommitGeometry(geometry.get());
  built->scene.reset(rtcNewScene(embree));
  rtcAttachGeometry(built->scene.get(), geometry.get());
  built->device->check();
  built->device->commit(built->scene.get(), options.clock);
  built_ = built;
}

EdgeScene::EdgeScene(const EdgeScene& before, const World& after, const VertexMap& change)
    : built_(before.built_), world_(after), map_(before.map_from_built(change)) {
  std::vector<Box> boxes, all_scaled;
  for (const World::VertexRange& edges : map_->added()) {
    const Box& box = after.box_of(after.obstacle_of(edges.first));
    added_.push_back(edges);
    boxes.push_back(box);
    all_scaled.push_back(Box{scaled(box.min), scaled(box.max)}.grown(built_->margin));
  }
  if (added_.empty()) return;
  added_boxes_ = BoxTree(boxes);
  added_scaled_ = BoxTree(all_scaled);
}

bool EdgeScene::can_change(const World& after, const VertexMap& change) const {
  const VertexMap map = map_from_built(change);
  const Box &old = built_->world.box(), &box = after.box();
  const bool is_within = box.empty() || (!old.empty() && old.contains(box.min) && old.contains(box.max));
  const auto most =
      static_cast<VertexId>(std::clamp(built_->world.edges().size() / kMostChangedOf, kMostChangedOfAny, kMostChanged));
  return is_within && map.added_count() <= most && map.removed_count() <= most;
}

void EdgeScene::Built::join_edges() {
  const std::span<const LineSegment> edges = world.edges();
  double sum = 0.0;
  for (const LineSegment& edge : edges) sum += (edge.b - edge.a).norm();
  const double longest = kLongestBox * sum / static_cast<double>(edges.size());
  Box box;
  for (VertexId e = 0; e < edges.size(); ++e) {
    const bool follows = e > 0 && edges[e].a == edges[e - 1].b;
    box.extend(edges[e].b);
    if (follows && e - chains.back() < kMostTogether && (box.max - box.min).maxCoeff() <= longest) continue;
    chains.push_back(e);
    box = box_of(edges[e]);
  }
  chains.push_back(static_cast<VertexId>(edges.size()));
}

bool EdgeScene::aim(const Vec2& a, const Vec2& b, RTCRay& ray) {
  Vec2 from = a;
  Vec2 to = b;
  const bool within = (from.array().abs() <= 1.0).all() && (to.array().abs() <= 1.0).all();
  if (!within) {
    const Vec2 d = to - from;
    double t0 = 0.0;
    double t1 = 1.0;
    if (!cut(from.x(), d.x(), t0, t1) || !cut(from.y(), d.y(), t0, t1)) return false;
    to = from + t1 * d;
    from += t0 * d;
  }
  ray.org_x = static_cast<float>(from.x());
  ray.org_y = static_cast<float>(from.y());
  ray.org_z = 0.0f;
  ray.dir_x = static_cast<float>(to.x() - from.x());
  ray.dir_y = static_cast<float>(to.y() - from.y());
  ray.dir_z = 0.0f;
  ray.tnear = 0.0f;
  ray.tfar = 1.0f;
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
  return true;
}

// Embree flushes denormals here, so no predicate may be called.
void EdgeScene::Built::on_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& self = *static_cast<const Built*>(arguments->geometryUserPtr);
  const World::VertexRange edges = self.edges_of(arguments->primID);
  Box box;
  for (VertexId e = edges.first; e < edges.last; ++e) {
    box.extend(self.scaled(self.world.edges()[e].a));
    box.extend(self.scaled(self.world.edges()[e].b));
  }
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = round_down(box.min.x() - self.margin);
  bounds.lower_y = round_down(box.min.y() - self.margin);
  bounds.lower_z = -1.0f;
  bounds.upper_x = round_up(box.max.x() + self.margin);
  bounds.upper_y = round_up(box.max.y() + self.margin);
  bounds.upper_z = 1.0f;
}

}  // namespace arcway::internal::embree
