#include "bench/cli/study_peers.h"

#include <algorithm>
#include <string>
#include <vector>

#include "bench/context/context.h"
#include "bench/report/map_sections.h"
#ifdef ARCWAY_PEER_OMPL
#include "bench/peers/ompl_peer.h"
#include "bench/peers/planner_study.h"
#endif

namespace arcway::internal::cli {

#ifdef ARCWAY_PEER_OMPL

namespace {

constexpr std::size_t kQueries = 10;  // of each case; a query takes some seconds

}  // namespace

bool has_peers() { return true; }

report::PeerResults run_peers(const bench::MapStudy& study, double seconds, const bench::MapStudyProgress& progress) {
  report::PeerResults results{.name = "peers.json", .context = bench::machine_and_build(), .duels = {}, .queries = {}};
  results.context.emplace_back(peers::ompl_name(), peers::ompl_version());
  peers::seed_ompl(1);
  for (const bench::StudiedCase& c : study.cases) {
    std::vector<PlanRequest> requests = c.requests;
    requests.resize(std::min(requests.size(), kQueries));
    const bench::StudiedMap& map = study.maps[c.map];
    const bench::StudiedRobot& robot = study.robots[c.robot];
    const peers::PlannerSetting setting{.name = report::own_setting(robot.name, map.name),
                                        .worlds = {},
                                        .vehicle = robot.vehicle,
                                        .times = {seconds},
                                        .long_queries = 0,
                                        .shortest_too = false};
    const std::string what = "peers/" + robot.name + "/" + map.name;
    std::size_t done = 0;
    const peers::PlannerStudyProgress shown{
        .line = [&](const std::string&) { progress.show(what, done++, requests.size() + 1); },
        .lost = [](const std::string&) {},
        .world_done = {},
        .stop = progress.stop};
    const std::vector<report::PlannerQuery> queries =
        peers::compare_planners(setting, {map.name, map.world, requests}, shown);
    results.queries.insert(results.queries.end(), queries.begin(), queries.end());
  }
  return results;
}

#else

bool has_peers() { return false; }

report::PeerResults run_peers(const bench::MapStudy&, double, const bench::MapStudyProgress&) { return {}; }

#endif

}  // namespace arcway::internal::cli
