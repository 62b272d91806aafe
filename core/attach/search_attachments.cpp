#include "core/attach/search_attachments.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "arcway/stop_clock.h"
#include "core/base/infinity.h"
#include "core/collision/motion_free.h"
#include "core/collision/path_cost.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

namespace {
constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMostDirectPairs = 64;
// Number of straights between the poses of maneuvers at one end and the roadmap: this many, or half as many as vertices
// if that is more. Each circle of a pose has at least kLeastLinks. A straight takes 48 bytes at the start, 64 at the
// goal. In open places 400 poses see millions of circles. Among 20,000 cells that touch at corners, links took 1.2 GB
// without this limit, now 8 MB.
constexpr std::size_t kLinksOfPoses = 1 << 16;
constexpr std::size_t kVerticesALink = 2;
constexpr std::size_t kLeastLinks = 2;
constexpr double kTimeRounding = 1e-9;  // share of a time that rounding may change

bool is_same_pose(const Pose& a, const Pose& b) { return a.x == b.x && a.y == b.y && a.heading == b.heading; }

// Number of straights by which each new circle of a maneuver may join the roadmap. Together they take half of what is
// left.
std::size_t links_a_circle(std::size_t vertices, std::size_t known_links, std::size_t new_circles) {
  const std::size_t most = std::max(kLinksOfPoses, vertices / kVerticesALink);
  const std::size_t left = most - std::min(most, known_links);
  return std::max(kLeastLinks, left / 2 / std::max<std::size_t>(new_circles, 1));
}

// Upper bound on the length of paths that are wanted [m]. Precondition: no end speed is negative.
double longest_path(const SearchContext& context) {
  const SearchOptions& options = context.options;
  const double time = options.faster_than * (1.0 + kTimeRounding), top = context.vehicle.top_speed();
  if (options.time_model != TimeModel::kProfile) return time * top;
  const double a = context.vehicle.max_acceleration();
  return longest_motion(time, options.ends.start, top, options.ends.goal, a);
}

// Whether the poses of `all` begin with `some`.
bool begin_with(std::span<const Attachment> all, const std::vector<Pose>& some) {
  return some.size() <= all.size() &&
         std::ranges::equal(some, all.first(some.size()), is_same_pose, {}, [](const Attachment& t) { return t.pose; });
}

}  // namespace

void SearchAttachments::forget() {
  starts_.clear();
  goals_.clear();
  start_circles_.clear();
  goal_circles_.clear();
  start_links_.clear();
  start_link_ranges_.clear();
  goal_links_.clear();
  close_costs_.clear();
  direct_paths_.clear();
}

void SearchAttachments::forget_times() {
  for (GoalLink& goal : goal_links_) goal.best_time = kInfinity;
}

void SearchAttachments::warm_up(std::size_t circles) {
  forget();
  first_goal_link_.warm_up(circles);
}

bool SearchAttachments::are_first_of(const SearchContext& context) const {
  return begin_with(context.starts, starts_) && begin_with(context.goals, goals_);
}

void SearchAttachments::begin(SearchContext& context) {
  context_ = &context;
  longest_path_ = longest_path(context);
  const std::size_t known_starts = starts_.size(), known_goals = goals_.size();
  const auto first_start_circle = start_circles_.size();
  const auto first_goal_circle = static_cast<std::uint32_t>(goal_circles_.size());
  if (known_goals == 0) first_goal_link_.reset(context.graph.circles().size());
  for (std::size_t s = known_starts; s < context.starts.size(); ++s) starts_.push_back(context.starts[s].pose);
  for (std::size_t g = known_goals; g < context.goals.size(); ++g) goals_.push_back(context.goals[g].pose);

  const StopClock& clock = context.options.clock;
  const std::size_t radii = context.options.end_radii;
  links_.append_circles({context.map, Direction::kFromStart, radii, clock}, context.starts, known_starts,
                        start_circles_);
  links_.append_circles({context.map, Direction::kToGoal, radii, clock}, context.goals, known_goals, goal_circles_);
  const std::size_t new_starts = start_circles_.size() - first_start_circle;
  const std::size_t new_goals = goal_circles_.size() - first_goal_circle;
  context.result.counts.turns_checked += new_starts + new_goals;
  start_link_ranges_.resize(start_circles_.size());
  const std::size_t vertices = context.map.world.vertices().size();
  most_start_links_ = links_a_circle(vertices, start_links_.size(), new_starts);
  most_goal_links_ = links_a_circle(vertices, goal_links_.size(), new_goals);
  find_direct_paths(known_starts, known_goals);
  for (std::uint32_t g = first_goal_circle; g < goal_circles_.size() && !context.interrupted(); ++g) add_goal_links(g);
}

