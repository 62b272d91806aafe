#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "bench/figures/canvas.h"
#include "bench/figures/figures.h"
#include "bench/live/live_drive.h"
#include "bench/live/live_planner.h"
#include "bench/robots.h"
#include "bench/vehicle_worlds.h"

namespace arcway::internal::figures {
namespace {

constexpr const char* kWorld = "clutter/convex/n40/m8/f15/s2";
constexpr double kRate = 5.0;         // cycles a second
constexpr std::size_t kCycles = 150;  // recorded
constexpr std::size_t kGoals = 6;
constexpr std::uint32_t kTrials = 200;                       // of refinement, for each plan
constexpr double kWidth = 720.0;                             // of the animation [px]
constexpr double kPanelWidth = 330.0;                        // of a moment [px]
constexpr double kBetween = 18.0;                            // between moments [px]
constexpr double kWayStep = 0.25;                            // between points of a way [m]
constexpr std::array<std::size_t, 3> kMoments{10, 60, 110};  // cycles

constexpr const char* kObstacle = "#c8ccd2";
constexpr const char* kObstacleEdge = "#8a9099";
constexpr const char* kWalker = "#e69f00";
constexpr const char* kBody = "#9ec3e0";
constexpr const char* kWay = "#0072b2";
constexpr const char* kBraking = "#d55e00";
constexpr const char* kGoal = "#009e73";

// What is seen in one cycle.
struct Moment {
  Pose pose, goal;
  bool brakes;
  std::vector<Vec2> way;  // still ahead
  std::vector<bench::WalkingObstacles::Obstacle> obstacles;
};

struct Recording {
  World world;
  Vehicle vehicle;
  std::vector<Moment> moments;
  std::size_t planned = 0, kept = 0, braking = 0;

  // Whether an obstacle is not the same in all moments.
  [[nodiscard]] bool moves(std::size_t obstacle) const {
    for (const Moment& moment : moments) {
      const auto& now = moment.obstacles[obstacle];
      if (now.is_there != moments.front().obstacles[obstacle].is_there ||
          now.polygon.outer != moments.front().obstacles[obstacle].polygon.outer)
        return true;
    }
    return false;
  }
};

Recording record(const std::function<Backend(const World&)>& make_backend) {
  const bench::KeptVehicle kept = bench::real_vehicles().front();
  const Vehicle vehicle = kept.vehicle();
  Recording recording{bench::world_for(vehicle, kWorld), vehicle, {}};
  const World& world = recording.world;
  const std::vector<PlanRequest> requests = bench::queries_for(vehicle, world, kGoals, 1);
  std::vector<Pose> goals;
  goals.reserve(requests.size());
  for (const PlanRequest& request : requests) goals.push_back(request.goal);
  bench::ChangedPlanner planner(Planner(world, vehicle, make_backend(world), {.refinement = {.max_trials = kTrials}}));
  const Trajectory first = planner.planner().plan(requests.front()).trajectory();
  bench::LiveDrive drive(planner, first, goals, {.rate = kRate, .within = std::numeric_limits<double>::infinity()});
  for (std::size_t i = 0; i < kCycles; ++i) {
    const bench::LiveCycle cycle = drive.next_cycle();
    const std::span<const bench::WalkingObstacles::Obstacle> obstacles = drive.obstacles().obstacles();
    Moment moment{cycle.now.pose, drive.goal(), cycle.next.motion == NextMotion::kBraking, {}, {}};
    if (!cycle.next.segments.empty()) moment.way = polyline(path_of(cycle.next.segments), kWayStep);
    moment.obstacles.assign(obstacles.begin(), obstacles.end());
    recording.moments.push_back(std::move(moment));
    recording.planned += cycle.next.motion == NextMotion::kPlanned;
    recording.kept += cycle.next.motion == NextMotion::kKept || cycle.next.motion == NextMotion::kRepaired;
    recording.braking += cycle.next.motion == NextMotion::kBraking;
  }
  return recording;
}

std::string points_of(const Canvas& canvas, std::span<const Vec2> points) {
  std::string text;
  for (const Vec2& p : points) text += canvas.at(p);
  return text;
}

// The drive as SVG elements that move by themselves, all with the same period.
class Animation {
 public:
  Animation(Canvas& canvas, const Recording& recording) : canvas_(canvas), recording_(recording) {}

