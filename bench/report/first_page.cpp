#include "bench/report/first_page.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "bench/report/least_queries.h"
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

/// What all benchmarks of quality found together.
struct QualityTotal {
  double queries = 0.0, solved = 0.0;
  std::set<std::size_t> ranks;  // of the vehicles
  std::vector<double> seconds, over_bound;
};

QualityTotal total_quality(const Results& results) {
  QualityTotal total;
  for (const Measurement* m : of_stage(results, "Quality")) {
    const double solved = solved_queries(*m);
    if (!(solved > 0.0)) continue;
    total.queries += m->counters.at("queries");
    total.solved += solved;
    total.ranks.insert(vehicle_rank(place_of(m->name).variant));
    if (solved < kLeastQueries) continue;
    for (const auto& [name, values] :
         {std::pair("plan_seconds_median", &total.seconds), std::pair("time_over_bound_median", &total.over_bound)})
      if (const auto found = m->counters.find(name); found != m->counters.end()) values->push_back(found->second);
  }
  return total;
}

/// "5 real vehicles and the robot of the paper behind the method"
std::string vehicles_text(const std::set<std::size_t>& ranks) {
  const std::size_t paper = bench::real_vehicles().size(), real = ranks.size() - ranks.count(paper);
  const std::string vehicles = real == 0 ? "" : real == 1 ? "a real vehicle" : std::to_string(real) + " real vehicles";
  if (!ranks.contains(paper)) return vehicles;
  return (vehicles.empty() ? "" : vehicles + " and ") + "the robot of the paper behind the method";
}

std::string planned_text(const QualityTotal& total) {
  if (!(total.queries > 0.0)) return {};
  std::string text = " Here it solved " + count_text(total.solved) + " of " + count_text(total.queries) +
                     " random tasks (" + number_text("%.0f", 100.0 * total.solved / total.queries) + " %) for " +
                     vehicles_text(total.ranks) + "; an independent check accepted every path.";
  if (total.seconds.empty() || total.over_bound.empty()) return text;
  const auto [low, high] = std::ranges::minmax(total.seconds);
  const auto [best, worst] = std::ranges::minmax(total.over_bound);
  const auto percent = [](double ratio) { return number_text("%.1f", 100.0 * (ratio - 1.0)); };
  return text + " Once a map is prepared, a plan takes " + range_text(low, high, time_text) +
         " of processor time, and the drive lasts " + range_text(best, worst, percent) +
         " % longer than a bound that nothing can beat (medians, by vehicle and map).";
}

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
    const std::string name = place_of(m->name).variant;
    slowest = PicturedQuery{.title = {},
                            .vehicle = name.substr(0, name.find('/')),
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

/// The vehicle and world of a benchmark of quality: "car/convex_f30" is a car among 100 convex obstacles that cover 0.3
/// of the map.
std::optional<PicturedQuery> plan_of(const Measurement& m) {
  const std::string name = place_of(m.name).variant;
  const std::size_t slash = name.find('/');
  const std::string world = slash == std::string::npos ? name : name.substr(slash + 1);
  const std::size_t fill = world.find("_f");
  if (fill == std::string::npos) return std::nullopt;
  const std::optional<bench::SlowestQuery> labeled = bench::slowest_query_of(m.label);
  return PicturedQuery{
      .title = "A plan",
      .vehicle = slash == std::string::npos ? "" : name.substr(0, slash),
      .world = labeled ? labeled->world
                       : "clutter/" + world.substr(0, fill) + "/n100/m10/f" + world.substr(fill + 2) + "/s1",
      .any = true};
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
    if (const auto plan = plan_of(*quality.front())) pictured.push_back(*plan);
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
