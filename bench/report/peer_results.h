#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/report/results.h"

namespace arcway::internal::report {

/// A duel: one task solved by arcway and by a peer in turn. Both answers were equal before the clock started.
struct Duel {
  std::string task;   ///< "reduced graph"
  std::string world;  ///< catalog name
  double vertices = 0.0;
  std::string ours, peer;
  std::vector<double> our_seconds, peer_seconds;  ///< processor time; run i of both followed one another
  std::string error;                              ///< why there are no times; empty if there are
  std::vector<double> our_wall_seconds = {},
                      peer_wall_seconds = {};  ///< wall times of these runs; some files have none
  std::size_t threads = 1;                     ///< ours; by more than one the wall times count
};

/// One planner's answer to one query.
struct PlannerAnswer {
  std::string planner;       ///< "ompl_rrtconnect 1 s"
  std::string status;        ///< "solved", or why not
  double seconds = 0.0;      ///< until the answer, processor time
  double travel_time = 0.0;  ///< from rest to rest [s]
  bool valid = false;        ///< as the validator finds
  [[nodiscard]] bool solved() const { return status == "solved"; }
};

struct PlannerQuery {
  std::string setting;  ///< what the planners were compared on: "n100"
  std::string world;
  std::size_t query = 0;
  double lower_bound = 0.0;  ///< [s]
  std::vector<PlannerAnswer> answers;
};

/// A file of comparisons with peers.
struct PeerResults {
  std::string name;  ///< name of the file
  Context context;
  std::vector<Duel> duels;
  std::vector<PlannerQuery> queries;
};

/// Whether a text is such a file, rather than Google Benchmark's.
bool is_peer_results(std::string_view json);
/// @throws FormatError naming file and place.
PeerResults read_peer_results(std::string_view json, std::string_view name);
/// One duel or query a line.
std::string peer_results_json(const PeerResults& results);

/// An earlier file with what a run found since: its duels if it has any, all queries of its settings, its context. Of
/// the earlier context stays what the run lacks, such as the version of a peer, as long as results do that go with it.
/// @param order  settings that come first, in this order; others follow as they were.
PeerResults renewed(const PeerResults& earlier, PeerResults run, std::span<const std::string> order);

/// The queries of an earlier file in a run's settings, with the run's lower bounds and answers. Answers of planners
/// that the run lacks are kept. Further queries of the run follow.
std::vector<PlannerQuery> answered_anew(std::span<const PlannerQuery> earlier, std::span<const PlannerQuery> run);

}  // namespace arcway::internal::report
