#include "core/search/arrival_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/geometry/angle.h"
#include "core/path/dubins.h"
#include "core/path/speed_profile.h"
#include "core/search/open_list.h"
#include "core/search/per_circle.h"
#include "core/search/pocket.h"
#include "core/search/speed_tree.h"

namespace arcway {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Kind : std::uint8_t { kDirect, kGoal, kGraph, kStart, kStartCircle };  // complete paths first on ties

// What waits on an open list, in 16 bytes.
struct Entry {
  Entry(double e, Kind kind, std::uint32_t parent, std::uint32_t index)
      : estimate(e),
        what((std::uint64_t{static_cast<std::uint8_t>(kind)} << 61) | (std::uint64_t{parent} << 29) | index) {}
  [[nodiscard]] Kind kind() const { return static_cast<Kind>(what >> 61); }
  // Label, where a graph link or a goal link is.
  [[nodiscard]] std::uint32_t parent() const { return static_cast<std::uint32_t>(what >> 29); }
  [[nodiscard]] std::uint32_t index() const { return static_cast<std::uint32_t>(what & ((1U << 29) - 1)); }

  double estimate;  // of the whole path's time; the time itself for complete paths
  std::uint64_t what;
};

bool before(const Entry& a, const Entry& b) {
  return a.estimate != b.estimate ? a.estimate < b.estimate : a.what < b.what;
}

// An arrival on a circle by some path.
struct Label {
  std::uint32_t circle;
  double heading;
  double reach;  // of the free interval
  std::uint32_t joint;
  std::uint32_t parent;  // label; kNone: by a start link
  std::uint32_t index;   // of the graph link among those of the parent's circle, or of the start link
  std::uint32_t next;    // label on the same circle
};

// Part of a circle that some path turns on, whenever and however fast it gets there.
struct ReachedArc {
  double heading;      // of the arrival
  double reach;        // of the free interval
  std::uint32_t next;  // on the same circle
};

struct GoalLink {
  TerminalLink link;
  std::uint32_t next;  // on the same circle
  double best_time;    // of complete paths by this link
  bool checked, free;
};

void append_arc(Path& path, const TurnCircle& circle, double from_heading, double turn) {
  if (turn > 0.0)
    path.push_back({pose_on(circle, from_heading), turn * circle.radius, sign_of(circle.side) / circle.radius});
}

void append_line(Path& path, const Pose& start, double length) {
  if (length > 0.0) path.push_back({start, length, 0.0});
}

}  // namespace

struct SearchWorkspace::Data {
  void reset(std::size_t circles, double acceleration, TimeModel time_model) {
    speeds.reset(acceleration, time_model);
    first_label.reset(circles);
    first_goal_link.reset(circles);
    first_arc.reset(circles);
    open.clear();
    arrivals.clear();
    arcs.clear();
    labels.clear();
    start_circles.clear();
    goal_circles.clear();
    start_links.clear();
    start_link_ranges.clear();
    goal_links.clear();
    found.clear();
    direct_paths.clear();
  }

  SpeedTree speeds;
  PerCircle first_label;
  PerCircle first_goal_link;
  PerCircle first_arc;
  OpenList<Entry> open, arrivals;
  std::vector<Label> labels;
  std::vector<ReachedArc> arcs;
  std::vector<TerminalCircle> start_circles, goal_circles;
  std::vector<TerminalLink> start_links, found;
  struct Range {
    std::uint32_t first = kNone, last = kNone;
  };
  std::vector<Range> start_link_ranges;  // by start circle; kNone: not made yet
  std::vector<GoalLink> goal_links;
  std::vector<Path> direct_paths;
};

SearchWorkspace::SearchWorkspace() : data_(std::make_unique<Data>()) {}
SearchWorkspace::~SearchWorkspace() = default;
SearchWorkspace::SearchWorkspace(SearchWorkspace&&) noexcept = default;
SearchWorkspace& SearchWorkspace::operator=(SearchWorkspace&&) noexcept = default;

