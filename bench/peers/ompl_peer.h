#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/exact_motion.h"
#include "datasets/io/random.h"

namespace arcway::internal::peers {

enum class OmplPlanner {
  kRrtConnect,       ///< restarted, every solution shortcut for travel time, the best one kept
  kRrtConnectWide,   ///< as kRrtConnect, with shortcuts by turns of all radii of turning_radii
  kInformedRrtStar,  ///< asymptotically optimal in length, one run
  kEitStar,          ///< of OMPL 2: effort informed trees, asymptotically optimal in length
  kBlitStar,         ///< of OMPL 2: bidirectional lazy informed trees, asymptotically optimal in length
};
/// "ompl_rrtconnect": ompl_name and the planner.
std::string name_of(OmplPlanner planner);

/// The planners that OMPL has from version 2 on; none if this build has an earlier one. AORRTC is left out: in 2.0.2 it
/// takes distances for symmetric, and reads beyond its neighbors where they are not.
std::span<const OmplPlanner> planners_of_ompl_2();

struct PeerSolution {
  Path path;
  double travel_time = 0.0;  ///< from rest to rest [s]
  double seconds = 0.0;      ///< processor time of the thread from the start of the run
};

struct PeerRun {
  std::optional<PeerSolution> first;                 ///< as the planner found it, before any shortcut
  std::vector<std::optional<PeerSolution>> at_time;  ///< the best path after each of the times asked for
};

/// Runs OMPL in its Dubins space with the smallest turning radius, the only one that it has. Motions are the shortest
/// Dubins words, decided exactly. All times are processor times of the calling thread: on a busy machine a planner gets
/// what it was promised.
/// @param first_within  gives up when there is no path by then [s].
/// @param times         ascending [s]; empty: returns at the first solution.
PeerRun run_ompl(OmplPlanner planner, const Problem& problem, double first_within, std::span<const double> times,
                 Random& random);

/// What OMPL draws comes from this seed, for all threads. To be called once, before any run.
void seed_ompl(std::uint64_t seed);

/// "ompl", from version 2 on with the number: results of two versions are told apart.
std::string ompl_name();
/// "1.5.2"
std::string ompl_version();

}  // namespace arcway::internal::peers