  void draw() {
    for (std::size_t o = 0; o < recording_.moments.front().obstacles.size(); ++o) draw_obstacle(o);
    draw_goal();
    draw_way();
    draw_vehicle();
  }

 private:
  [[nodiscard]] Vec2 shift(const Vec2& from, const Vec2& to) const { return canvas_.pixels(to) - canvas_.pixels(from); }

  // An animation of values, one a cycle. Those that glide end with the last one held.
  template <class ValueOf>
  [[nodiscard]] std::string animated(std::string_view element, std::string_view attributes, bool glides,
                                     ValueOf&& value_of) const {
    std::string values;
    for (const Moment& moment : recording_.moments) values += value_of(moment) + ";";
    if (glides)
      values += value_of(recording_.moments.back());
    else
      values.pop_back();
    return "<" + std::string(element) + " " + std::string(attributes) + " dur=\"" + digits(kCycles / kRate, 0) +
           "s\" repeatCount=\"indefinite\" calcMode=\"" + (glides ? "linear" : "discrete") + "\" values=\"" + values +
           "\"/>";
  }
  [[nodiscard]] static std::string pair(const Vec2& v) { return digits(v.x(), 1) + "," + digits(v.y(), 1); }

  void draw_obstacle(std::size_t o) {
    const Polygon& first = recording_.moments.front().obstacles[o].polygon;
    if (!recording_.moves(o)) {
      canvas_.polygon(points_of(canvas_, first.outer), kObstacle, kObstacleEdge);
      return;
    }
    const auto offset = [&](const Moment& m) {
      return pair(shift(first.outer.front(), m.obstacles[o].polygon.outer.front()));
    };
    const auto opacity = [&](const Moment& m) { return std::string(m.obstacles[o].is_there ? "1" : "0"); };
    canvas_.element("<polygon points=\"" + points_of(canvas_, first.outer) + "\" fill=\"" + kWalker + "\" stroke=\"" +
                    kObstacleEdge + "\">" +
                    animated("animateTransform", "attributeName=\"transform\" type=\"translate\"", true, offset) +
                    animated("animate", "attributeName=\"opacity\"", false, opacity) + "</polygon>\n");
  }

  void draw_goal() {
    const auto x = [&](const Moment& m) { return digits(canvas_.pixels(m.goal.position()).x(), 1); };
    const auto y = [&](const Moment& m) { return digits(canvas_.pixels(m.goal.position()).y(), 1); };
    const Moment& first = recording_.moments.front();
    canvas_.element("<circle cx=\"" + x(first) + "\" cy=\"" + y(first) + "\" r=\"6\" fill=\"" + kGoal + "\">" +
                    animated("animate", "attributeName=\"cx\"", false, x) +
                    animated("animate", "attributeName=\"cy\"", false, y) + "</circle>\n");
  }

  void draw_way() {
    const auto way = [&](const Moment& m) {
      return "M" + (m.way.empty() ? canvas_.at(m.pose.position()) : points_of(canvas_, m.way));
    };
    const auto color = [](const Moment& m) { return std::string(m.brakes ? kBraking : kWay); };
    const Moment& first = recording_.moments.front();
    canvas_.element("<path fill=\"none\" stroke-width=\"2.5\" stroke=\"" + color(first) + "\" d=\"" + way(first) +
                    "\">" + animated("animate", "attributeName=\"d\"", false, way) +
                    animated("animate", "attributeName=\"stroke\"", false, color) + "</path>\n");
  }

