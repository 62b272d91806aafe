#pragma once

#include "arcway/vec2.h"

namespace arcway::internal::detail {

/// The tangent plane of the WGS 84 ellipsoid at a position: azimuthal equidistant projection, x to the east, y to the
/// north [m].
///
/// A position is mapped in its direction from the middle, at its distance along the ellipsoid. That distance is the
/// chord, bent to the arc of the mean curvature at the middle. Closed form without series, as exact at the poles and
/// across the antimeridian as elsewhere. Distances from the middle are right to 1e-8 of them within 20 km; across, the
/// plane is stretched by at most `stretch`.
class AzimuthalPlane {
 public:
  /// @param longitude, latitude  of the middle, geodetic [degrees].
  AzimuthalPlane(double longitude, double latitude);
  /// Longitudes a whole turn apart are the same place, to the last bit where the difference is exact.
  [[nodiscard]] Vec2 operator()(double longitude, double latitude) const;
  /// Whether the position is less than a quarter of the globe away from the middle, beyond which no map makes sense.
  [[nodiscard]] bool reaches(double longitude, double latitude) const;

  /// Lengths up to this far from the middle are too long by at most this share of them: r^2 / 6 R^2.
  [[nodiscard]] static double stretch(double distance);

 private:
  struct Local {
    double east, north, up;
  };
  [[nodiscard]] Local local(double longitude, double latitude) const;

  double longitude_;         // [degrees]
  double sin_, cos_;         // sine and cosine of the latitude
  double axial_, polar_;     // distance of the middle from the axis and from the plane of the equator [m]
  double curvature_radius_;  // mean, at the middle [m]
};

}  // namespace arcway::internal::detail
