#include "bench/cli/study_input.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/file_io.h"
#include "arcway/datasets/paper_example.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/datasets/robot.h"
#include "core/base/shortest_text.h"
#include "datasets/io/json_text.h"

namespace arcway::internal::cli {
namespace {

constexpr std::string_view kFormat = "arcway-benchmark";
constexpr std::uint64_t kMostRepetitions = 1000;

/// A name of results, whose parts are parted by slashes, and a size by a colon: "Plan/car/n:10".
std::string without_signs(std::string name, std::string_view signs) {
  std::ranges::replace_if(
      name, [&](char c) { return signs.find(c) != std::string_view::npos; }, '_');
  return name;
}

/// The name of a file without its folder and endings: "yard" of "maps/yard.geojson.gz".
std::string stem_of(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.', 1));
}

/// `name`, with a number behind it if others have it.
template <class Named>
std::string unique_name(const std::string& name, const std::vector<Named>& others) {
  std::string unique = name;
  for (int number = 2; std::ranges::find(others, unique, &Named::name) != others.end(); ++number)
    unique = name + "-" + std::to_string(number);
  return unique;
}

bool is_count(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// A file that a scenario names, or a name of the catalog.
std::string beside(const std::filesystem::path& scenario, const std::string& name) {
  const std::filesystem::path file = scenario.parent_path() / name;
  return !std::filesystem::exists(file) && is_catalog_name(name) ? name : file.string();
}

StudyInput::Robot robot_of(const detail::JsonPlace& place, const std::filesystem::path& scenario, std::size_t number) {
  if (place.value.is_string()) return read_studied_robot(beside(scenario, place.string()));
  if (!place.value.is_object()) place.expected("a robot or the name of its file");
  try {
    return {"robot" + std::to_string(number), Vehicle(read_robot(place.value.dump(), place.path))};
  } catch (const std::invalid_argument& error) {
    place.fail(error.what());
  }
}

std::uint64_t count_of(const detail::JsonPlace& place) {
  if (!place.value.is_number_unsigned()) place.expected("a whole number >= 0");
  return place.value.get<std::uint64_t>();
}

bool flag_of(const detail::JsonPlace& place) {
  if (!place.value.is_boolean()) place.expected("true or false");
  return place.value.get<bool>();
}

std::vector<PlanRequest> random_requests(const StudyInput& input, const Planner& planner) {
  try {
    return random_queries(planner.world(), planner.queries(), planner.vehicle(),
                          {.count = parse_count(input.queries, "--queries"), .seed = input.seed});
  } catch (const std::runtime_error& error) {
    throw UsageError(std::string(error.what()) + "; the robot may be too large, or the map have no bounds and little " +
                     "free space within its box; --queries Q.csv takes poses of your own");
  }
}

/// The queries of a file; each must begin and end at a free pose.
std::vector<PlanRequest> checked_requests(const StudyInput& input, const std::vector<NumberedRequest>& queries,
                                          const Planner& planner) {
  std::vector<PlanRequest> requests;
  for (const auto& [q, request] : queries) {
    if (!planner.is_free(request.start) || !planner.is_free(request.goal))
      throw UsageError("query " + std::to_string(q) + " of " + input.queries + ": " + planner.plan(request).reason +
                       "; leave it out, or move it");
    requests.push_back(request);
  }
  return requests;
}

/// The queries of a file as it has them; none if the input names no file.
std::vector<NumberedRequest> given_queries(const StudyInput& input, std::string& notes) {
  if (is_count(input.queries)) return {};
  std::vector<std::string> warnings;
  std::vector<NumberedRequest> queries = read_queries(input.queries, warnings);
  for (const std::string& warning : warnings) notes += row("warning", warning);
  if (queries.empty()) throw UsageError(input.queries + " has no queries");
  return queries;
}

}  // namespace

void StudyInput::check() const {
  if (is_count(queries) && parse_count(queries, "--queries") == 0)
    throw UsageError("--queries: at least 1, got \"" + queries + "\"");
  if (!(time_limit > 0.0)) throw UsageError("--time-limit: above 0 s, got \"" + shortest_text(time_limit) + "\"");
  if (repetitions < 1 || repetitions > kMostRepetitions)
    throw UsageError("--repetitions: 1 to " + std::to_string(kMostRepetitions) + ", got \"" +
                     std::to_string(repetitions) + "\"");
  if (!(peer_time >= 0.0)) throw UsageError("--peer-time: at least 0 s, got \"" + shortest_text(peer_time) + "\"");
}

StudyInput::Robot read_studied_robot(const std::string& file) {
  return {file.empty() ? "paper" : without_signs(stem_of(file), "/:,\""), load_vehicle(file)};
}

bool is_study_file(const std::filesystem::path& file) {
  if (file.extension() != ".json" || !std::filesystem::is_regular_file(file)) return false;
  return read_file(file).find("\"" + std::string(kFormat) + "\"") != std::string::npos;
}

StudyInput read_study_file(const std::filesystem::path& file) {
  const nlohmann::json value =
      detail::parse_json(read_file(file), file.string(), nullptr, 1, detail::RepeatedKeys::kRefused);
  const detail::JsonPlace place{value, file.string()};
  place.allow_keys(
      {"format", "version", "maps", "robots", "queries", "seed", "reverse", "time_limit", "repetitions", "peer_time"});
  place.require_format(kFormat, 1);
  StudyInput input;
  const detail::JsonPlace maps = place.at("maps");
  maps.require_array();
  if (maps.value.empty()) maps.fail("names no map");
  for (std::size_t i = 0; i < maps.value.size(); ++i) input.maps.push_back(beside(file, maps.at(i).string()));
  if (place.has("robots")) {
    const detail::JsonPlace robots = place.at("robots");
    robots.require_array();
    for (std::size_t i = 0; i < robots.value.size(); ++i) input.robots.push_back(robot_of(robots.at(i), file, i + 1));
  }
  if (place.has("queries")) {
    const detail::JsonPlace queries = place.at("queries");
    if (queries.value.is_string()) {
      input.queries = (file.parent_path() / queries.string()).string();
    } else {
      input.queries = std::to_string(count_of(queries));
    }
  }
  if (place.has("seed")) input.seed = count_of(place.at("seed"));
  if (place.has("reverse")) input.reverse = flag_of(place.at("reverse"));
  if (place.has("time_limit")) input.time_limit = place.at("time_limit").number();
  if (place.has("repetitions")) input.repetitions = count_of(place.at("repetitions"));
  if (place.has("peer_time")) input.peer_time = place.at("peer_time").number();
  return input;
}

bench::MapStudy make_study(const StudyInput& input, const MapOptions& reading, std::string& notes) {
  input.check();
  bench::MapStudy study;
  study.repetitions = static_cast<int>(input.repetitions);
  study.time_limit = input.time_limit;
  for (const std::string& name : input.maps) {
    LoadedMap map = load_map(name, reading);
    const bool in_catalog = !std::filesystem::exists(name) && is_catalog_name(name);
    const std::string label = name == "-" ? "standard_input" : in_catalog ? name : stem_of(name);
    study.maps.push_back({unique_name(without_signs(label, ":,\""), study.maps), std::move(map.world)});
    if (const std::string rows = warning_rows(map); !rows.empty()) notes += row("map", name) + rows;
  }
  for (const StudyInput::Robot& robot : input.robots) {
    study.robots.push_back({unique_name(robot.name, study.robots), robot.vehicle});
    for (const std::string& warning : vehicle_warnings(robot.vehicle)) notes += row("warning", warning);
  }
  const std::vector<NumberedRequest> given = given_queries(input, notes);
  const BuildOptions build;
  const auto executor = build.executor();
  for (std::size_t m = 0; m < study.maps.size(); ++m)
    for (std::size_t r = 0; r < study.robots.size(); ++r) try {
        const World& world = study.maps[m].world;
        const Planner planner(world, study.robots[r].vehicle, build.backend_for(world, *executor, kSingleProcess),
                              {.graph_mode = GraphMode::kLazy});
        study.cases.push_back(
            {m, r, given.empty() ? random_requests(input, planner) : checked_requests(input, given, planner)});
        for (PlanRequest& request : study.cases.back().requests) request.reverse = input.reverse;
      } catch (const std::exception& error) {
        throw UsageError(study.maps[m].name + " for " + study.robots[r].name + ": " + error.what());
      }
  return study;
}

}  // namespace arcway::internal::cli