namespace {

class ArrivalSearch {
 public:
  ArrivalSearch(const SearchMap& map, std::span<const Terminal> starts, std::span<const Terminal> goals,
                const SearchOptions& options, SearchWorkspace::Data& workspace, SearchResult& result)
      : map_(map),
        graph_(map.graph),
        vehicle_(options.gear == Gear::kForward ? map.vehicle : map.vehicle.with_gears_swapped()),
        line_speed_(vehicle_.max_speed()),
        top_speed_(vehicle_.top_speed()),
        starts_(starts),
        goals_(goals),
        options_(options),
        goal_((goals[0].connection.empty() ? goals[0].pose : goals[0].connection.back().end()).position()),
        w_(workspace),
        result_(result) {
    w_.reset(graph_.circles().size(), vehicle_.max_acceleration(), options.time_model);
  }

  void run() {
    if (interrupted()) return;
    append_circles(map_, starts_, Direction::kFromStart, w_.start_circles);
    append_circles(map_, goals_, Direction::kToGoal, w_.goal_circles);
    result_.turns_checked += w_.start_circles.size() + w_.goal_circles.size();
    push_direct_paths();
    // The goals of manoeuvres may have millions of links.
    for (std::uint32_t g = 0; g < w_.goal_circles.size() && !interrupted(); ++g) add_goal_links(g);
    // A goal that nothing leads to would have the whole graph searched in vain.
    for (std::size_t i = 0; i < w_.goal_links.size() && !result_.goal_connected && !interrupted(); ++i)
      result_.goal_connected = is_free(w_.goal_links[i]);
    if (result_.interrupted) return finish_best();
    if (!result_.goal_connected) return;
    w_.start_link_ranges.resize(w_.start_circles.size());
    // Many terminals mean that few of them found no path: is there one at all?
    if (starts_.size() + goals_.size() > 2 && options_.faster_than == kInfinity && !goal_is_reachable()) return;
    for (std::uint32_t s = 0; s < w_.start_circles.size(); ++s) {
      const Terminal& start = starts_[w_.start_circles[s].terminal];
      if (w_.start_circles[s].reach >= 0.0)
        push(Kind::kStartCircle, kNone, s,
             length_of(start.connection) / top_speed_ + remaining(start.pose.position(), top_speed_));
    }
    while (!w_.open.empty() && !interrupted()) {
      const Entry entry = w_.open.pop();
      if (entry.estimate >= options_.faster_than) return;
      if (is_complete(entry) ? finish(entry) : expand(entry)) return;
      if (w_.labels.size() >= kFirstDoubt && !reachability_known_ && !goal_is_reachable()) return;
    }
    if (result_.interrupted) finish_best();
  }

 private:
  [[nodiscard]] bool interrupted() {
    result_.interrupted = result_.interrupted || options_.interrupted();
    return result_.interrupted;
  }

  [[nodiscard]] double remaining(const Vec2& p, double speed) const {
    const double distance = (goal_ - p).norm();
    switch (options_.heuristic) {
      case Heuristic::kTravelTime:
        return relaxed_segment_time(distance, speed, top_speed_, 0.0, vehicle_.max_acceleration());
      case Heuristic::kPaperDistance:
        return distance;
      case Heuristic::kDijkstra:
        break;
    }
    return 0.0;
  }

  void push(Kind kind, std::uint32_t parent, std::uint32_t index, double estimate) {
    w_.open.push({estimate, kind, parent, index});
    ++result_.nodes_pushed;
  }

  [[nodiscard]] static bool is_complete(const Entry& entry) {
    return entry.kind() == Kind::kDirect || entry.kind() == Kind::kGoal;
  }

  // Takes the best complete path that is free. The open list may be millions of others, which are not worth sorting.
  void finish_best() {
    w_.open.keep_if(is_complete);
    while (!w_.open.empty() && !finish(w_.open.pop())) {
    }
  }

  // Takes a complete path as the result if it is free.
  bool finish(const Entry& entry) {
    if (entry.kind() == Kind::kDirect) {
      result_.path = std::move(w_.direct_paths[entry.index()]);
      return true;
    }
    GoalLink& goal = w_.goal_links[entry.index()];
    if (is_free(goal)) result_.path = path_through(entry.parent(), goal.link);
    return goal.free;
  }

