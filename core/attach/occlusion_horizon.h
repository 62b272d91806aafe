#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "arcway/angle.h"
#include "core/attach/sectors.h"
#include "core/model/outlines.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

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
  /// Whether the tangent line is certainly blocked. False if there may be none.
  [[nodiscard]] bool hides(const TangentLine& tangent) const;

 private:
  static constexpr int kHeadings = 512;
  // The range of a heading > -4 pi, several times as fast as wrapping any heading.
  static int range_of(double heading) {
    return static_cast<int>((heading + 2.0 * kTwoPi) * (kHeadings / kTwoPi)) % kHeadings;
  }
  // Whether all straights in the ranges [first, last) end before a distance [m].
  [[nodiscard]] bool end_before(double distance, int first, int last) const;
  void shorten_by_edge(const std::array<Vec2, 2>& edge);
  void shorten_by(std::span<const Vec2> outline);

  TurnCircle circle_;
  Eigen::Array<double, kHeadings, 1> far_;  // by heading, in equal ranges from 0
};

}  // namespace arcway::internal
