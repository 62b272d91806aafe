#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/attach/per_circle.h"
#include "core/attach/search_attachments.h"
#include "core/attach/search_context.h"
#include "core/base/open_list.h"
#include "core/search/backward_reachable_set.h"

namespace arcway::internal {

/// Decides whether any path of the graph leads from the starts to the goals, without times and speeds:
/// 1. It walks over all that the starts reach, nearest to the goal first.
/// 2. If that is thousands of arcs, it computes the goal's backward-reachable set, which is small in a dead end. It
///    does not on lazy graphs of hundreds of thousands of circles.
///
/// The next question, about other starts and goals, continues from what is known.
class Reachability {
 public:
  /// Forgets all that starts have reached.
  void forget();
  /// Whether a path exists. What starts have reached counts as reached until forgotten, so that all starts must be of
  /// one pose on one map. True also if the search was interrupted before that was known. Fills in the result's
  /// start_connected and start_is_open.
  bool goal_is_reachable(SearchContext& context, SearchAttachments& attachments);

 private:
  // A part of a circle that some path turns on, at any time and speed.
  struct Arc {
    double heading;      // of the arrival
    double reach;        // of the free interval
    std::uint32_t next;  // on the same circle
  };
  // An arrival on a circle that waits for its turn.
  struct Arrival {
    double distance;       // to the goal
    std::uint32_t circle;  // the circle that the link leaves; kNone: a link of the start
    std::uint32_t index;
    // Links of the start come last among equals.
    friend bool before(const Arrival& a, const Arrival& b) {
      if (a.distance != b.distance) return a.distance < b.distance;
      return a.circle != b.circle ? a.circle < b.circle : a.index < b.index;
    }
  };
  struct Place {
    std::uint32_t circle;
    double heading;
  };

  bool goal_is_in_dead_end();
  bool has_links_to(const CircleTable& circles);
  bool start_leads_to(const std::vector<Departure>& backward_set);
  [[nodiscard]] Place place_of(std::uint32_t circle, std::uint32_t index) const;
  void push(std::uint32_t circle, std::uint32_t index);
  // Whether a goal link leaves a part of a circle that is known to be reached.
  bool is_known(SearchAttachments::GoalLink& goal);
  bool reaches_goal(const Arrival& arrival);

  SearchContext* context_ = nullptr;
  SearchAttachments* attachments_ = nullptr;
  OpenList<Arrival> open_;
  std::vector<Arc> arcs_;
  PerCircle first_arc_;
};

}  // namespace arcway::internal