  // Always false: the search goes on.
  bool expand(const Entry& entry) {
    switch (entry.kind()) {
      case Kind::kStartCircle:
        push_start_links(entry.index());
        break;
      case Kind::kStart: {
        const TerminalLink& link = w_.start_links[entry.index()];
        const TerminalCircle& from = w_.start_circles[link.terminal_circle];
        const std::uint32_t joint = drive(add_connection(from), link.turn * from.circle.radius, from.circle.radius,
                                          link.line.length, graph_.circles()[link.circle].radius);
        arrive({link.circle, link.line.start.heading, 0.0, joint, kNone, entry.index(), kNone});
        break;
      }
      case Kind::kGraph: {
        const Label& parent = w_.labels[entry.parent()];
        const TurnCircle& circle = graph_.circles()[parent.circle];
        const FeasibleGraph::Link& link = graph_.links_from(parent.circle)[entry.index()];
        const double turn = turn_between(parent.heading, link.heading, circle.side);
        const std::uint32_t joint =
            drive(parent.joint, turn * circle.radius, circle.radius, link.length, graph_.circles()[link.to].radius);
        arrive({link.to, link.heading, 0.0, joint, entry.parent(), entry.index(), kNone});
        break;
      }
      case Kind::kDirect:
      case Kind::kGoal:
        break;
    }
    return false;
  }

  // Adds the joints behind an arc and the line after it, which leads to a circle of another radius.
  std::uint32_t drive(std::uint32_t joint, double arc, double radius, double line, double next_radius) {
    const std::uint32_t departure = w_.speeds.add(joint, arc, vehicle_.turn_speed(radius), line_speed_);
    return w_.speeds.add(departure, line, line_speed_, vehicle_.turn_speed(next_radius));
  }

  // Adds the joints of a start terminal's connection up to its circle.
  std::uint32_t add_connection(const TerminalCircle& from) {
    const Path& connection = starts_[from.terminal].connection;
    std::uint32_t joint = 0;
    const Stretch circle{0.0, vehicle_.turn_speed(from.circle.radius), Gear::kForward};
    for (std::size_t i = 0; i < connection.size(); ++i)
      joint = add_stretch(joint, stretch_of(connection[i]),
                          i + 1 < connection.size() ? stretch_of(connection[i + 1]) : circle);
    return joint;
  }

  // What matters of a segment for the speeds.
  struct Stretch {
    double length;
    double limit;
    Gear gear;
  };
  [[nodiscard]] Stretch stretch_of(const PathSegment& segment) const {
    return {segment.length, speed_limit(segment, vehicle_), segment.gear};
  }

  // Adds the joints behind a stretch: two where the gear changes.
  std::uint32_t add_stretch(std::uint32_t joint, const Stretch& stretch, const Stretch& next) {
    if (stretch.gear == next.gear) return w_.speeds.add(joint, stretch.length, stretch.limit, next.limit);
    return w_.speeds.add_stop(w_.speeds.add(joint, stretch.length, stretch.limit, 0.0), options_.cusp_cost);
  }

  bool is_free(const Bitangent& line) {
    ++result_.straights_checked;
    return map_.queries.sweep->straight_free(swept_rectangle(line.start, line.length, map_.body));
  }

  // The swept rectangle, and the body on the graph's circle where it begins.
  bool is_free(GoalLink& goal) {
    if (!goal.checked) {
      const Bitangent& line = goal.link.line;
      goal.free = graph_.free_headings(goal.link.circle).contains(line.start.heading) && is_free(line);
      goal.checked = true;
    }
    return goal.free;
  }

  bool is_free(const PathSegment& segment) {
    if (segment.is_line()) return is_free(Bitangent{segment.start, segment.length});
    const Side side = segment.curvature > 0.0 ? Side::kLeft : Side::kRight;
    const TurnCircle circle = turn_circle(segment.start, 1.0 / std::abs(segment.curvature), side);
    ++result_.turns_checked;
    const HeadingSet headings = map_.queries.sweep->free_headings({circle.center, circle.radius, side, map_.body});
    return headings.reach(segment.start.heading, side) >= segment.length / circle.radius;
  }

