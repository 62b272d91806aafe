#include "bench/report/words.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "bench/robots.h"

namespace arcway::internal::report {
namespace {

using Words = std::pair<std::string_view, const char*>;

constexpr Words kStages[] = {
    {"Ablation", "Plans with parts of the planner switched off"},
    {"Bitangents", "Lines that touch two circles"},
    {"Change", "A prepared map after obstacles moved"},
    {"CheckMap", "Checking a map"},
    {"ClosestPoints", "Nearest obstacle points"},
    {"Driven", "Worlds in which a path is known"},
    {"Dynobench", "A problem of dynobench"},
    {"FeasibleGraph", "Feasible graph: all links checked"},
    {"FirstPlan", "The README's own lines"},
    {"FullGraph", "Full visibility graph"},
    {"LinesOfSight", "Lines of sight"},
    {"Live", "A drive through a map that changes"},
    {"LoadMap", "Reading and checking a map"},
    {"PairwiseThreads", "Visibility graph by pairs of obstacles, on threads"},
    {"PathClearance", "Clearance along a path"},
    {"Plan", "Plans of the paper's robot"},
    {"PlanBatch", "Batches of plans, on threads"},
    {"PlanBody", "Plans of bodies that are no rectangles"},
    {"PlanEach", "Plans one by one, the slow ones above all"},
    {"PlanFirst", "First plans of real vehicles, on a new map"},
    {"PlanPrepared", "Plans of real vehicles, on a prepared map"},
    {"PlanRadii", "Plans with circles of several radii"},
    {"PlanZones", "Plans through zones that limit the speed"},
    {"Predicates", "Exact orientation of three points"},
    {"Quality", "Quality of the plans"},
    {"Radii", "Travel time by the number of radii"},
    {"RayBatches", "Batches of lines of sight, on threads"},
    {"RayPackets", "Lines of sight in packets"},
    {"Rays", "Lines of sight beside Embree alone"},
    {"RealMap", "Real maps"},
    {"ReducedGraph", "Reduced visibility graph"},
    {"Reversing", "Parking in both gears"},
    {"Search", "Search with each heuristic"},
    {"SpeedProfile", "Speed profile of a path"},
    {"Strategy", "The strategy without each of its rows"},
    {"SweptRectangles", "Swept rectangles"},
    {"Tangents", "Tangents of two obstacles"},
    {"TangentConeGraph", "Visibility graph by tangent cones"},
    {"TangentConeStages", "Stages of the tangent-cone builder"},
    {"TimeLimit", "How well time limits are kept"},
    {"TraceGrid", "Outlines of a grid map"},
    {"TurningIntervals", "Free headings on a turn circle"},
    {"VisibilityMap", "What is visible from a point"},
};

constexpr Words kKeys[] = {
    {"cells", "number of grid cells"},
    {"fill_percent", "percent of the map that obstacles cover"},
    {"hertz", "cycles a second"},
    {"moved", "number of moved obstacles"},
    {"obstacles", "number of obstacles"},
    {"percent_of_side", "distance, in percent of the map's side"},
    {"radii", "number of turning radii"},
    {"room_cm", "room beyond the car's size [cm]"},
    {"segments", "number of path segments"},
    {"threads", "number of threads"},
    {"vertices", "vertices of each obstacle"},
    {"vertices_of_each", "vertices of each obstacle"},
};

constexpr Words kSettings[] = {
    {"n100", "the paper's robot, 100 obstacles"},
    {"n1000", "the paper's robot, 1,000 obstacles"},
};

constexpr Words kPlanners[] = {
    {"arcway_tightest", "arcway, tightest turns only"},
    {"ompl_rrtconnect", "OMPL's RRTConnect"},
    {"ompl_rrtconnect_wide", "OMPL's RRTConnect with wide turns"},
    {"ompl_informed_rrtstar", "OMPL's Informed RRT*"},
    {"ompl2_eitstar", "OMPL's EIT*"},
    {"ompl2_blitstar", "OMPL's BLIT*"},
};

template <std::size_t kSize>
const char* find(const Words (&table)[kSize], std::string_view name) {
  const auto found = std::ranges::find(table, name, &Words::first);
  return found == std::end(table) ? nullptr : found->second;
}

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

}  // namespace

std::string stage_words(std::string_view stage) {
  if (const char* words = find(kStages, stage)) return words;
  std::string text;
  for (const char c : stage) {
    const bool begins = is_upper(c) && !text.empty();
    text += begins ? std::string(" ") + lower(c) : std::string(1, c);
  }
  return text;
}

std::string key_words(std::string_view key) {
  if (const char* words = find(kKeys, key)) return words;
  return counter_words(key);
}

std::string counter_words(std::string_view counter) {
  std::string text(counter);
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string setting_words(std::string_view setting) {
  if (const char* words = find(kSettings, setting)) return words;
  for (const bench::KeptVehicle& kept : bench::real_vehicles())
    if (kept.name == setting) return std::string(kept.what) + ", 100 obstacles";
  for (const bench::GentleRobot& robot : bench::kGentleRobots)
    if (robot.name() == setting)
      return "the paper's robot with at most " + std::to_string(robot.lateral_acceleration) + " m/s² sideways and " +
             std::to_string(robot.acceleration) + " along, 100 obstacles";
  return std::string(setting);
}

std::string planner_words(std::string_view planner) {
  const std::size_t space = planner.find(' ');
  const char* words = find(kPlanners, planner.substr(0, space));
  if (words == nullptr) return std::string(planner);
  return words + (space == std::string_view::npos ? std::string() : ", " + std::string(planner.substr(space + 1)));
}

std::string anchor_of(std::string_view title) {
  std::string anchor;
  for (const char c : title) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      anchor += lower(c);
    } else if (!anchor.empty() && anchor.back() != '-') {
      anchor += '-';
    }
  }
  while (anchor.ends_with('-')) anchor.pop_back();
  return anchor;
}

}  // namespace arcway::internal::report
