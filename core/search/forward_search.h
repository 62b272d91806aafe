#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/attach/fast_attachments.h"
#include "core/attach/maneuvers.h"
#include "core/attach/narrow_places.h"
#include "core/search/arrival_search.h"

namespace arcway::internal {

/// What stands in the way.
enum class Obstruction {
  kNothing,
  kStart,      ///< nothing leads from the start, or from the poses reached from it, to a circle of the graph
  kGoal,       ///< nothing leads from a circle of the graph to the goal, or to poses from which it is reached
  kBetween,    ///< the graph joins neither to the other
  kBottleneck  ///< the widest route is too narrow, which proves that there is no path
};

/// A path that one step of a search found, if any, and what the step took.
struct FoundPath {
  SearchResult search;             ///< counters of the step
  std::size_t maneuver_poses = 0;  ///< tried in the step
};

/// Memory of searches, kept for the next one.
struct FindWorkspace {
  ArrivalSearch search;
  ManeuverSearch from, to;
};

/// How one end joins the roadmap: by its own pose, by places where the vehicle is slow enough to turn, and by
/// maneuvers.
class EndAttachments {
 public:
  /// All that the end refers to must outlive this.
  EndAttachments(const MovingEnd& end, ManeuverSearch& maneuvers, const StopClock& clock);
  EndAttachments(const EndAttachments&) = delete;

  /// Adds maneuvers in place of those before; returns their number, the end's own pose included.
  std::size_t find(const ManeuverPoses& poses);
  [[nodiscard]] std::span<const Attachment> all() const { return all_; }

 private:
  const Roadmap& map_;
  Direction direction_;
  ManeuverSearch& maneuvers_;
  const StopClock& clock_;
  Attachment plain_;
  std::vector<Attachment> fast_;    // of an end that is too fast for the smallest turns; the first is its own pose
  std::vector<Attachment> joined_;  // these and maneuvers
  std::span<const Attachment> all_;
};

/// How many poses join the roadmap where single arcs do not.
struct ManeuverEffort {
  std::size_t first;          ///< poses close to one end, before all that are allowed are tried
  std::size_t sparse_factor;  ///< sparse poses in the end, as a multiple of those that are allowed
};

/// The fastest path between two poses on one roadmap, driven forwards. Each step tries more than those before, and
/// goes on from what they found out. Steps may be left out.
class ForwardSearch {
 public:
  struct Query {
    Pose start, goal;
    std::size_t most_poses;  ///< of maneuvers at each end
  };

  /// All arguments must outlive this.
  /// @param places  of `map`, with circles in narrow gaps; null: there are none.
  ForwardSearch(const Roadmap& map, const NarrowPlaces* places, const Query& query, const SearchOptions& options,
                FindWorkspace& workspace);

  /// Both ends join the roadmap by their own turn circles. Equal poses have an empty path.
  /// @param radii  number of radii of these circles, from the smallest on. All steps behind this one use all.
  /// @param suboptimality  of this step, see SearchOptions.
  FoundPath join_by_single_arcs(std::size_t radii, double suboptimality);
  /// The ends join the roadmap with circles in narrow gaps likewise.
  FoundPath join_by_narrow_places();
  /// Short maneuvers of several arcs lead from the ends to the roadmap: of few poses at the end that is in trouble,
  /// then of all that are allowed. Sparse ones follow at both ends, if each joins the roadmap but not the other end.
  FoundPath join_by_maneuvers(const ManeuverEffort& effort);
  /// Maneuvers lead to the roadmap with circles in narrow gaps.
  /// @param poses  of maneuvers at each end that is in trouble.
  FoundPath join_by_maneuvers_and_narrow_places(std::size_t poses);

  /// What stands in the way, as far as the last step tells that found no path.
  [[nodiscard]] Obstruction obstruction() const;
  /// Whether the path of the last step is one of the roadmap with circles in narrow gaps.
  [[nodiscard]] bool used_narrow_places() const { return used_narrow_places_; }

 private:
  // One end of a path and the poses by which it may join the graph.
  class End {
   public:
    End(const MovingEnd& end, ManeuverSearch& maneuvers, const StopClock& clock) : all_(end, maneuvers, clock) {}

    [[nodiscard]] std::span<const Attachment> attachments() const { return all_.all(); }
    // Poses close to the end, more than before; false if there are no more.
    bool extend(std::size_t first, std::size_t most);
    // More poses, in the end sparse ones; false if there are no more.
    bool extend_far(const ManeuverEffort& effort, std::size_t most);

   private:
    void find(std::size_t poses, Spread spread);

    std::size_t asked_ = 0, found_ = 1;  // poses of maneuvers
    EndAttachments all_;
  };

  // True if that ends the step: with a path, or as the time is up.
  bool search(const Roadmap& on, const End& from, const End& to, FoundPath& found);
  // More poses for the end that is in trouble; false if there are no more.
  bool extend(const ManeuverEffort& effort, FoundPath& found);
  // None where no gap is narrow, or the time is up.
  [[nodiscard]] const Roadmap* narrow_map() const;

  const Roadmap& map_;
  const NarrowPlaces* places_;
  Query query_;
  SearchOptions options_;
  FindWorkspace& workspace_;
  End from_, to_;
  bool start_connected_ = false, goal_connected_ = false, start_is_open_ = false;  // on the plain roadmap
  bool used_narrow_places_ = false;
};

/// The fastest path that may begin and end with a maneuver, out of a few sparse ones. It is faster than a path by
/// single arcs where a pose faces away from its route and there is room to turn, but slower to find.
/// @param poses  for the maneuvers of each end.
FoundPath find_path_with_maneuvers(const Roadmap& map, const ForwardSearch::Query& query, const SearchOptions& options,
                                   FindWorkspace& workspace);

}  // namespace arcway::internal