  void draw_vehicle() {
    std::string body;
    for (const Ring& ring : recording_.vehicle.outline(Pose{}))
      for (const Vec2& p : ring) body += pair(shift({0.0, 0.0}, p)) + " ";
    std::vector<double> turned;  // without jumps by a full turn [degrees], clockwise
    for (const Moment& m : recording_.moments) {
      const double turn = turned.empty() ? 0.0 : -turned.back() * kPi / 180.0;
      turned.push_back(-(turn + wrap_signed(m.pose.heading - turn)) * 180.0 / kPi);
    }
    const auto place = [&](const Moment& m) { return pair(canvas_.pixels(m.pose.position())); };
    const auto turn = [&](const Moment& m) {
      return digits(turned[static_cast<std::size_t>(&m - recording_.moments.data())], 1);
    };
    const Moment& first = recording_.moments.front();
    canvas_.element("<g transform=\"translate(" + place(first) + ")\">" +
                    animated("animateTransform", "attributeName=\"transform\" type=\"translate\"", true, place) +
                    "<polygon points=\"" + body + "\" fill=\"" + kBody + "\" stroke=\"" + kWay +
                    "\" transform=\"rotate(" + turn(first) + ")\">" +
                    animated("animateTransform", "attributeName=\"transform\" type=\"rotate\"", true, turn) +
                    "</polygon></g>\n");
  }

  Canvas& canvas_;
  const Recording& recording_;
};

std::string caption_of(const Recording& recording) {
  return "The AMR of bench/robots.h plans on " + digits(kRate, 0) + " times a second for " +
         digits(kCycles / kRate, 0) + " s. In turn, obstacles (orange)\nmove across its way, vanish and come back. " +
         std::to_string(recording.planned) + " motions are new plans, " + std::to_string(recording.kept) +
         " the rest\nof the one before, " + std::to_string(recording.braking) + " brake (red). Green: the goal.";
}

Figure animate(const Recording& recording) {
  const Box box = recording.world.box();
  const double scale = kWidth / (box.max - box.min).x();
  Canvas canvas(box.min, box.max, {scale, scale});
  Animation(canvas, recording).draw();
  const std::string caption = caption_of(recording);
  return {"live", canvas.str("A drive through a map that changes", caption), caption};
}

// Moments side by side, each as it was.
Figure draw_moments(const Recording& recording) {
  const Box box = recording.world.box();
  const Vec2 extent = box.max - box.min;
  const double scale = kPanelWidth / extent.x();
  const double step = (kPanelWidth + kBetween) / scale;  // from panel to panel [m]
  const double count = static_cast<double>(kMoments.size());
  Canvas canvas(box.min, box.min + Vec2((count - 1.0) * step + extent.x(), extent.y()), {scale, scale});
  for (std::size_t i = 0; i < kMoments.size(); ++i) {
    const Moment& moment = recording.moments[kMoments[i]];
    const Vec2 corner(static_cast<double>(i) * step, 0.0);
    const auto draw = [&](std::span<const Vec2> points, const char* fill, const char* stroke) {
      std::vector<Vec2> there;
      for (const Vec2& p : points) there.push_back(corner + p);
      if (fill)
        canvas.polygon(points_of(canvas, there), fill, stroke);
      else
        canvas.curve(points_of(canvas, there), stroke);
    };
    for (std::size_t o = 0; o < moment.obstacles.size(); ++o)
      if (moment.obstacles[o].is_there)
        draw(moment.obstacles[o].polygon.outer, recording.moves(o) ? kWalker : kObstacle, kObstacleEdge);
    draw(moment.way, nullptr, moment.brakes ? kBraking : kWay);
    for (const Ring& ring : recording.vehicle.outline(moment.pose)) draw(ring, kBody, kWay);
    canvas.dot(corner + moment.goal.position(), kGoal);
  }
  std::string caption = "The drive of live.svg after";
  for (const std::size_t cycle : kMoments)
    caption += (cycle == kMoments.front()  ? " "
                : cycle == kMoments.back() ? " and "
                                           : ", ") +
               digits(static_cast<double>(cycle + 1) / kRate, 1);
  caption += " s: obstacles where they are then (orange: those that move), and the motion that is planned (blue).";
  return {"live_moments", canvas.str("Moments of a drive through a map that changes", caption), caption};
}

}  // namespace

LiveFigures live_drive(const std::function<Backend(const World&)>& make_backend) {
  const Recording recording = record(make_backend);
  return {animate(recording), draw_moments(recording)};
}

}  // namespace arcway::internal::figures
