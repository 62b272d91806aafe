#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/attach/attachment_links.h"
#include "core/attach/known_links.h"
#include "core/attach/per_circle.h"
#include "core/attach/search_context.h"
#include "core/base/huge_pages.h"
#include "core/model/side_radii.h"
#include "core/motion/dubins.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

/// The attachments of one search: how starts and goals join the roadmap, and each other.
class SearchAttachments {
 public:
  struct GoalLink {
    AttachmentLink link;
    double best_time;    ///< of complete paths by this link [s]; kept for the search
    std::uint32_t next;  ///< on the same circle, or kNone
    bool checked, free;
  };
  /// A Dubins word from a start attachment to a goal attachment.
  struct DirectPath {
    std::uint32_t start, goal;  ///< attachments
    DubinsPath word;            ///< between their poses
    double time;                ///< of the path with both connections [s]
  };

  /// Forgets the search before.
  void forget();
  /// Searches from now on are those of one query: they share the straights that they find.
  void begin_query() { known_links_.begin(); }
  /// Forgets the search before, and takes memory for a graph of `circles` circles.
  void warm_up(std::size_t circles);
  /// Whether the attachments of the search before are the first ones of this search.
  [[nodiscard]] bool are_first_of(const SearchContext& context) const;
  /// Finds the circles of all attachments, the free words between them and the links to the goals, unless interrupted.
  /// Results of the search before are kept, with their indices.
  void begin(SearchContext& context);

  [[nodiscard]] std::span<const AttachmentCircle> start_circles() const { return start_circles_; }
  [[nodiscard]] std::span<const AttachmentCircle> goal_circles() const { return goal_circles_; }
  [[nodiscard]] std::span<const DirectPath> direct_paths() const { return direct_paths_; }
  /// The path of a word, with both connections.
  /// @param path  receives it; its memory is used again.
  void take_path(const DirectPath& direct, Path& path) const;

  /// A range [first, last) of start links.
  struct Range {
    std::uint32_t first = kNone, last = kNone;
  };
  /// The links that leave a start circle, found by the first call. None if the clock is over before they are found.
  Range links_from(std::uint32_t start_circle);
  [[nodiscard]] const AttachmentLink& start_link(std::uint32_t index) const { return start_links_[index]; }

  [[nodiscard]] std::span<const GoalLink> goal_links() const { return goal_links_; }
  [[nodiscard]] GoalLink& goal_link(std::uint32_t index) { return goal_links_[index]; }
  /// What driving close costs from the line of a goal link on [s]; negative: not known yet. Kept apart from the links:
  /// most searches ask for none, and some have hundreds of thousands of links.
  [[nodiscard]] double& close_cost(std::uint32_t goal_link) {
    if (close_costs_.size() < goal_links_.size()) close_costs_.resize(goal_links_.size(), -1.0);
    return close_costs_[goal_link];
  }
  /// The first goal link that leaves a circle of the roadmap, or kNone; GoalLink::next gives the others.
  [[nodiscard]] std::uint32_t first_goal_link(std::uint32_t circle) const { return first_goal_link_.get(circle); }
  /// Forgets the times of paths by goal links.
  void forget_times();
  /// Prefetches the goal links of a circle of the roadmap.
  void prefetch(std::uint32_t circle) const { first_goal_link_.prefetch(circle); }
  /// Whether the link is free: its swept rectangle, and the body on the roadmap's circle where it begins. Checked once.
  bool is_free(GoalLink& goal);

 private:
  void find_direct_paths(std::size_t known_starts, std::size_t known_goals);
  void try_direct(std::uint32_t start, std::uint32_t goal, const SideRadii& radii, DubinsWord word);
  bool is_free(const PathSegment& segment);
  void add_goal_links(std::uint32_t goal_circle);
  // Appends the links of a circle, known ones if there are some. False if the clock is over before they are found.
  bool append_links(Direction direction, std::uint32_t circle, const LengthLimit& limit,
                    HugeVector<AttachmentLink>& links);

  SearchContext* context_ = nullptr;
  double longest_path_ = 0.0;                               // longest path that is wanted [m]
  std::size_t most_start_links_ = 0, most_goal_links_ = 0;  // for each circle of a maneuver
  HeadingSet headings_;                                     // memory
  AttachmentLinks links_;                                   // memory
  KnownLinks known_links_;
  std::vector<Pose> starts_, goals_;
  std::vector<AttachmentCircle> start_circles_, goal_circles_;
  HugeVector<AttachmentLink> start_links_, found_;
  std::vector<Range> start_link_ranges_;  // by start circle; kNone: not found yet
  HugeVector<GoalLink> goal_links_;
  std::vector<double> close_costs_;  // by goal link, as far as asked for
  PerCircle first_goal_link_;
  std::vector<DirectPath> direct_paths_;
  Path path_;             // memory
  SpeedProfile profile_;  // memory
};

}  // namespace arcway::internal