  void push_direct_paths() {
    // Many terminals mean manoeuvres in a narrow place: only the plain pair of poses is worth all words there.
    if (starts_.size() * goals_.size() > kMostDirectPairs) return;
    for (const Terminal& start : starts_)
      for (const Terminal& goal : goals_)
        for (const double radius : map_.radii)
          for (const DubinsWord word : kDubinsWords) try_direct(start, goal, radius, word);
  }

  void try_direct(const Terminal& start, const Terminal& goal, double radius, DubinsWord word) {
    const auto middle = dubins_path(word, start.pose, goal.pose, radius);
    if (!middle || !std::all_of(middle->begin(), middle->end(), [this](const auto& s) { return is_free(s); })) return;
    result_.start_connected = result_.goal_connected = true;
    Path path = start.connection;
    path.insert(path.end(), middle->begin(), middle->end());
    path.insert(path.end(), goal.connection.begin(), goal.connection.end());
    const double time = travel_cost(path, vehicle_, options_.cusp_cost);
    w_.direct_paths.push_back(std::move(path));
    push(Kind::kDirect, kNone, static_cast<std::uint32_t>(w_.direct_paths.size() - 1), time);
  }

  SearchWorkspace::Data::Range links_from_start(std::uint32_t s) {
    auto& range = w_.start_link_ranges[s];
    if (range.first == kNone) {
      range.first = static_cast<std::uint32_t>(w_.start_links.size());
      append_links(map_, w_.start_circles, s, Direction::kFromStart, w_.start_links);
      range.last = static_cast<std::uint32_t>(w_.start_links.size());
    }
    return range;
  }

  void push_start_links(std::uint32_t s) {
    const TerminalCircle& from = w_.start_circles[s];
    const std::uint32_t joint = add_connection(from);
    const auto range = links_from_start(s);
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      const TerminalLink& link = w_.start_links[i];
      if (!graph_.free_headings(link.circle).contains(link.line.start.heading)) continue;
      const TurnCircle& to = graph_.circles()[link.circle];
      push_straight(Kind::kStart, kNone, i, joint, link.turn, from.circle, link.line.length, to,
                    link.line.start.heading);
    }
  }

  void add_goal_links(std::uint32_t g) {
    const Terminal& goal = goals_[w_.goal_circles[g].terminal];
    const double way = (goal.pose.position() - starts_[0].pose.position()).norm() + length_of(goal.connection);
    if (way / top_speed_ >= options_.faster_than) return;
    w_.found.clear();
    append_links(map_, w_.goal_circles, g, Direction::kToGoal, w_.found);
    for (const TerminalLink& link : w_.found) {
      w_.goal_links.push_back({link, w_.first_goal_link.get(link.circle), kInfinity, false, false});
      w_.first_goal_link.set(link.circle, static_cast<std::uint32_t>(w_.goal_links.size() - 1));
    }
  }

  // Pushes an arrival behind an arc and a line.
  void push_straight(Kind kind, std::uint32_t parent, std::uint32_t index, std::uint32_t joint, double turn,
                     const TurnCircle& from, double length, const TurnCircle& to, double heading) {
    const SpeedTree::Joint departure =
        w_.speeds.extend(joint, turn * from.radius, vehicle_.turn_speed(from.radius), line_speed_);
    const SpeedTree::Joint arrival = w_.speeds.extend(departure, length, line_speed_, vehicle_.turn_speed(to.radius));
    push(kind, parent, index, arrival.time + remaining(pose_on(to, heading).position(), arrival.speed));
  }

  // Goes on from a new label, unless it is as good as an older one or cannot be reached after all.
  void arrive(Label label) {
    const TurnCircle& circle = graph_.circles()[label.circle];
    label.reach = graph_.free_headings(label.circle).reach(label.heading, circle.side);
    if (label.reach < 0.0) return;
    const double limit = undominated_turn(label, circle);
    if (limit < 0.0) return;
    const bool free = label.parent == kNone ? is_free(w_.start_links[label.index].line)
                                            : graph_.is_kept(w_.labels[label.parent].circle, label.index);
    if (!free) return;
    result_.start_connected = true;
    ++result_.nodes_expanded;
    label.next = w_.first_label.get(label.circle);
    w_.labels.push_back(label);
    const auto index = static_cast<std::uint32_t>(w_.labels.size() - 1);
    w_.first_label.set(label.circle, index);
    walk(index, limit);
  }

