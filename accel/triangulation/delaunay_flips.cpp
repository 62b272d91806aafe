#include "accel/triangulation/delaunay_flips.h"

#include <cmath>
#include <vector>

namespace arcway {

namespace {

// Whether d surely lies inside the circle through the counter-clockwise triangle a, b, c.
bool surely_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double ax = a.x() - d.x(), ay = a.y() - d.y();
  const double bx = b.x() - d.x(), by = b.y() - d.y();
  const double cx = c.x() - d.x(), cy = c.y() - d.y();
  const double bxcy = bx * cy, cxby = cx * by;
  const double cxay = cx * ay, axcy = ax * cy;
  const double axby = ax * by, bxay = bx * ay;
  const double a_lift = ax * ax + ay * ay;
  const double b_lift = bx * bx + by * by;
  const double c_lift = cx * cx + cy * cy;
  const double determinant = a_lift * (bxcy - cxby) + b_lift * (cxay - axcy) + c_lift * (axby - bxay);
  const double magnitude = (std::abs(bxcy) + std::abs(cxby)) * a_lift + (std::abs(cxay) + std::abs(axcy)) * b_lift +
                           (std::abs(axby) + std::abs(bxay)) * c_lift;
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kErrorBound = (10.0 + 96.0 * kEpsilon) * kEpsilon;  // [Shewchuk 1997, section 4.4]
  constexpr double kUnderflow = 1e-300;  // differences of coordinates are 0 or above 1e-116: only the last products
  return determinant > kErrorBound * magnitude + kUnderflow;
}

}  // namespace

void flip_towards_delaunay(std::span<const Vec2> sites, Triangulation& triangulation) {
  std::vector<std::uint32_t>& corners = triangulation.corners;
  std::vector<std::uint32_t>& twins = triangulation.twins;
  const auto next = Triangulation::next;
  const auto previous = Triangulation::previous;
  const auto join = [&](std::uint32_t h, std::uint32_t twin) {
    twins[h] = twin;
    if (twin != kNone) twins[twin] = h;
  };
  std::vector<std::uint32_t> suspects;
  for (std::uint32_t first = 0; first < corners.size(); ++first) {
    if (twins[first] == kNone || twins[first] < first) continue;
    suspects.push_back(first);
    while (!suspects.empty()) {
      const std::uint32_t h = suspects.back();
      suspects.pop_back();
      const std::uint32_t g = twins[h];
      if (g == kNone) continue;
      // Triangles (a, b, c) and (b, a, d) on both sides of the edge a-b.
      const std::uint32_t bc = next(h), ca = previous(h), ad = next(g), db = previous(g);
      const std::uint32_t a = corners[h], b = corners[g], c = corners[ca], d = corners[db];
      if (!surely_in_circle(sites[a], sites[b], sites[c], sites[d])) continue;
      // They become (d, b, c), in the place of the first, and (c, a, d).
      const std::uint32_t beyond_bc = twins[bc], beyond_ca = twins[ca], beyond_ad = twins[ad], beyond_db = twins[db];
      corners[h] = d;
      corners[bc] = b;
      corners[ca] = c;
      corners[g] = c;
      corners[ad] = a;
      corners[db] = d;
      join(h, beyond_db);
      join(bc, beyond_bc);
      join(ca, db);
      join(g, beyond_ca);
      join(ad, beyond_ad);
      suspects.insert(suspects.end(), {h, bc, g, ad});
    }
  }
}

}  // namespace arcway
