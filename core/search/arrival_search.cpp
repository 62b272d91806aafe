#include "core/search/arrival_search.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "core/attach/circle_table.h"
#include "core/attach/search_attachments.h"
#include "core/attach/search_context.h"
#include "core/attach/walk_links.h"
#include "core/base/infinity.h"
#include "core/base/open_list.h"
#include "core/base/prefetch.h"
#include "core/geometry/quick_direction.h"
#include "core/motion/speed_profile.h"
#include "core/search/arrival_labels.h"
#include "core/search/arrival_path.h"
#include "core/search/goal_cost.h"
#include "core/search/reachability.h"
#include "core/search/search_times.h"

namespace arcway::internal {

namespace {
constexpr std::size_t kLong = 256;            // number of labels of a long search: more than most searches take
constexpr std::size_t kManyLabels = 1 << 14;  // number of labels that a warm workspace has room for
// Weight that a prefetch search adds to the heuristic. With less, it finds what the search finds at the same moment.
// With more, it leaves out more that will be asked for.
constexpr double kPrefetchHaste = 0.003;
// Share by which an estimate that knows places may exceed one that does not and counts as the same.
constexpr double kSameEstimate = 1e-12;
// Number of paths whose memory is kept: a query holds back one while it looks for others.
constexpr std::size_t kPaths = 2;
// Number of entries at the top of the open list: of its first two levels, and of three.
constexpr std::size_t kNext = 5, kSoon = 21;

enum class Kind : std::uint8_t { kDirect, kGoal, kGraph, kStart, kStartCircle };  // complete paths first on ties

// An entry of the open list, in 16 bytes. Equal estimates come off in the order in which they were pushed.
struct Entry {
  Entry() = default;
  Entry(double e, Kind kind, std::size_t index)
      : estimate(e), what((std::uint64_t{static_cast<std::uint8_t>(kind)} << 61) | index) {}
  [[nodiscard]] Kind kind() const { return static_cast<Kind>(what >> 61); }
  [[nodiscard]] std::size_t index() const { return what & ((std::uint64_t{1} << 61) - 1); }

  double estimate;  // estimated time of the whole path, exact for complete paths [s]
  std::uint64_t what;
};

bool before(const Entry& a, const Entry& b) {  // without branches
  return (a.estimate < b.estimate) | ((a.estimate == b.estimate) & (a.what < b.what));
}

bool is_complete(const Entry& entry) { return entry.kind() == Kind::kDirect || entry.kind() == Kind::kGoal; }

// A link of the graph, or a goal link, on the open list.
struct Step {
  std::uint32_t label;  // from which it continues
  std::uint32_t to;     // circle of the graph, or goal link
  std::uint32_t index;  // of the link among those of its circle
  double turn;          // on the circle, before the link [rad]
  double heading, length;
};

// What labels depend on beside the map, the starts and the goals.
struct Question {
  Vehicle vehicle;  // with the gears as the path will be driven
  const ClearanceCost* clearance_cost;
  Heuristic heuristic;
  TimeModel time_model;
  EndSpeeds ends;
  double cusp_cost;
  double suboptimality;
  std::uint32_t not_first, not_last, not_around;
  std::size_t end_radii;
  friend bool operator==(const Question&, const Question&) = default;
};

Question question_of(const SearchContext& context) {
  const SearchOptions& o = context.options;
  return {context.vehicle, context.map.clearance_cost.get(),
          o.heuristic,     o.time_model,
          o.ends,          o.cusp_cost,
          o.suboptimality, o.not_first,
          o.not_last,      o.not_around,
          o.end_radii};
}

}  // namespace

struct ArrivalSearch::Memory {
  Path take_path() {
    if (paths.empty()) return {};
    Path path = std::move(paths.back());
    paths.pop_back();
    path.clear();
    return path;
  }