  // How far a label can turn before an older one does as well; negative if that is so from the beginning.
  [[nodiscard]] double undominated_turn(const Label& label, const TurnCircle& circle) const {
    const double speed = vehicle_.turn_speed(circle.radius);
    double limit = kInfinity;
    for (std::uint32_t i = w_.first_label.get(label.circle); i != kNone; i = w_.labels[i].next) {
      const Label& other = w_.labels[i];
      const double behind = turn_between(other.heading, label.heading, circle.side);
      if (behind <= other.reach) {
        const auto here = w_.speeds.extend(other.joint, behind * circle.radius, speed, speed);
        if (w_.speeds.dominates(here, w_.speeds[label.joint])) return -1.0;
      }
      const double ahead = turn_between(label.heading, other.heading, circle.side);
      if (ahead <= label.reach && ahead < limit) {
        const auto there = w_.speeds.extend(label.joint, ahead * circle.radius, speed, speed);
        if (w_.speeds.dominates(w_.speeds[other.joint], there)) limit = ahead;
      }
    }
    return limit;
  }

  // Leaves a circle from the arrival's heading on, as far as its free interval goes and no older label takes over.
  void walk(std::uint32_t index, double limit) {
    const Label label = w_.labels[index];
    const TurnCircle& circle = graph_.circles()[label.circle];
    const auto goes_on = [&](double turn) { return turn <= label.reach && turn < limit; };

    for (std::uint32_t g = w_.first_goal_link.get(label.circle); g != kNone; g = w_.goal_links[g].next) {
      GoalLink& goal = w_.goal_links[g];
      const double turn = turn_between(label.heading, goal.link.line.start.heading, circle.side);
      if (!goes_on(turn) || (goal.checked && !goal.free)) continue;
      const double time = time_to_goal(label.joint, turn, circle, goal.link);
      if (time >= goal.best_time) continue;
      goal.best_time = time;
      push(Kind::kGoal, index, g, time);
    }

    walk_links(label.circle, label.heading, [&](std::uint32_t at, const FeasibleGraph::Link& link, double turn) {
      if (!goes_on(turn)) return false;
      push_straight(Kind::kGraph, index, at, label.joint, turn, circle, link.length, graph_.circles()[link.to],
                    link.heading);
      return true;
    });
  }

  // Whether any path of the graph leads from the start to the goal, or one without it is known: without times and
  // speeds, nearest to the goal first.
  bool goal_is_reachable() {
    reachability_known_ = true;
    if (!w_.direct_paths.empty()) return true;
    const bool in_pocket = goal_is_in_pocket();
    for (std::uint32_t s = 0; s < w_.start_circles.size(); ++s) {
      if (w_.start_circles[s].reach < 0.0) continue;
      const auto range = links_from_start(s);
      for (std::uint32_t i = range.first; i < range.last; ++i) push_arrival(Kind::kStart, kNone, i);
    }
    while (!w_.arrivals.empty() && !interrupted()) {
      if (reaches_goal(w_.arrivals.pop())) return true;
      result_.start_is_open = w_.arcs.size() >= kOpen;
      if (result_.start_is_open && in_pocket) return false;
    }
    return result_.interrupted;
  }

