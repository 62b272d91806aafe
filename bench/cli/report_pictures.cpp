#include "bench/cli/report_pictures.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/svg.h"
#include "arcway/planner.h"
#include "bench/cli/arguments.h"
#include "bench/cli/draw_live_drive.h"
#include "bench/report/first_page.h"
#include "bench/report/markup.h"
#include "bench/report/results.h"
#include "bench/robots.h"
#include "bench/vehicle_worlds.h"

namespace arcway::internal::cli {
namespace {

constexpr double kPictureWidth = 640.0;             // of the map in a picture [px]
constexpr std::size_t kMostPictureBytes = 400'000;  // of a picture: a page of two stays below a megabyte
constexpr double kMargin = 0.1;                     // around a path, as a share of its extent
constexpr std::size_t kQueriesTried = 10;           // for a plan with turns

/// What a query of the results was planned with.
struct ReportedScene {
  std::string vehicle_name;
  Vehicle vehicle;
  World world;
  std::vector<PlanRequest> requests;
};

ReportedScene reported_scene(const report::PicturedQuery& query, std::size_t count) {
  for (const bench::KeptVehicle& kept : bench::real_vehicles()) {
    if (kept.name != query.vehicle) continue;
    const Vehicle vehicle = kept.vehicle();
    World world = bench::world_for(vehicle, query.world);
    std::vector<PlanRequest> requests = bench::queries_for(vehicle, world, count, 1);
    return {"a " + std::string(kept.what), vehicle, std::move(world), std::move(requests)};
  }
  const auto gentle = std::ranges::find(bench::kGentleRobots, query.vehicle, &bench::GentleRobot::name);
  const bool is_gentle = gentle != std::end(bench::kGentleRobots);
  return {is_gentle ? "the paper's robot with limits on its acceleration" : "the paper's robot",
          is_gentle ? gentle->vehicle() : Vehicle(), catalog_world(query.world),
          catalog_queries(query.world, count, 1)};
}

/// Segments by the meter: the more, the more a picture of the path shows.
double turns_by_length(const PlanResult& result) {
  return result.solved() ? static_cast<double>(result.segments.size()) / result.length : 0.0;
}

/// The plan of a query, or of several the one that turns most.
PlanResult plan_again(const report::PicturedQuery& query, const ReportedScene& scene) {
  const BuildOptions build;
  const std::unique_ptr<const Executor> executor = build.executor();
  const Planner planner(scene.world, scene.vehicle, build.backend_for(scene.world, *executor, kSingleProcess),
                        {.graph_mode = GraphMode::kLazy});
  PlanResult best = planner.plan(scene.requests[query.query]);
  for (std::size_t q = query.query + 1; q < scene.requests.size(); ++q) {
    PlanResult other = planner.plan(scene.requests[q]);
    if (turns_by_length(other) > turns_by_length(best)) best = std::move(other);
  }
  return best;
}

/// A square around a path; without one around start and goal.
Box view_of(const PlanResult& result, const ReportedScene& scene) {
  const Body body = scene.vehicle.body();
  Box view;
  for (const Vec2& p : {result.start.position(), result.goal.position()}) view.extend(p);
  if (result.solved())
    for (const Vec2& p : polyline(result.path(), body.front + body.rear)) view.extend(p);
  const Vec2 middle = 0.5 * (view.min + view.max);
  const double longest = (view.max - view.min).maxCoeff();
  const double half = (0.5 + kMargin) * longest + body.front + body.rear;
  return {middle - Vec2(half, half), middle + Vec2(half, half)};
}

std::string draw_again(const PlanResult& result, const ReportedScene& scene) {
  const Body body = scene.vehicle.body();
  SvgPicture svg(scene.world, view_of(result, scene), kPictureWidth);
  svg.add_axes();
  if (result.solved()) {
    svg.add_swept_area(result.path(), body);
    svg.add_path(result.path(), body);
    svg.add_speeds(result.trajectory());
  } else {
    const std::vector<Pose> poses{result.start, result.goal};
    svg.add_bodies(poses, body);
    svg.add_poses(result.start, result.goal, body);
  }
  return svg.str();
}

/// An SVG document as an element of a page that has others: no declaration, and ids that begin with `prefix`.
std::string inlined(std::string svg, const std::string& prefix) {
  svg.erase(0, svg.find("<svg"));
  for (const std::string_view mark : {" id=\"", "url(#"})
    for (std::size_t at = 0; (at = svg.find(mark, at)) != std::string::npos; at += mark.size() + prefix.size())
      svg.insert(at + mark.size(), prefix);
  return svg;
}

std::string picture_caption(const report::PicturedQuery& query, const ReportedScene& scene, const PlanResult& result) {
  const auto text = [](const char* format, double value) { return report::number_text(format, value); };
  std::string caption = query.title + ": " + scene.vehicle_name + " among " +
                        report::count_text(static_cast<double>(scene.world.obstacle_count())) + " obstacles";
  caption += result.solved() ? ", " + text("%.1f", result.length) + " m in " + text("%.1f", result.travel_time) + " s"
                             : ", no path: " + result.reason;
  if (query.seconds > 0.0)
    caption += ". Planned anew for this picture; in the results it took " + report::time_text(query.seconds) +
               " of processor time";
  return caption + (result.solved() ? ". Shaded: what the body sweeps; colors: speed." : ".");
}

}  // namespace

std::vector<std::string> report_pictures(const report::Inputs& inputs) {
  std::vector<std::string> pictures;
  for (const report::PicturedQuery& query : report::pictured_queries(inputs)) {
    if (!is_catalog_name(query.world)) continue;  // a map that only who measured has
    const ReportedScene scene = reported_scene(query, query.query + (query.any ? kQueriesTried : 1));
    const PlanResult result = plan_again(query, scene);
    const std::string svg = inlined(draw_again(result, scene), "picture" + std::to_string(pictures.size()) + "-");
    if (svg.size() > kMostPictureBytes) continue;
    pictures.push_back("<figure class=\"picture\">" + svg + "<figcaption>" +
                       escaped(picture_caption(query, scene, result)) + "</figcaption></figure>");
  }
  if (!report::of_stage(inputs.results, "Live").empty())
    pictures.push_back("<figure class=\"picture\">" + inlined(draw_live_drive().animation.svg, "live-") + "</figure>");
  return pictures;
}

}  // namespace arcway::internal::cli