  SearchAttachments attachments;
  SearchTimes times;
  struct Reached {
    std::weak_ptr<const CircleTable> map;  // weak, as a new table may lie at the same address
    Reachability by_starts;
  };
  std::array<Reached, 2> reached;  // of the roadmap of a query, and of that with circles in gaps
  // State of the search before.
  std::weak_ptr<const CircleTable> map;  // empty if no search can continue the one before
  std::optional<Question> question;
  double faster_than = 0.0;
  double goal_cost = 0.0;  // see Run
  std::uint32_t pushed_start_circles = 0;
  std::vector<std::uint32_t> start_joints;  // by start circle: at the end of its attachment's connection
  OpenList<Entry> open;
  HugeVector<Step> steps;
  ArrivalLabels labels;
  std::vector<std::uint32_t> chain;  // labels of the path found, last first
  std::vector<Path> paths;           // memory of paths that were found
};

// One search.
class ArrivalSearch::Run {
 public:
  Run(SearchContext& context, Memory& memory)
      : context_(context),
        graph_(context.graph),
        circles_(*context.map.circles),
        vehicle_(context.vehicle),
        top_speed_(vehicle_.top_speed()),
        weight_(1.0 + context.options.suboptimality),
        result_(context.result),
        w_(memory),
        attachments_(memory.attachments),
        dominance_(memory.labels, memory.times, context.map, vehicle_) {
    const bool adds_attachments = has_begun_before();
    if (context.map.speed_zones) slow_goal_ = context.map.speed_zones->disc_around(context.goal);
    w_.times.begin(context, adds_attachments);
    if (!adds_attachments) forget();
    w_.faster_than = context.options.faster_than;
    known_labels_ = w_.labels.size();
  }

  void run() {
    const EndSpeeds& ends = context_.options.ends;
    if (context_.interrupted() || ends.start < 0.0 || ends.goal < 0.0) return;
    if (!context_.options.warm_start)
      for (auto& reached : w_.reached) reached.map.reset();
    // If a path of that time is known, the goal is reachable.
    reachability_known_ = !context_.options.doubts_reachability || context_.options.faster_than < kInfinity;
    result_.start_connected = !w_.labels.empty();
    const auto first_direct = static_cast<std::uint32_t>(attachments_.direct_paths().size());
    const auto first_goal_link = static_cast<std::uint32_t>(attachments_.goal_links().size());
    attachments_.begin(context_);
    for (std::uint32_t i = first_direct; i < attachments_.direct_paths().size(); ++i)
      push(Kind::kDirect, i, attachments_.direct_paths()[i].time);
    push_goals_of_known_labels(first_goal_link);
    // Without any link to the goal, the search would expand the whole graph in vain.
    for (std::uint32_t g = 0;
         g < attachments_.goal_links().size() && !result_.goal_connected && !context_.interrupted(); ++g)
      result_.goal_connected = attachments_.is_free(attachments_.goal_link(g));
    if (result_.interrupted) return finish_best();
    if (!result_.goal_connected) return;
    find_goal_cost();
    // Many attachments mean that fewer found no path, so that there may be none.
    if (context_.starts.size() + context_.goals.size() > 2 && !reachability_known_ && !goal_is_reachable()) return;
    push_start_circles();
    bool prefetch_wanted = context_.options.prefetch && circles_.is_lazy();
    std::jthread prefetch;  // stopped and joined at the end
    while (!w_.open.empty() && !context_.interrupted()) {
      const Entry entry = w_.open.pop();
      prefetch_next();
      if (!is_wanted(entry.estimate)) return;
      if (is_complete(entry)) {
        if (finish(entry)) return;
      } else {
        expand(entry);
      }
      if (w_.labels.size() >= known_labels_ + kLong && std::exchange(prefetch_wanted, false))
        prefetch = start_prefetch();
      if (w_.labels.size() >= kLong && !reachability_known_ && !goal_is_reachable()) return;
      if (w_.labels.size() >= context_.options.most_expanded) return finish_best();
    }
    if (context_.interrupted()) finish_best();
  }

 private:
  // Whether the search before was a part of this one.
  [[nodiscard]] bool has_begun_before() const {
    return context_.options.warm_start && w_.map.lock() == context_.map.circles &&
           w_.question == question_of(context_) && context_.options.faster_than <= w_.faster_than &&
           attachments_.are_first_of(context_);
  }

  void forget() {
    w_.map = context_.map.circles;
    w_.question = question_of(context_);
    forget_paths();
    attachments_.forget();
  }

