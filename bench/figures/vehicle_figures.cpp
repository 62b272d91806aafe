#include <cmath>

#include "arcway/angle.h"
#include "bench/figures/canvas.h"
#include "bench/figures/figures.h"

namespace arcway::internal::figures {
namespace {

constexpr const char* kBlue = "#0072b2";
constexpr const char* kOrange = "#d55e00";
constexpr const char* kGreen = "#009e73";
constexpr const char* kGray = "#7a828c";

constexpr double kSweptPixels = 308.0;  // outer radius of a turn in its picture

constexpr Footprint kWheel{0.14, 0.14, 0.04, 0.04};

/// A body at a pose.
std::string rectangle(const Canvas& canvas, const Pose& pose, const Footprint& body) {
  std::string points;
  const Vec2 ahead = direction_of(pose.heading);
  for (const auto& [x, y] : {std::pair{body.front, body.left},
                             {-body.rear, body.left},
                             {-body.rear, -body.right},
                             {body.front, -body.right}})
    points += canvas.at(pose.position() + x * ahead + y * perpendicular(ahead));
  return points;
}

}  // namespace

Figure vehicle_model(const Vehicle& vehicle) {
  const VehicleParameters& p = vehicle.parameters();
  const Footprint body = vehicle.footprint();
  const double radius = vehicle.min_turning_radius();
  Canvas canvas({-0.6, -0.75}, {2.6, radius + 0.25}, {230.0, 230.0});
  const Vec2 center(0.0, radius);  // F at the origin, heading along +x
  canvas.polygon(rectangle(canvas, {}, body), "#dfe7ef", kBlue);
  const double gauge = 0.4 * body.width();
  for (const double side : {-1.0, 1.0}) {
    canvas.polygon(rectangle(canvas, {0.0, side * gauge, 0.0}, kWheel), "#1d2126", "#1d2126");
    const double angle = std::atan2(p.wheelbase, radius - side * gauge);
    canvas.polygon(rectangle(canvas, {p.wheelbase, side * gauge, angle}, kWheel), "#1d2126", "#1d2126");
    canvas.line({p.wheelbase, side * gauge}, center, kGray, 1.0, "4 4");
  }
  canvas.line({0.0, -gauge}, center, kGray, 1.0, "4 4");
  canvas.line({0.0, 0.0}, center, kOrange, 2.0);
  canvas.line({0.0, -0.55}, {p.wheelbase, -0.55}, kGreen, 2.0);
  canvas.line({p.wheelbase, 0.0}, {p.wheelbase + 0.6, 0.0}, kGray, 1.0, "4 4");
  const Vec2 steered = direction_of(p.max_steering_angle);
  canvas.line({p.wheelbase, 0.0}, Vec2(p.wheelbase, 0.0) + 0.6 * steered, kOrange, 2.0);
  canvas.dot({0.0, 0.0}, kOrange);
  canvas.dot(center, kOrange);
  canvas.text({-0.06, 0.06}, "F", "end");
  canvas.text({0.06, radius + 0.04}, "ICR: center of rotation", "start");
  canvas.text({-0.06, 0.55 * radius}, "ρ", "end", kOrange);
  canvas.text({0.5 * p.wheelbase, -0.67}, "wheelbase l", "middle", kGreen);
  canvas.text(Vec2(p.wheelbase + 0.05, 0.06) + 0.6 * steered, "γ", "start", kOrange);
  const std::string caption = "Front steering: F is on the rear axle. Body 2a × 2b = " + digits(p.length, 1) + " × " +
                              digits(p.width, 1) + " m, l = " + digits(p.wheelbase, 1) +
                              " m,\nγ = " + digits(p.max_steering_angle * 180.0 / kPi, 0) +
                              "°, smallest turning radius ρ = l / tan γ = " + digits(radius, 2) + " m.";
  return {"figure2", canvas.str("The vehicle model", caption), caption};
}

Figure swept_turn(const Vehicle& vehicle, const std::string& name) {
  const double radius = vehicle.min_turning_radius(Side::kLeft);
  const SweptAnnulus swept = vehicle.swept_annulus(Side::kLeft, radius);
  const double scale = kSweptPixels / swept.outer;
  Canvas canvas(swept.outer * Vec2(-1.05, -0.09), swept.outer * Vec2(1.05, 1.07), {scale, scale});
  std::string annulus;
  for (int i = 0; i <= 60; ++i) annulus += canvas.at(swept.outer * direction_of(kPi * i / 60.0));
  for (int i = 60; i >= 0; --i) annulus += canvas.at(swept.inner * direction_of(kPi * i / 60.0));
  canvas.polygon(annulus, "#f6dfcf", kOrange);
  std::string track;
  for (int i = 0; i <= 60; ++i) track += canvas.at(radius * direction_of(kPi * i / 60.0));
  for (int i = 2; i <= 6; ++i) {
    const double angle = 0.1 * kPi * i;
    const Vec2 at = radius * direction_of(angle);
    for (const Ring& part : vehicle.outline({at.x(), at.y(), angle + 0.5 * kPi})) {
      std::string points;
      for (const Vec2& p : part) points += canvas.at(p);
      canvas.polygon(points, "#cfdde9", kBlue, 0.5);
    }
  }
  canvas.curve(track, "#1d2126", 2.0, "6 4");
  canvas.dot({0.0, 0.0}, kOrange);
  canvas.line({0.0, 0.0}, {swept.inner, 0.0}, kGreen, 2.5);
  canvas.line({0.0, 0.0}, {-swept.outer, 0.0}, kOrange, 2.5);
  const double below = -0.065 * swept.outer;
  canvas.text({0.5 * swept.inner, below}, "ρ_in", "middle", kGreen);
  canvas.text({-0.6 * swept.outer, below}, "ρ_out", "middle", kOrange);
  const std::string caption = "A turn at ρ = " + digits(radius, 2) +
                              " m sweeps the ring from ρ_in = " + digits(swept.inner, 2) +
                              " to ρ_out = " + digits(swept.outer, 2) + " m,\nw_s = " + digits(swept.width(), 2) +
                              " m wide, where driving straight takes 2b = " + digits(vehicle.footprint().width(), 2) +
                              " m.\nDashed: the path of F.";
  return {name, canvas.str("The swept area of a turn", caption), caption};
}

}  // namespace arcway::internal::figures
