#include "accel/embree/edge_scene.h"

#include <algorithm>

namespace arcway::embree {

namespace {

constexpr double kLimit = 1.0 + 0x1p-10;  // rays are cut to this; more than the padded boxes reach

float round_down(double x) {
  const auto f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float round_up(double x) { return -round_down(-x); }

// Cuts the part of p + [t0, t1] d that lies within the limits of one axis.
bool cut(double p, double d, double& t0, double& t1) {
  if (d == 0.0) return std::abs(p) <= kLimit;
  const double low = (-kLimit - p) / d;
  const double high = (kLimit - p) / d;
  t0 = std::max(t0, std::min(low, high));
  t1 = std::min(t1, std::max(low, high));
  return t0 <= t1;
}

}  // namespace

EdgeScene::EdgeScene(std::shared_ptr<const Device> device, const World& world, double inflation,
                     RTCOccludedFunctionN on_edge)
    : device_(std::move(device)), world_(world), inflation_(inflation) {
  if (!world_.box().empty()) {
    center_ = world_.box().min + 0.5 * (world_.box().max - world_.box().min);
    // Rounded, it may be off the middle by as much as a small map far from the origin is large.
    const double reach = std::max((world_.box().max - center_).maxCoeff(), (center_ - world_.box().min).maxCoeff());
    scale_ = std::exp2(-std::ceil(std::log2(reach + inflation)));
  }
  margin_ = inflation * scale_ + kPad;

  const GeometryHandle geometry(rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_USER));
  device_->check();
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(world_.edges().size()));
  rtcSetGeometryUserData(geometry.get(), this);
  rtcSetGeometryBoundsFunction(geometry.get(), &EdgeScene::on_bounds, nullptr);
  if (on_edge != nullptr) rtcSetGeometryOccludedFunction(geometry.get(), on_edge);
  rtcCommitGeometry(geometry.get());
  scene_.reset(rtcNewScene(device_->get()));
  rtcAttachGeometry(scene_.get(), geometry.get());
  device_->check();
  device_->commit(scene_.get());
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

// Denormals are flushed here: no predicate may be called.
void EdgeScene::on_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& self = *static_cast<const EdgeScene*>(arguments->geometryUserPtr);
  const LineSegment& edge = self.world_.edges()[arguments->primID];
  const Vec2 a = self.scaled(edge.a);
  const Vec2 b = self.scaled(edge.b);
  RTCBounds& box = *arguments->bounds_o;
  box.lower_x = round_down(std::min(a.x(), b.x()) - self.margin_);
  box.lower_y = round_down(std::min(a.y(), b.y()) - self.margin_);
  box.lower_z = -1.0f;
  box.upper_x = round_up(std::max(a.x(), b.x()) + self.margin_);
  box.upper_y = round_up(std::max(a.y(), b.y()) + self.margin_);
  box.upper_z = 1.0f;
}

}  // namespace arcway::embree