  void forget_paths() {
    w_.pushed_start_circles = 0;
    w_.start_joints.clear();
    w_.open.clear();
    w_.steps.clear();
    // Reserves what most searches need. Unused memory costs nothing, but growing means copying into pages that the
    // system clears first.
    const std::size_t enough = context_.map.world.vertices().size();
    w_.open.reserve(enough);
    w_.steps.reserve(enough);
    w_.times.reserve(enough);
    w_.labels.reset(graph_.circles().size(), enough);
  }

  // Estimates of the search before may be too high with the links of further goals. Then the search begins anew.
  void find_goal_cost() {
    if (context_.options.heuristic != Heuristic::kTravelTime) return;
    goal_cost_ = least_goal_cost(context_, attachments_);
    const double before = std::exchange(w_.goal_cost, goal_cost_);
    if (w_.pushed_start_circles == 0 || goal_cost_ >= before) return;
    forget_paths();
    attachments_.forget_times();
    w_.times.begin(context_, false);
    known_labels_ = 0;
    for (std::uint32_t i = 0; i < attachments_.direct_paths().size(); ++i)
      push(Kind::kDirect, i, attachments_.direct_paths()[i].time);
  }

  // Starts the prefetch search: a slightly greedier search in a thread of its own, which fills the caches of the graph.
  [[nodiscard]] std::jthread start_prefetch() const {
    SearchOptions ahead = context_.options;
    ahead.prefetch = ahead.warm_start = false;
    ahead.suboptimality += kPrefetchHaste;
    ahead.doubts_reachability = false;
    try {
      return std::jthread([this, ahead](const std::stop_token& done) mutable {
        ahead.clock = ahead.clock.with_stop(done);
        try {
          ArrivalSearch().find(context_.map, context_.starts, context_.goals, ahead);
        } catch (...) {  // the search itself meets the same error, or does without
        }
      });
    } catch (const std::system_error&) {  // no thread is left
      return {};
    }
  }

  // Whether any path leads from the start to the goal.
  bool goal_is_reachable() {
    reachability_known_ = true;
    return !attachments_.direct_paths().empty() || reached_before().goal_is_reachable(context_, attachments_);
  }

  Reachability& reached_before() {
    const auto is_this_map = [this](const auto& reached) { return reached.map.lock() == context_.map.circles; };
    auto found = std::ranges::find_if(w_.reached, is_this_map);
    if (found != w_.reached.end()) return found->by_starts;
    found = w_.reached[0].map.expired() ? w_.reached.begin() : w_.reached.begin() + 1;
    found->map = context_.map.circles;
    found->by_starts.forget();
    return found->by_starts;
  }

  // The estimated remaining time, and cost of driving close [s].
  [[nodiscard]] double remaining(const Vec2& p, double speed) const {
    return weight_ * (heuristic(p, speed) + goal_cost_);
  }

  [[nodiscard]] double heuristic(const Vec2& p, double speed) const {
    const double distance = (context_.goal - p).norm();
    switch (context_.options.heuristic) {
      case Heuristic::kTravelTime:
        return time_over(distance, speed);
      case Heuristic::kPaperDistance:
        return distance;
      case Heuristic::kDijkstra:
        break;
    }
    return 0.0;
  }

  // A lower bound on the time over a distance to the goal [s]: what lies in the disc about the goal comes last.
  [[nodiscard]] double time_over(double distance, double speed) const {
    const double goal_speed = context_.options.ends.goal, a = vehicle_.max_acceleration();
    const double slow = std::min(distance, slow_goal_.radius), cap = std::min(top_speed_, slow_goal_.cap);
    if (slow == 0.0) return relaxed_segment_time(distance, speed, top_speed_, goal_speed, a);
    return relaxed_segment_time(distance - slow, speed, top_speed_, cap, a) +
           relaxed_segment_time(slow, cap, cap, goal_speed, a);
  }

  // Whether an estimate is low enough. What continues a path that is too slow is not wanted, now or after a warm start.
  [[nodiscard]] bool is_wanted(double estimate) const { return estimate < context_.options.faster_than; }
  void push(Kind kind, std::size_t index, double estimate) {
    if (!is_wanted(estimate)) return;
    w_.open.push({estimate, kind, index});
    ++result_.counts.nodes_pushed;
  }
  void push(Kind kind, const Step& step, double estimate) {
    if (!is_wanted(estimate)) return;
    push(kind, w_.steps.size(), estimate);
    w_.steps.push_back(step);
  }

