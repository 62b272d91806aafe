#include <algorithm>
#include <cmath>
#include <span>

#include "arcway/angle.h"
#include "bench/figures/canvas.h"
#include "bench/figures/figures.h"
#include "bench/robots.h"

namespace arcway::internal::figures {
namespace {

constexpr const char* kBodyEdge = "#0072b2";
constexpr const char* kReference = "#d55e00";
constexpr const char* kBar = "#1d2126";
constexpr int kPoses = 36;  // of a body along a turn
constexpr double kTurn = 0.5 * kPi;
constexpr double kPanel = 200.0;  // side of a panel without its texts [px]
constexpr double kTexts = 60.0;   // below a panel [px]
constexpr double kGap = 16.0;     // between panels [px]

/// The pose of F after a turn from the origin.
Pose pose_after(Side side, double radius, double turn) {
  const double s = sign_of(side);
  return {radius * std::sin(turn), s * radius * (1.0 - std::cos(turn)), s * turn};
}

/// A vehicle at the origin, with what it sweeps in its tightest turns to both sides.
class Panel {
 public:
  Panel(Canvas& canvas, const Vehicle& vehicle, const Vec2& corner) : canvas_(canvas), vehicle_(vehicle) {
    Box box;
    for (const Side side : {Side::kLeft, Side::kRight})
      for (int i = 0; i <= kPoses; ++i)
        for (const Ring& ring : vehicle.outline(pose_after(side, vehicle.min_turning_radius(side), at(i))))
          for (const Vec2& p : ring) box.extend(p);
    const Vec2 extent = box.max - box.min;
    scale_ = kPanel / extent.maxCoeff();
    origin_ = corner + 0.5 * Vec2(kPanel, kPanel) - 0.5 * scale_ * (box.min + box.max);
    for (const Side side : {Side::kLeft, Side::kRight}) draw_turn(side, vehicle.min_turning_radius(side));
    draw_body({}, "#9ec3e0", kBodyEdge);
    canvas_.dot(origin_, kReference);
    const double meters = std::pow(10.0, std::floor(std::log10(extent.maxCoeff() / 3.0)));
    const Vec2 bar = corner + Vec2(0.0, -14.0);
    canvas_.line(bar, bar + Vec2(meters * scale_, 0.0), kBar, 3.0);
    canvas_.text(bar + Vec2(meters * scale_ + 6.0, -4.0), digits(meters, meters < 1.0 ? 1 : 0) + " m", "start");
  }

 private:
  static double at(int i) { return kTurn * i / kPoses; }

  void draw_turn(Side side, double radius) {
    std::string track;
    for (int i = 0; i <= kPoses; ++i) {
      const Pose pose = pose_after(side, radius, at(i));
      draw_body(pose, "#f6dfcf", "#f6dfcf");
      track += canvas_.at(origin_ + scale_ * pose.position());
    }
    canvas_.curve(track, kReference, 1.5, "6 4");
  }
  void draw_body(const Pose& pose, const char* fill, const char* stroke) {
    for (const Ring& ring : vehicle_.outline(pose)) {
      std::string points;
      for (const Vec2& p : ring) points += canvas_.at(origin_ + scale_ * p);
      canvas_.polygon(points, fill, stroke);
    }
  }

  Canvas& canvas_;
  Vehicle vehicle_;
  double scale_ = 1.0;  // pixels a meter
  Vec2 origin_{0.0, 0.0};
};

}  // namespace

Figure vehicle_gallery() {
  const std::span<const bench::KeptVehicle> all = bench::vehicles_of_other_outlines();
  const auto count = static_cast<double>(all.size());
  Canvas canvas({0.0, -kTexts}, {count * (kPanel + kGap) - kGap, kPanel}, {1.0, 1.0});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec2 corner(static_cast<double>(i) * (kPanel + kGap), 0.0);
    const Panel panel(canvas, all[i].vehicle(), corner);
    canvas.text(corner + Vec2(0.0, -44.0), all[i].what, "start");
  }
  const std::string caption =
      "Bodies that plans are made for, exactly: each where it starts, with what it sweeps in a quarter of its "
      "tightest\n"
      "turn to either side. Orange: F, and its path.";
  return {"bodies", canvas.str("Bodies of vehicles", caption), caption};
}

}  // namespace arcway::internal::figures