  // Whether so little leads to the goal that one sees, going backwards, that the start does not.
  bool goal_is_in_pocket() {
    if (graph_.mode() != GraphMode::kEager || w_.goal_links.size() > kLargestPocket) return false;
    std::vector<Departure> ends;
    for (GoalLink& goal : w_.goal_links)
      if (is_free(goal)) ends.push_back({goal.link.circle, goal.link.line.start.heading});
    const auto pocket = departures_towards(graph_, std::move(ends), kLargestPocket);
    if (!pocket) return false;
    PerCircle first;
    first.reset(graph_.circles().size());
    std::vector<std::uint32_t> next;
    for (std::uint32_t i = 0; i < pocket->size(); ++i) {
      next.push_back(first.get((*pocket)[i].circle));
      first.set((*pocket)[i].circle, i);
    }
    for (std::uint32_t s = 0; s < w_.start_circles.size(); ++s) {
      if (w_.start_circles[s].reach < 0.0) continue;
      const auto range = links_from_start(s);
      for (std::uint32_t i = range.first; i < range.last; ++i) {
        const TerminalLink& link = w_.start_links[i];
        for (std::uint32_t d = first.get(link.circle); d != kNone; d = next[d])
          if (leads_to(graph_, link.line.start.heading, (*pocket)[d]) && is_free(link.line)) return false;
      }
    }
    return true;
  }

  struct Arrival {
    std::uint32_t circle;
    double heading;
  };
  [[nodiscard]] Arrival arrival_at(Kind kind, std::uint32_t from, std::uint32_t index) const {
    if (kind == Kind::kStart) return {w_.start_links[index].circle, w_.start_links[index].line.start.heading};
    const FeasibleGraph::Link& link = graph_.links_from(from)[index];
    return {link.to, link.heading};
  }

  void push_arrival(Kind kind, std::uint32_t from, std::uint32_t index) {
    const Arrival at = arrival_at(kind, from, index);
    const double distance = (goal_ - pose_on(graph_.circles()[at.circle], at.heading).position()).norm();
    w_.arrivals.push({distance, kind, from, index});
  }

  // Takes an arrival if it is free and new; true if the goal is reached from the part of the circle ahead of it.
  bool reaches_goal(const Entry& entry) {
    const Arrival at = arrival_at(entry.kind(), entry.parent(), entry.index());
    const std::uint32_t c = at.circle;
    const double heading = at.heading;
    const Side side = graph_.circles()[c].side;
    const double reach = graph_.free_headings(c).reach(heading, side);
    if (reach < 0.0) return false;
    double limit = kInfinity;
    for (std::uint32_t i = w_.first_arc.get(c); i != kNone; i = w_.arcs[i].next) {
      const ReachedArc& other = w_.arcs[i];
      if (turn_between(other.heading, heading, side) <= other.reach) return false;
      const double ahead = turn_between(heading, other.heading, side);
      if (ahead <= reach) limit = std::min(limit, ahead);
    }
    const bool free = entry.kind() == Kind::kStart ? is_free(w_.start_links[entry.index()].line)
                                                   : graph_.is_kept(entry.parent(), entry.index());
    if (!free) return false;
    result_.start_connected = true;
    w_.arcs.push_back({heading, reach, w_.first_arc.get(c)});
    w_.first_arc.set(c, static_cast<std::uint32_t>(w_.arcs.size() - 1));
    for (std::uint32_t g = w_.first_goal_link.get(c); g != kNone; g = w_.goal_links[g].next) {
      GoalLink& goal = w_.goal_links[g];
      if (turn_between(heading, goal.link.line.start.heading, side) <= reach && is_free(goal)) return true;
    }
    walk_links(c, heading, [&](std::uint32_t index, const FeasibleGraph::Link&, double turn) {
      if (turn > reach || turn >= limit) return false;
      push_arrival(Kind::kGraph, c, index);
      return true;
    });
    return false;
  }

  // Calls visit(index, link, turn) for the links that leave a circle, from a heading on, until a call returns false.
  template <class Visitor>
  void walk_links(std::uint32_t c, double heading, Visitor&& visit) const {
    const std::span<const FeasibleGraph::Link> links = graph_.links_from(c);
    const std::size_t count = links.size();
    const Side side = graph_.circles()[c].side;
    for (std::size_t step = 0, at = first_ahead(links, heading, side); step < count; ++step) {
      if (!visit(static_cast<std::uint32_t>(at), links[at], turn_between(heading, links[at].heading, side))) return;
      at = side == Side::kLeft ? (at + 1) % count : (at + count - 1) % count;
    }
  }