  // Prefetches the memory of the next entries: first the entries' own, then that of their targets.
  void prefetch_next() const {
    const std::span<const Entry> next = w_.open.first_few(kSoon);
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (next[i].kind() != Kind::kGraph) continue;
      const Step& step = w_.steps[next[i].index()];
      if (i >= kNext) {
        will_need(&step);
        continue;
      }
      circles_.prefetch(step.to);
      w_.labels.prefetch_on(step.to);
      attachments_.prefetch(step.to);
      w_.labels.prefetch(step.label);
      if (i == 0) circles_.prefetch_links(step.to);
    }
  }

  // Takes the best complete path that is free. The open list may hold millions of other entries, which are not worth
  // sorting.
  void finish_best() {
    w_.map.reset();
    w_.open.keep_if(is_complete);
    while (!w_.open.empty() && !finish(w_.open.pop())) {
    }
  }

  // Takes a complete path as the result if it is free.
  bool finish(const Entry& entry) {
    if (entry.kind() == Kind::kDirect) {
      result_.path = w_.take_path();
      attachments_.take_path(attachments_.direct_paths()[entry.index()], *result_.path);
      return true;
    }
    const Step& step = w_.steps[entry.index()];
    SearchAttachments::GoalLink& goal = attachments_.goal_link(step.to);
    if (attachments_.is_free(goal))
      ArrivalPath(context_, attachments_, w_.labels, w_.chain).write(step.label, goal.link, w_.take_path(), result_);
    return goal.free;
  }

  void expand(const Entry& entry) {
    const auto index = static_cast<std::uint32_t>(entry.index());
    if (entry.kind() == Kind::kStartCircle) return push_start_links(index);
    const std::size_t joints = w_.times.speeds().size();
    const ArrivalLabel label = arrival_by(entry);
    if (comes_later(entry, label) || !arrive(label)) w_.times.truncate(joints);
  }

  // Whether an entry, whose estimate knows no places, has been put back on the open list for its arrival is not the
  // next one.
  bool comes_later(const Entry& entry, const ArrivalLabel& label) {
    if (!w_.times.depends_on_places() || w_.open.empty()) return false;
    const SpeedTree::Joint& arrival = w_.times.speeds()[label.joint];
    const TurnCircle& circle = graph_.circles()[label.circle];
    const double exact = arrival.time + w_.times.clearance_cost(label.joint) +
                         remaining(pose_on(circle, label.heading).position(), arrival.speed);
    if (!(exact > entry.estimate * (1.0 + kSameEstimate)) || exact <= w_.open.first_few(1)[0].estimate) return false;
    push(entry.kind(), entry.index(), exact);
    return true;
  }

  // The label that a step or a start link leads to.
  ArrivalLabel arrival_by(const Entry& entry) {
    const auto index = static_cast<std::uint32_t>(entry.index());
    if (entry.kind() == Kind::kStart) {
      const AttachmentLink& link = attachments_.start_link(index);
      const AttachmentCircle& from = attachments_.start_circles()[link.attachment_circle];
      const double radius = circles_.circle(link.circle).radius;
      const std::uint32_t start = w_.start_joints[link.attachment_circle];
      const std::uint32_t joint =
          w_.times.depends_on_places()
              ? add_line(
                    w_.times.add_segment(start, arc_on(from.circle, from.heading, link.turn), vehicle_.max_speed()),
                    link.line, radius)
              : w_.times.add_drive(
                    {start, link.turn * from.circle.radius, from.circle.radius, link.line.length, radius});
      return {link.circle, 0, radius, link.line.start.heading, 0.0, joint, kNone, index, kNone};
    }
    const Step step = w_.steps[entry.index()];
    const ArrivalLabel& parent = w_.labels[step.label];
    const double radius = circles_.circle(step.to).radius;
    const TurnCircle& circle = graph_.circles()[parent.circle];
    const std::uint32_t joint =
        w_.times.depends_on_places()
            ? add_line(w_.times.add_turn(parent.joint, parent.circle, arc_on(circle, parent.heading, step.turn),
                                         vehicle_.max_speed()),
                       {pose_on(circle, step.heading), step.length}, radius)
            : w_.times.add_drive({parent.joint, step.turn * parent.radius, parent.radius, step.length, radius});
    return {step.to, 0, radius, step.heading, 0.0, joint, step.label, step.index, kNone};
  }

