#include "datasets/formats/azimuthal_plane.h"

#include <gtest/gtest.h>

namespace arcway::internal::detail {
namespace {

// Lengths of geodesics on WGS 84 by Vincenty's inverse formulae [m], for a box of 0.01 degrees. They are its lower
// side, its left side, and its diagonal from the lower left corner.
struct Geodesics {
  double latitude, east, north, diagonal;
};
constexpr Geodesics kGeodesics[] = {
    {0, 1113.194908, 1105.742758, 1569.034715}, {30, 964.862802, 1108.525268, 1469.590130},
    {45, 788.468350, 1111.318751, 1362.572406}, {60, 558.000015, 1114.123724, 1246.010321},
    {80, 193.934855, 1116.599741, 1133.299823}, {89, 19.493267, 1116.936391, 1117.104780},
    {89.95, 0.974714, 1116.939789, 1116.940129}};

TEST(AzimuthalPlane, KeepsLengthsToLessThanAMillimeterAKilometer) {
  for (const Geodesics& g : kGeodesics) {
    SCOPED_TRACE(g.latitude);
    const AzimuthalPlane plane(10.005, g.latitude + 0.005);
    const Vec2 a = plane(10, g.latitude), b = plane(10.01, g.latitude), c = plane(10, g.latitude + 0.01);
    EXPECT_NEAR((b - a).norm(), g.east, 1e-6 * g.east + 1e-6);
    EXPECT_NEAR((c - a).norm(), g.north, 1e-6 * g.north);
    EXPECT_NEAR((plane(10.01, g.latitude + 0.01) - a).norm(), g.diagonal, 1e-6 * g.diagonal);
    // The southern half of the globe is its mirror image.
    const AzimuthalPlane south(10.005, -g.latitude - 0.005);
    EXPECT_NEAR((south(10.01, -g.latitude) - south(10, -g.latitude)).norm(), g.east, 1e-6 * g.east + 1e-6);
    EXPECT_GT(south(10, -g.latitude).y(), 0.0);
  }
}

TEST(AzimuthalPlane, StretchesLengthsFarFromTheMiddleAsStated) {
  // 0.1 degrees of the parallel 0.135 degrees (14.9 km) off the middle.
  const AzimuthalPlane plane(0.0, 0.0);
  const double length = (plane(-0.005, 0.135) - plane(0.005, 0.135)).norm();
  const double geodesic = 1113.191875;  // Vincenty
  EXPECT_LT(length / geodesic - 1.0, AzimuthalPlane::stretch(14929.0));
  EXPECT_GT(length / geodesic - 1.0, 0.9 * AzimuthalPlane::stretch(14929.0));
  EXPECT_NEAR(AzimuthalPlane::stretch(15500.0), 1e-6, 0.01e-6);
}

TEST(AzimuthalPlane, HasNoSeamAtTheAntimeridianAndThePoles) {
  const AzimuthalPlane fiji(179.9, -17.0);
  EXPECT_EQ(fiji(180.0, -17.0), fiji(-180.0, -17.0));
  EXPECT_NEAR((fiji(179.999, -17.0) - fiji(-179.999, -17.0)).norm(), 0.2 * 1064.8583, 1e-3);  // of 0.01 degrees
  const AzimuthalPlane pole(0.0, 90.0);
  EXPECT_NEAR((pole(0.0, 89.99) - pole(180.0, 89.99)).norm(), 2.0 * 1116.939795, 1e-3);
  EXPECT_NEAR((pole(90.0, 89.99) - pole(-90.0, 89.99)).norm(), 2.0 * 1116.939795, 1e-3);
  EXPECT_EQ(pole(0.0, 90.0).norm() < 1e-8, true);
  EXPECT_TRUE(pole.reaches(12.0, 1.0));
  EXPECT_FALSE(pole.reaches(12.0, -1.0));
}

}  // namespace
}  // namespace arcway::internal::detail
