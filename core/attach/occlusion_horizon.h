#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "arcway/angle.h"
#include "core/attach/sectors.h"
#include "core/model/outlines.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// How far, at most, the reference point gets on a straight that leaves a directed circle, by heading: an upper bound
/// from some of the outlines near by, so that what lies behind them need not be looked at.
///
/// A piece of outline that all straights within a range of headings cross ends all of them. The bound holds whatever
/// the rounding: ranges are narrowed and distances raised by far more than it. It needs a body that covers its
/// reference point.
class OcclusionHorizon {
 public:
  /// Of the straights that leave the circle within a turn from a heading on [rad], and of no others.
  OcclusionHorizon(const TurnCircle& circle, double heading, double turn);
  /// Takes the outlines into account, those near by first.
  void shorten(const Outlines& outlines);
  /// The same of a single piece.
  void shorten(std::span<const Vec2> outline, const Box& box);

  /// No free straight of this heading is longer [m]; negative if there is none.
  [[nodiscard]] double reach(double heading) const;
  /// Whether all points of a box lie behind the horizon.
  [[nodiscard]] bool hides(const Box& box) const;
  /// Those in which straights leave that get to points of a box, and maybe others.
  [[nodiscard]] Sectors sectors_towards(const Box& box) const;
  /// The straight onto another directed circle, as far as it is needed to look it up.
  struct TangentLine {
    double heading;  ///< [0, 2 pi] within kTangentError
    double length;   ///< [m]; 0: there may be none
  };
  static constexpr double kTangentError = 1e-4;
  [[nodiscard]] TangentLine tangent_to(const TurnCircle& to) const;
  /// Whether it is certainly not free; false also where there is none.
  [[nodiscard]] bool hides(const TangentLine& tangent) const;

 private:
  static constexpr int kHeadings = 512;
  // The range that a heading > -4 pi lies in, several times as fast as for any heading.
  static int range_of(double heading) {
    return static_cast<int>((heading + 2.0 * kTwoPi) * (kHeadings / kTwoPi)) % kHeadings;
  }
  // Whether all straights in the ranges from one to before another end before some distance.
  [[nodiscard]] bool end_before(double distance, int first, int last) const;
  void shorten_by_edge(const std::array<Vec2, 2>& edge);
  void shorten_by(std::span<const Vec2> outline);

  TurnCircle circle_;
  Eigen::Array<double, kHeadings, 1> far_;  // by heading, in equal ranges from 0
};

}  // namespace arcway::internal