  // The line of a drive whose cost depends on places, and the joint at its end.
  std::uint32_t add_line(std::uint32_t joint, const Bitangent& line, double next_radius) {
    return w_.times.add_segment(joint, {line.start, line.length, 0.0}, vehicle_.turn_speed(next_radius));
  }

  void push_start_circles() {
    for (std::uint32_t& s = w_.pushed_start_circles; s < attachments_.start_circles().size(); ++s) {
      const Attachment& start = context_.starts[attachments_.start_circles()[s].attachment];
      if (attachments_.start_circles()[s].reach >= 0.0)
        push(Kind::kStartCircle, s,
             length_of(start.connection) / top_speed_ + remaining(start.pose.position(), top_speed_));
    }
  }

  void push_start_links(std::uint32_t s) {
    const AttachmentCircle& from = attachments_.start_circles()[s];
    const std::uint32_t joint = w_.times.add_connection(from);
    w_.start_joints.resize(std::max(w_.start_joints.size(), std::size_t{s} + 1));
    w_.start_joints[s] = joint;
    const auto range = attachments_.links_from(s);
    StopTicker ticker(context_.options.clock);  // in open country they may be ten thousand
    const bool is_lazy = circles_.is_lazy();
    const auto close = w_.times.close_headings(from.circle);
    for (std::uint32_t i = range.first; i < range.last && !ticker.is_over(); ++i) {
      const AttachmentLink& link = attachments_.start_link(i);
      if (link.circle == context_.options.not_first) continue;
      // A lazy graph finds them when the link is the next one, if it ever is.
      if (!is_lazy && !graph_.free_headings(link.circle).contains(link.line.start.heading)) continue;
      const double radius = circles_.circle(link.circle).radius;
      const Vec2 end = link.line.start.position() + link.line.length * quick_direction_of(link.line.start.heading);
      const double from_radius = from.circle.radius;
      push(Kind::kStart, i,
           estimate({joint, link.turn * from_radius, from_radius, link.line.length, radius}, end) +
               turn_cost(close, {from_radius, from.circle.side, from.heading, link.turn}));
    }
  }

  // The estimated time of the whole path that continues a joint by a drive to a place, without what driving close costs
  // on the drive [s].
  [[nodiscard]] double estimate(const SearchTimes::Drive& drive, const Vec2& end) const {
    const SpeedTree::Joint arrival = w_.times.drive(drive);
    return arrival.time + remaining(end, arrival.speed);
  }

  // Expands a new label. False if an older one is as good, or its arrival is not free.
  bool arrive(ArrivalLabel label) {
    const CircleTable::Circle circle = circles_.circle(label.circle);
    if (context_.options.not_around != kNone && turn_on(context_.map, label.circle) == context_.options.not_around)
      return false;
    label.reach = circles_.reach(label.circle, label.heading);
    if (label.reach < 0.0) return false;
    w_.labels.follow(label);
    const double limit = dominance_.undominated_turn(label, circle.side, {known_labels_, context_.options.least_gain});
    if (limit < 0.0) return false;
    const bool free = label.parent == kNone ? context_.is_free(attachments_.start_link(label.index).line)
                                            : graph_.is_kept(w_.labels[label.parent].circle, label.index);
    if (!free) return false;
    result_.start_connected = true;
    ++result_.counts.nodes_expanded;
    leave(w_.labels.add(label), circle, limit);
    return true;
  }

  // Pushes the departures from a circle, from the arrival's heading on, up to the end of its free interval or an older
  // label.
  void leave(std::uint32_t index, const CircleTable::Circle& circle, double limit) {
    const ArrivalLabel label = w_.labels[index];
    const auto goes_on = [&](double turn) { return turn <= label.reach && turn < limit; };

    for (std::uint32_t g = attachments_.first_goal_link(label.circle); g != kNone; g = attachments_.goal_link(g).next)
      push_goal(index, g, circle.side, goes_on);

    const bool one_radius = circles_.has_one_radius();
    walk_links(context_.links_from(label.circle), circle.side, label.heading,
               [&](std::uint32_t at, const FeasibleGraph::Link& link, double turn) {
                 if (!goes_on(turn)) return false;
                 const Vec2 ahead = quick_direction_of(link.heading);
                 const Vec2 from = circle.center - sign_of(circle.side) * circle.radius * perpendicular(ahead);
                 const double radius = one_radius ? label.radius : circles_.circle(link.to).radius;
                 push(Kind::kGraph, {index, link.to, at, turn, link.heading, link.length},
                      estimate({label.joint, turn * label.radius, label.radius, link.length, radius},
                               from + link.length * ahead) +
                          w_.times.turn_cost(label.circle, label.heading, turn));
                 return true;
               });
  }

