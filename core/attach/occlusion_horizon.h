#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "arcway/angle.h"
#include "core/attach/sectors.h"
#include "core/geometry/quick_direction.h"
#include "core/model/outlines.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

// Allowance for rounding: of headings [rad], and of distances as a share.
inline constexpr double kHorizonSlack = 1e-6;

/// The nearest obstacle by direction around a circle: an upper bound, by heading, on the length of free straights that
/// leave a directed circle. It is computed from outlines near the circle, so that obstacles behind them need not be
/// examined.
///
/// If all straights within a range of headings cross a piece of outline, that piece ends all of them. The bound holds
/// despite rounding: ranges are narrowed and distances raised by far more. Precondition: the body covers its reference
/// point.
class OcclusionHorizon {
 public:
  /// A horizon of the straights that leave the circle within a turn from a heading [rad].
  OcclusionHorizon(const TurnCircle& circle, double heading, double turn);
  /// Takes outlines into account, near ones first.
  void shorten(const Outlines& outlines);
  /// Takes one piece of outline into account.
  /// @param box  of the outline.
  void shorten(std::span<const Vec2> outline, const Box& box);

  /// Upper bound on the length of free straights of this heading [m]; negative if there is none.
  [[nodiscard]] double reach(double heading) const;
  /// Whether all points of a box are hidden behind the horizon.
  [[nodiscard]] bool hides(const Box& box) const;
  /// The sectors of headings in which straights lead to points of a box, and maybe others.
  [[nodiscard]] Sectors sectors_towards(const Box& box) const;
  /// The tangent line onto another directed circle, approximately.
  struct TangentLine {
    double heading;  ///< [rad], in [0, 2 pi], within kTangentError
    double length;   ///< [m]; 0: there may be none
  };
  static constexpr double kTangentError = 1e-4;
  [[nodiscard]] TangentLine tangent_to(const TurnCircle& to) const;
  /// The tangent line onto another directed circle; nothing if there is none, or if it is certainly blocked. Quick, and
  /// the more so after `finish`: most circles are told by the octant of their heading.
  [[nodiscard]] std::optional<TangentLine> free_tangent_to(const TurnCircle& to) const {
    const auto line = line_to(to);
    if (!line || line->length == 0.0) return line ? std::optional(TangentLine{0.0, 0.0}) : std::nullopt;
    if (farthest_[octant_of(line->along)] < line->length * (1.0 - kHorizonSlack)) return std::nullopt;
    const TangentLine tangent = tangent_along(*line);
    return hides(tangent) ? std::nullopt : std::optional(tangent);
  }
  /// Whether the tangent line is certainly blocked. False if there may be none.
  [[nodiscard]] bool hides(const TangentLine& tangent) const {
    if (tangent.length == 0.0) return false;
    constexpr double slack = kQuickAngleError + kHorizonSlack;
    const double end = std::max(far_[range_of(tangent.heading - slack)], far_[range_of(tangent.heading + slack)]);
    return end < tangent.length * (1.0 - kHorizonSlack);
  }
  /// To be called when all outlines have been taken into account.
  void finish();

 private:
  static constexpr int kHeadings = 512, kOctants = 8;
  static int range_of(double heading) {
    return static_cast<int>((heading + 2.0 * kTwoPi) * (kHeadings / kTwoPi)) % kHeadings;
  }
  static std::size_t octant_of(const Vec2& d) {
    // By whether y > 0, x > 0 and |y| > |x|.
    constexpr std::array<std::uint8_t, kOctants> kOctant{4, 5, 7, 6, 3, 2, 0, 1};
    return kOctant[(d.y() > 0.0 ? 4u : 0u) + (d.x() > 0.0 ? 2u : 0u) + (std::abs(d.y()) > std::abs(d.x()) ? 1u : 0u)];
  }
  // As line_of_bitangent, up to rounding and quicker. Nothing if there is certainly none; length 0: there may be none.
  [[nodiscard]] std::optional<BitangentLine> line_to(const TurnCircle& to) const {
    const Vec2 d = to.center - circle_.center;
    const double offset = sign_of(to.side) * to.radius - sign_of(circle_.side) * circle_.radius;
    const double square = d.squaredNorm() - offset * offset, rounding = kHorizonSlack * offset * offset;
    if (square < -rounding) return std::nullopt;
    if (!(square > rounding)) return BitangentLine{d, 0.0};  // they may touch
    const double length = std::sqrt(square);
    return BitangentLine{length * d - offset * perpendicular(d), length};
  }
  [[nodiscard]] static TangentLine tangent_along(const BitangentLine& line) {
    const double heading = quick_angle_of(line.along);
    return {heading < 0.0 ? heading + kTwoPi : heading, line.length};
  }
  // Whether all straights in the ranges [first, last) end before a distance [m].
  [[nodiscard]] bool end_before(double distance, int first, int last) const;
  void shorten_by_edge(const std::array<Vec2, 2>& edge);
  void shorten_by(std::span<const Vec2> outline);

  TurnCircle circle_;
  Eigen::Array<double, kHeadings, 1> far_;  // by heading, in equal ranges from 0
  std::array<double, kOctants> farthest_;   // upper bounds of those of an octant
};

}  // namespace arcway::internal
