#include "bench/report/first_page.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bench/report/least_queries.h"
#include "bench/report/map_sections.h"
#include "bench/report/markup.h"
#include "bench/report/peer_sections.h"
#include "bench/report/vehicle_sections.h"
#include "bench/robots.h"
#include "bench/slowest_query.h"

namespace arcway::internal::report {
namespace {

constexpr const char* kWhat =
    "arcway plans how a car-like vehicle gets from one position and heading to another in the shortest time without "
    "touching an obstacle.";

/// The vehicle that a benchmark of quality names, "car" of "car/convex_f30"; empty for the paper's robot.
std::string vehicle_of(const std::string& name) {
  const std::size_t slash = name.find('/');
  return slash == std::string::npos ? std::string() : name.substr(0, slash);
}

bool is_kept(const std::string& vehicle) { return vehicle_rank(vehicle) < bench::real_vehicles().size(); }

/// What all benchmarks of quality found together.
struct QualityTotal {
  bool is_of_own_maps = false;
  double queries = 0.0, solved = 0.0;
  std::set<std::string> vehicles;
  std::vector<double> seconds, over_bound;
};

QualityTotal total_quality(const Results& results) {
  QualityTotal total;
  total.is_of_own_maps = is_of_own_maps(results);
  for (const Measurement* m : of_stage(results, total.is_of_own_maps ? "RealMap" : "Quality")) {
    const double solved = solved_queries(*m);
    if (!(solved > 0.0)) continue;
    total.queries += m->counters.at("queries");
    total.solved += solved;
    total.vehicles.insert(vehicle_of(place_of(m->name).variant));
    if ((total.is_of_own_maps ? m->counters.at("queries") : solved) < kLeastQueries) continue;
    for (const auto& [name, values] :
         {std::pair("plan_seconds_median", &total.seconds), std::pair("time_over_bound_median", &total.over_bound)})
      if (const auto found = m->counters.find(name); found != m->counters.end()) values->push_back(found->second);
  }
  return total;
}

/// "5 real vehicles and the robot of the paper behind the method"
std::string vehicles_text(const std::set<std::string>& vehicles) {
  const auto real = static_cast<std::size_t>(std::ranges::count_if(vehicles, is_kept));
  std::vector<std::string> names;
  if (real > 0) names.push_back(real == 1 ? "a real vehicle" : std::to_string(real) + " real vehicles");
  for (const std::string& vehicle : vehicles)
    if (!is_kept(vehicle)) names.push_back(vehicle.empty() ? "the robot of the paper behind the method" : vehicle);
  return listed(names);
}

std::string planned_text(const QualityTotal& total) {
  if (!(total.queries > 0.0)) return {};
  const bool own = total.is_of_own_maps;
  std::string text =
      " Here it solved " + count_text(total.solved) + " of " + count_text(total.queries) +
      (own ? " tasks (" : " random tasks (") + number_text("%.0f", 100.0 * total.solved / total.queries) + " %) for " +
      (own ? listed(std::vector(total.vehicles.begin(), total.vehicles.end())) : vehicles_text(total.vehicles)) +
      "; an independent check accepted every path.";
  if (total.seconds.empty() || total.over_bound.empty()) return text;
  const auto [low, high] = std::ranges::minmax(total.seconds);
  const auto [best, worst] = std::ranges::minmax(total.over_bound);
  const auto percent = [](double ratio) { return number_text("%.1f", 100.0 * (ratio - 1.0)); };
  return text + " Once a map is prepared, a plan takes " + range_text(low, high, time_text) +
         " of processor time, and the drive lasts " + range_text(best, worst, percent) +
         " % longer than a bound that nothing can beat (medians, by vehicle and map).";
}

// Widest 95 % interval of an exponent that is told to a stranger: up to it, ten times as many obstacles take 1.8 times
// more or less than is said.
constexpr double kWidestInterval = 0.5;

std::string growth_text(const std::vector<Study>& studies) {
  struct Part {
    const char* series;
    const char* what;
  };
  constexpr Part kParts[] = {{"Plan/lazy", "the first plan on a new map"},
                             {"ReducedGraph/tangent-cones", "the search for corners that see each other"},
                             {"Plan/graph_reused", "a plan on a prepared map"}};
  for (const Part& part : kParts) {
    const Study::Line* line = find_line(studies, part.series, "obstacles");
    if (line == nullptr || !line->curve.fit) continue;
    if (line->curve.fit->high - line->curve.fit->low > kWidestInterval) continue;
    const double exponent = line->curve.fit->exponent;
    const Curve::Point& last = line->curve.points.back();
    return std::string(" With ten times as many obstacles, ") + part.what + " takes " +
           number_text("%.2g", std::pow(10.0, exponent)) + " times as long (it grows like n^" +
           number_text("%.2f", exponent) + " with n obstacles): " + time_text(last.y) + " among " + count_text(last.x) +
           ".";
  }
  return {};
}

std::optional<PicturedQuery> slowest_of(const Results& results) {
  std::optional<PicturedQuery> slowest;
  for (const Measurement* m : of_stage(results, "Quality")) {
    const std::optional<bench::SlowestQuery> found = bench::slowest_query_of(m->label);
    if (!found || (slowest && slowest->seconds >= found->seconds)) continue;
    slowest = PicturedQuery{.title = {},
                            .vehicle = vehicle_of(place_of(m->name).variant),
                            .world = found->world,
                            .query = found->query,
                            .seconds = found->seconds};
  }
  return slowest;
}

std::optional<PicturedQuery> slowest_of(const PeerResults& peers) {
  std::optional<PicturedQuery> slowest;
  for (const PlannerQuery& q : peers.queries) {
    if (q.answers.empty() || (slowest && slowest->seconds >= q.answers.front().seconds)) continue;
    slowest = PicturedQuery{
        .title = {}, .vehicle = q.setting, .world = q.world, .query = q.query, .seconds = q.answers.front().seconds};
  }
  return slowest;
}

/// The catalog's world that a benchmark of quality names: "car/convex_f30" is among 100 convex obstacles that cover 0.3
/// of the map. Empty for other names.
std::string world_of(const Measurement& m) {
  if (const auto labeled = bench::slowest_query_of(m.label)) return labeled->world;
  const std::string name = place_of(m.name).variant, world = name.substr(name.find('/') + 1);
  for (const std::string kind : {"convex", "star"})
    if (world.starts_with(kind + "_f"))
      return "clutter/" + kind + "/n100/m10/f" + world.substr(kind.size() + 2) + "/s1";
  return {};
}

}  // namespace

std::string lead_paragraph(const Inputs& inputs, const std::vector<Study>& studies) {
  std::string text = kWhat + planned_text(total_quality(inputs.results)) + growth_text(studies);
  if (inputs.peers)
    for (const std::string& sentence : {planner_comparison(*inputs.peers), duel_comparison(*inputs.peers)})
      if (!sentence.empty()) text += " " + sentence;
  return text;
}

std::vector<PicturedQuery> pictured_queries(const Inputs& inputs) {
  std::vector<PicturedQuery> pictured;
  std::vector<const Measurement*> quality = of_stage(inputs.results, "Quality");
  const auto rank = [](const Measurement* m) {
    // A car is what most people have driven.
    const std::string name = place_of(m->name).variant;
    return name.starts_with("car/") ? 0 : vehicle_rank(name) + 1;
  };
  std::ranges::stable_sort(quality, {}, rank);
  if (!quality.empty())
    if (const std::string world = world_of(*quality.front()); !world.empty())
      pictured.push_back({.title = "A plan",
                          .vehicle = vehicle_of(place_of(quality.front()->name).variant),
                          .world = world,
                          .any = true});
  std::optional<PicturedQuery> slowest = slowest_of(inputs.results);
  if (inputs.peers)
    if (const auto other = slowest_of(*inputs.peers); other && (!slowest || other->seconds > slowest->seconds))
      slowest = other;
  if (slowest) {
    slowest->title = "The slowest query";
    pictured.push_back(*slowest);
  }
  return pictured;
}

}  // namespace arcway::internal::report