  template <class Test>
  void push_goal(std::uint32_t index, std::uint32_t g, Side side, Test&& goes_on) {
    const ArrivalLabel& label = w_.labels[index];
    if (label.circle == context_.options.not_last) return;
    SearchAttachments::GoalLink& goal = attachments_.goal_link(g);
    const double turn = turn_between(label.heading, goal.link.line.start.heading, side);
    if (!goes_on(turn) || (goal.checked && !goal.free)) return;
    const AttachmentCircle& to = attachments_.goal_circles()[goal.link.attachment_circle];
    const double time = w_.times.depends_on_places()
                            ? w_.times.time_to_goal(label.joint, label.circle,
                                                    arc_on(graph_.circles()[label.circle], label.heading, turn),
                                                    {goal.link, to, attachments_.close_cost(g)})
                            : w_.times.time_to_goal(label.joint, turn * label.radius, label.radius, goal.link, to);
    if (time >= goal.best_time) return;
    goal.best_time = time;
    push(Kind::kGoal, {index, g, kNone, 0.0, 0.0, 0.0}, time);
  }

  // Pushes new goal links of the labels of the search before.
  void push_goals_of_known_labels(std::uint32_t first_goal_link) {
    if (w_.labels.empty()) return;
    for (std::uint32_t g = first_goal_link; g < attachments_.goal_links().size(); ++g) {
      const std::uint32_t c = attachments_.goal_link(g).link.circle;
      for (std::uint32_t i = w_.labels.last_on(c); i != kNone; i = w_.labels[i].next)
        push_goal(i, g, circles_.circle(c).side, [&](double turn) { return turn <= w_.labels[i].reach; });
    }
  }

  SearchContext& context_;
  const FeasibleGraph& graph_;
  const CircleTable& circles_;
  const Vehicle& vehicle_;
  double top_speed_;  // in either gear, as connections may have both
  double weight_;     // of the heuristic
  SpeedZones::Disc slow_goal_{kInfinity, 0.0};
  double goal_cost_ = 0.0;  // of driving close at the goal, at least [s]
  bool reachability_known_ = false;
  std::size_t known_labels_ = 0;  // of the search before
  SearchResult& result_;
  Memory& w_;
  SearchAttachments& attachments_;
  ArrivalDominance dominance_;
};

ArrivalSearch::ArrivalSearch() : memory_(std::make_unique<Memory>()) {}
ArrivalSearch::~ArrivalSearch() = default;
ArrivalSearch::ArrivalSearch(ArrivalSearch&&) noexcept = default;
ArrivalSearch& ArrivalSearch::operator=(ArrivalSearch&&) noexcept = default;

SearchResult ArrivalSearch::find(const Roadmap& map, std::span<const Attachment> starts,
                                 std::span<const Attachment> goals, const SearchOptions& options) {
  SearchResult result;
  SearchContext context(map, starts, goals, options, result);
  Run(context, *memory_).run();
  return result;
}

void ArrivalSearch::begin_query() { memory_->attachments.begin_query(); }

void ArrivalSearch::warm_up(std::size_t circles) {
  const std::size_t many = std::min(circles / 2, kManyLabels);
  memory_->map.reset();
  memory_->open.warm_up(many);
  memory_->times.warm_up(many);
  empty_with_memory(memory_->steps, many);
  memory_->labels.warm_up(circles, many);
  memory_->attachments.warm_up(circles);
}

void ArrivalSearch::reuse(Path&& path) {
  if (memory_->paths.size() < kPaths) memory_->paths.push_back(std::move(path));
}

Path ArrivalSearch::empty_path() { return memory_->take_path(); }

}  // namespace arcway::internal