void SearchAttachments::find_direct_paths(std::size_t known_starts, std::size_t known_goals) {
  const auto starts = static_cast<std::uint32_t>(context_->starts.size());
  const auto goals = static_cast<std::uint32_t>(context_->goals.size());
  const bool are_many = context_->starts.size() * context_->goals.size() > kMostDirectPairs;
  for (std::uint32_t s = 0; s < starts; ++s)
    for (auto g = static_cast<std::uint32_t>(s < known_starts ? known_goals : 0); g < goals; ++g) {
      const bool plain_start = context_->starts[s].connection.empty();
      const bool plain_goal = context_->goals[g].connection.empty();
      if (context_->interrupted()) return;
      // A path around nothing needs a maneuver at one end only; with many, pairs of maneuvers are skipped.
      if (are_many && !plain_start && !plain_goal) continue;
      const bool few_radii = are_many && !(plain_start && plain_goal);
      const CircleRadii& radii = context_->map.radii;
      const double tightest = std::max(context_->starts[s].tightest, context_->goals[g].tightest);
      for (std::size_t k = 0; k < (few_radii ? 1 : radii.size()); ++k) {
        const SideRadii allowed = radii[k].no_less_than(tightest);
        const bool is_known = k > 0 && allowed == radii[k - 1].no_less_than(tightest);
        if (is_known || tightest == kInfinity) continue;
        for (const DubinsWord word : kDubinsWords) try_direct(s, g, allowed, word);
      }
    }
}

void SearchAttachments::try_direct(std::uint32_t start, std::uint32_t goal, const SideRadii& radii, DubinsWord word) {
  const Attachment& from = context_->starts[start];
  const Attachment& to = context_->goals[goal];
  const auto between = dubins_word(word, from.pose, to.pose, radii);
  if (!between) return;
  double length = length_of(from.connection) + length_of(to.connection);
  for (const PathSegment& segment : between->segments()) length += segment.length;
  if (length >= longest_path_) return;
  // Lines first: they are longer, and cheaper to check.
  for (const bool lines : {true, false})
    for (const PathSegment& segment : between->segments())
      if (segment.is_line() == lines && !is_free(segment)) return;
  context_->result.start_connected = context_->result.goal_connected = true;
  direct_paths_.push_back({start, goal, *between, 0.0});
  take_path(direct_paths_.back(), path_);
  const SearchOptions& options = context_->options;
  const Roadmap& map = context_->map;
  direct_paths_.back().time =
      path_cost(path_, context_->vehicle,
                {options.ends, map.speed_zones.get(), map.clearance_cost.get(), options.cusp_cost}, profile_);
  if (direct_paths_.back().time == kInfinity) direct_paths_.pop_back();
}

void SearchAttachments::take_path(const DirectPath& direct, Path& path) const {
  path = context_->starts[direct.start].connection;
  const std::span<const PathSegment> between = direct.word.segments();
  path.insert(path.end(), between.begin(), between.end());
  const Path& after = context_->goals[direct.goal].connection;
  path.insert(path.end(), after.begin(), after.end());
}

bool SearchAttachments::is_free(const PathSegment& segment) {
  if (segment.is_line()) return context_->is_free({segment.start, segment.length});
  ++context_->result.counts.turns_checked;
  return turn_free(*context_->map.queries.sweep, context_->map.body, segment, headings_);
}

SearchAttachments::Range SearchAttachments::links_from(std::uint32_t start_circle) {
  Range& range = start_link_ranges_[start_circle];
  if (range.first == kNone) {
    const auto first = static_cast<std::uint32_t>(start_links_.size());
    const Attachment& start = context_->starts[start_circles_[start_circle].attachment];
    const LengthLimit limit{context_->goal, longest_path_ - length_of(start.connection),
                            start.connection.empty() ? kUnlimited : most_start_links_};
    if (append_links(Direction::kFromStart, start_circle, limit, start_links_))
      range = {first, static_cast<std::uint32_t>(start_links_.size())};
  }
  return range;
}

void SearchAttachments::add_goal_links(std::uint32_t goal_circle) {
  const Attachment& goal = context_->goals[goal_circles_[goal_circle].attachment];
  const LengthLimit limit{context_->starts[0].pose.position(), longest_path_ - length_of(goal.connection),
                          goal.connection.empty() ? kUnlimited : most_goal_links_};
  if ((goal.pose.position() - limit.other_end).norm() >= limit.length) return;
  found_.clear();
  if (!append_links(Direction::kToGoal, goal_circle, limit, found_)) return;
  StopTicker ticker(context_->options.clock);
  for (const AttachmentLink& link : found_) {
    if (ticker.is_over()) {
      context_->result.interrupted = true;
      return;
    }
    goal_links_.push_back({link, kInfinity, first_goal_link_.get(link.circle), false, false});
    first_goal_link_.set(link.circle, static_cast<std::uint32_t>(goal_links_.size() - 1));
  }
}

bool SearchAttachments::append_links(Direction direction, std::uint32_t circle, const LengthLimit& limit,
                                     HugeVector<AttachmentLink>& links) {
  const PathEnd end{.map = context_->map, .direction = direction, .clock = context_->options.clock};
  const auto& circles = direction == Direction::kFromStart ? start_circles_ : goal_circles_;
  if (known_links_.append(end, circles[circle], limit, circle, links)) return true;
  const std::size_t first = links.size();
  if (!links_.append_links(end, circles, circle, limit, links)) {
    context_->result.interrupted = true;
    return false;
  }
  known_links_.keep(end, circles[circle], limit, links, first);
  return true;
}

bool SearchAttachments::is_free(GoalLink& goal) {
  if (!goal.checked) {
    const Bitangent& line = goal.link.line;
    goal.free = context_->graph.free_headings(goal.link.circle).contains(line.start.heading) && context_->is_free(line);
    goal.checked = true;
  }
  return goal.free;
}

}  // namespace arcway::internal