  // The exact time of the whole path from a label on by a goal link.
  double time_to_goal(std::uint32_t joint, double turn, const TurnCircle& circle, const TerminalLink& link) {
    const TerminalCircle& to = w_.goal_circles[link.terminal_circle];
    const Path& connection = goals_[to.terminal].connection;
    const std::size_t size = w_.speeds.size();
    joint = drive(joint, turn * circle.radius, circle.radius, link.line.length, to.circle.radius);
    Stretch stretch{link.turn * to.circle.radius, vehicle_.turn_speed(to.circle.radius), Gear::kForward};
    for (const PathSegment& segment : connection) {
      const Stretch next = stretch_of(segment);
      joint = add_stretch(joint, stretch, next);
      stretch = next;
    }
    joint = add_stretch(joint, stretch, {0.0, 0.0, stretch.gear});
    const double time = w_.speeds[joint].time;
    w_.speeds.truncate(size);
    return time;
  }

  // Position of the first link at or ahead of a heading in turning direction.
  [[nodiscard]] static std::size_t first_ahead(std::span<const FeasibleGraph::Link> links, double heading, Side side) {
    const bool left = side == Side::kLeft;
    const double from = wrap_positive(left ? heading - kNoTurn : heading + kNoTurn);
    const auto first = std::partition_point(links.begin(), links.end(), [&](const FeasibleGraph::Link& link) {
      return left ? link.heading < from : link.heading <= from;
    });
    const auto count = static_cast<std::size_t>(first - links.begin());
    if (left) return count < links.size() ? count : 0;
    return count > 0 ? count - 1 : links.size() - 1;
  }

  [[nodiscard]] Path path_through(std::uint32_t last, const TerminalLink& goal) const {
    std::vector<std::uint32_t> chain;  // labels, last first
    for (std::uint32_t at = last; at != kNone; at = w_.labels[at].parent) chain.push_back(at);
    const TerminalLink& start = w_.start_links[w_.labels[chain.back()].index];
    const TerminalCircle& from = w_.start_circles[start.terminal_circle];
    Path path = starts_[from.terminal].connection;
    append_arc(path, from.circle, from.heading, start.turn);
    append_line(path, start.line.start, start.line.length);
    for (std::size_t i = chain.size(); i-- > 0;) {
      const Label& label = w_.labels[chain[i]];
      const TurnCircle& circle = graph_.circles()[label.circle];
      const bool at_end = i == 0;
      const FeasibleGraph::Link* link =
          at_end ? nullptr : &graph_.links_from(label.circle)[w_.labels[chain[i - 1]].index];
      const double heading = at_end ? goal.line.start.heading : link->heading;
      append_arc(path, circle, label.heading, turn_between(label.heading, heading, circle.side));
      append_line(path, pose_on(circle, heading), at_end ? goal.line.length : link->length);
    }
    const TerminalCircle& to = w_.goal_circles[goal.terminal_circle];
    append_arc(path, to.circle, goal.line.start.heading, goal.turn);
    const Path& connection = goals_[to.terminal].connection;
    path.insert(path.end(), connection.begin(), connection.end());
    return path;
  }

  static constexpr std::size_t kMostDirectPairs = 64;
  static constexpr std::size_t kLargestPocket = 4096;  // departures
  static constexpr std::size_t kOpen = 5000;           // arcs, more than a pocket round the start has
  static constexpr std::size_t kFirstDoubt = 256;      // labels, more than most searches take

  const SearchMap& map_;
  const FeasibleGraph& graph_;
  const Vehicle vehicle_;
  double line_speed_;
  double top_speed_;  // in either gear, as connections may have both
  std::span<const Terminal> starts_;
  std::span<const Terminal> goals_;
  const SearchOptions& options_;
  Vec2 goal_;
  bool reachability_known_ = false;
  SearchWorkspace::Data& w_;
  SearchResult& result_;
};

}  // namespace

SearchResult search_arrivals(const SearchMap& map, std::span<const Terminal> starts, std::span<const Terminal> goals,
                             const SearchOptions& options, SearchWorkspace& workspace) {
  SearchResult result;
  ArrivalSearch(map, starts, goals, options, *workspace, result).run();
  return result;
}

}  // namespace arcway
