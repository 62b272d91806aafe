#include "datasets/formats/azimuthal_plane.h"

#include <algorithm>
#include <cmath>

#include "arcway/angle.h"

namespace arcway::internal::detail {
namespace {

// The ellipsoid WGS 84: half axis [m] and square of the eccentricity, f (2 - f) of the flattening 1 / 298.257223563.
constexpr double kHalfAxis = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);
constexpr double kSmallestRadius =
    kHalfAxis * (1.0 - kEccentricity2);  // radius of curvature along the meridian at the equator [m]

double radians(double degrees) { return degrees * (kPi / 180.0); }
// Radius of the curvature across the meridian [m].
double normal_radius(double sin_latitude) {
  return kHalfAxis / std::sqrt(1.0 - kEccentricity2 * sin_latitude * sin_latitude);
}

}  // namespace

AzimuthalPlane::AzimuthalPlane(double longitude, double latitude)
    : longitude_(longitude), sin_(std::sin(radians(latitude))), cos_(std::cos(radians(latitude))) {
  const double n = normal_radius(sin_);
  axial_ = n * cos_;
  polar_ = n * (1.0 - kEccentricity2) * sin_;
  const double along_meridian = n * n * n * (1.0 - kEccentricity2) / (kHalfAxis * kHalfAxis);
  curvature_radius_ = std::sqrt(along_meridian * n);
}

AzimuthalPlane::Local AzimuthalPlane::local(double longitude, double latitude) const {
  // Into the half turns on both sides of the middle: exact for those that are a turn off.
  while (longitude - longitude_ > 180.0) longitude -= 360.0;
  while (longitude - longitude_ < -180.0) longitude += 360.0;
  const double turn = radians(longitude - longitude_), s = std::sin(radians(latitude));
  const double n = normal_radius(s), p = n * std::cos(radians(latitude));
  const double out = p * std::cos(turn) - axial_, z = n * (1.0 - kEccentricity2) * s - polar_;
  return {p * std::sin(turn), cos_ * z - sin_ * out, cos_ * out + sin_ * z};
}

Vec2 AzimuthalPlane::operator()(double longitude, double latitude) const {
  const Local p = local(longitude, latitude);
  const Vec2 flat(p.east, p.north);
  const double tangent = flat.norm();
  if (tangent == 0.0) return flat;
  const double chord = std::hypot(tangent, p.up), diameter = 2.0 * curvature_radius_;
  const double arc = diameter * std::asin(std::min(1.0, chord / diameter));
  return arc / tangent * flat;
}

bool AzimuthalPlane::reaches(double longitude, double latitude) const {
  return local(longitude, latitude).up > -curvature_radius_;
}

double AzimuthalPlane::stretch(double distance) {
  const double share = distance / kSmallestRadius;
  return share * share / 6.0;
}

}  // namespace arcway::internal::detail
