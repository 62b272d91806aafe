#include "core/search/search_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/path/speed_profile.h"
#include "core/query/motion_free.h"

namespace arcway {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostDirectPairs = 64;

bool is_same(const Pose& a, const Pose& b) { return a.x == b.x && a.y == b.y && a.heading == b.heading; }

// Whether all poses begin with some.
bool begin_with(std::span<const Terminal> all, const std::vector<Pose>& some) {
  return some.size() <= all.size() &&
         std::ranges::equal(some, all.first(some.size()), is_same, {}, [](const Terminal& t) { return t.pose; });
}

}  // namespace

void SearchEnds::forget() {
  starts_.clear();
  goals_.clear();
  start_circles_.clear();
  goal_circles_.clear();
  start_links_.clear();
  start_link_ranges_.clear();
  goal_links_.clear();
  direct_paths_.clear();
}

bool SearchEnds::are_first_of(const SearchContext& context) const {
  return begin_with(context.starts, starts_) && begin_with(context.goals, goals_);
}

void SearchEnds::begin(SearchContext& context) {
  context_ = &context;
  longest_way_ = context.options.faster_than * context.vehicle.top_speed();
  const std::size_t known_starts = starts_.size(), known_goals = goals_.size();
  const std::size_t known_circles = start_circles_.size() + goal_circles_.size();
  const auto first_goal_circle = static_cast<std::uint32_t>(goal_circles_.size());
  if (known_goals == 0) first_goal_link_.reset(context.graph.circles().size());
  for (std::size_t s = known_starts; s < context.starts.size(); ++s) starts_.push_back(context.starts[s].pose);
  for (std::size_t g = known_goals; g < context.goals.size(); ++g) goals_.push_back(context.goals[g].pose);

  append_circles(context.map, context.starts, known_starts, Direction::kFromStart, headings_, start_circles_);
  append_circles(context.map, context.goals, known_goals, Direction::kToGoal, headings_, goal_circles_);
  context.result.turns_checked += start_circles_.size() + goal_circles_.size() - known_circles;
  start_link_ranges_.resize(start_circles_.size());
  find_direct_paths(known_starts, known_goals);
  // The goals of manoeuvres may have millions of links.
  for (std::uint32_t g = first_goal_circle; g < goal_circles_.size() && !context.interrupted(); ++g) add_goal_links(g);
}

void SearchEnds::find_direct_paths(std::size_t known_starts, std::size_t known_goals) {
  // Many terminals mean manoeuvres in a narrow place: only the plain pair of poses is worth all words there.
  if (context_->starts.size() * context_->goals.size() > kMostDirectPairs) return;
  for (std::size_t s = 0; s < context_->starts.size(); ++s)
    for (std::size_t g = s < known_starts ? known_goals : 0; g < context_->goals.size(); ++g)
      for (const double radius : context_->map.radii)
        for (const DubinsWord word : kDubinsWords) try_direct(context_->starts[s], context_->goals[g], radius, word);
}

void SearchEnds::try_direct(const Terminal& start, const Terminal& goal, double radius, DubinsWord word) {
  const auto word_path = dubins_word(word, start.pose, goal.pose, radius);
  if (!word_path) return;
  const std::span<const PathSegment> middle = word_path->segments();
  if (!std::ranges::all_of(middle, [this](const PathSegment& s) { return is_free(s); })) return;
  context_->result.start_connected = context_->result.goal_connected = true;
  Path path = start.connection;
  path.insert(path.end(), middle.begin(), middle.end());
  path.insert(path.end(), goal.connection.begin(), goal.connection.end());
  const double time = travel_cost(path, context_->vehicle, context_->options.cusp_cost);
  direct_paths_.push_back({std::move(path), time});
}

bool SearchEnds::is_free(const PathSegment& segment) {
  if (segment.is_line()) return context_->is_free({segment.start, segment.length});
  ++context_->result.turns_checked;
  return turn_free(*context_->map.queries.sweep, context_->map.body, segment, headings_);
}

SearchEnds::Range SearchEnds::links_from(std::uint32_t start_circle) {
  Range& range = start_link_ranges_[start_circle];
  if (range.first == kNone) {
    range.first = static_cast<std::uint32_t>(start_links_.size());
    const Terminal& start = context_->starts[start_circles_[start_circle].terminal];
    append_links(context_->map, start_circles_, start_circle, Direction::kFromStart,
                 {context_->goal, longest_way_ - length_of(start.connection)}, start_links_);
    range.last = static_cast<std::uint32_t>(start_links_.size());
  }
  return range;
}

void SearchEnds::add_goal_links(std::uint32_t goal_circle) {
  const Terminal& goal = context_->goals[goal_circles_[goal_circle].terminal];
  const WayLimit limit{context_->starts[0].pose.position(), longest_way_ - length_of(goal.connection)};
  if ((goal.pose.position() - limit.other_end).norm() >= limit.length) return;
  found_.clear();
  append_links(context_->map, goal_circles_, goal_circle, Direction::kToGoal, limit, found_);
  for (const TerminalLink& link : found_) {
    goal_links_.push_back({link, first_goal_link_.get(link.circle), kInfinity, false, false});
    first_goal_link_.set(link.circle, static_cast<std::uint32_t>(goal_links_.size() - 1));
  }
}

bool SearchEnds::is_free(GoalLink& goal) {
  if (!goal.checked) {
    const Bitangent& line = goal.link.line;
    goal.free = context_->graph.free_headings(goal.link.circle).contains(line.start.heading) && context_->is_free(line);
    goal.checked = true;
  }
  return goal.free;
}

}  // namespace arcway
