#include "core/search/arrival_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/geometry/angle.h"
#include "core/path/dubins.h"
#include "core/path/speed_profile.h"

namespace arcway {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void append_arc(Path& path, const TurnCircle& circle, double from_heading, double turn) {
  if (turn > 0.0)
    path.push_back({pose_on(circle, from_heading), turn * circle.radius, sign_of(circle.side) / circle.radius});
}

void append_line(Path& path, const Pose& start, double length) {
  if (length > 0.0) path.push_back({start, length, 0.0});
}

struct TerminalCircle {
  std::uint32_t terminal;
  TurnCircle circle;
  double heading;  // of the terminal's pose
  double reach;    // how far the circle is free from there, forwards for starts and backwards for goals
};

// A straight that joins a circle to a terminal's circle.
struct TerminalLink {
  std::uint32_t terminal_circle;
  std::uint32_t circle;
  Bitangent line;
  double turn;                                                 // on the terminal's circle
  double best_cost = std::numeric_limits<double>::infinity();  // of the goal, by this straight, as far as known
};

enum class Kind : std::uint8_t { kGraph, kStart, kGoal, kDirect };

struct Entry {
  double estimate;
  double cost;  // at the far end of the straight; for complete paths, in all
  std::uint64_t order;
  Kind kind;
  std::uint32_t index;
  bool operator<(const Entry& other) const {  // the priority queue has the largest on top
    if (estimate != other.estimate) return estimate > other.estimate;
    return order > other.order;
  }
};

// Where a walk on a circle began: a graph link or a start link that arrived there.
struct Parent {
  Kind kind = Kind::kStart;
  std::uint32_t index = kNone;
};

class ArrivalSearch {
 public:
  ArrivalSearch(const FeasibleGraph& graph, const Vehicle& vehicle, const SweepQuery& sweep,
                std::span<const Terminal> starts, std::span<const Terminal> goals, const SearchOptions& options)
      : graph_(graph),
        vehicle_(vehicle),
        sweep_(sweep),
        starts_(starts),
        goals_(goals),
        options_(options),
        body_(vehicle.footprint(0.5 * vehicle.safety_margin())),
        departure_cost_(graph.links().size(), kInfinity),
        departure_parent_(graph.links().size()),
        closed_(graph.links().size(), 0),
        goal_links_(graph.circles().size()),
        goal_links_known_(graph.circles().size(), 0) {}

  SearchResult run() {
    start_circles_ = circles_of(starts_, Side::kLeft);
    goal_circles_ = circles_of(goals_, Side::kRight);
    push_direct_paths();
    push_start_links();
    while (!open_.empty()) {
      const Entry entry = open_.top();
      open_.pop();
      if (entry.kind == Kind::kDirect) {
        result_.path = direct_paths_[entry.index];
        break;
      }
      if (entry.kind == Kind::kGoal) {
        if (!is_free(goal_steps_[entry.index].link.line)) continue;
        result_.path = path_through(entry.index);
        break;
      }
      if (entry.kind == Kind::kGraph) {
        if (closed_[entry.index]) continue;
        closed_[entry.index] = 1;
      } else if (!is_free(start_links_[entry.index].line)) {
        continue;
      }
      result_.start_connected = true;
      ++result_.nodes_expanded;
      walk(entry);
    }
    return std::move(result_);
  }

 private:
  struct GoalStep {
    TerminalLink link;
    Parent parent;
  };

  // Circles of the terminals' poses. `forwards` is the side whose headings grow along the motion: starts are left
  // forwards, goals are left backwards.
  std::vector<TerminalCircle> circles_of(std::span<const Terminal> terminals, Side growing) {
    std::vector<TerminalCircle> circles;
    std::vector<TurningBody> bodies;
    for (std::uint32_t t = 0; t < terminals.size(); ++t)
      for (const double radius : options_.radii)
        for (const Side side : {Side::kLeft, Side::kRight}) {
          const Pose& pose = terminals[t].pose;
          const Vec2 center = pose.position() + sign_of(side) * radius * perpendicular(direction_of(pose.heading));
          circles.push_back({t, {center, radius, side, kNone}, wrap_positive(pose.heading), 0.0});
          bodies.push_back({center, radius, side, body_});
        }
    std::vector<HeadingSet> headings(bodies.size());
    sweep_.free_headings(bodies, headings);
    result_.turns_checked += bodies.size();
    for (std::size_t c = 0; c < circles.size(); ++c) {
      const Side towards = growing == Side::kLeft ? circles[c].circle.side : opposite(circles[c].circle.side);
      circles[c].reach = headings[c].reach(circles[c].heading, towards);
    }
    return circles;
  }

  bool is_free(const Bitangent& line) {
    ++result_.straights_checked;
    return sweep_.straight_free(swept_rectangle(line.start, line.length, body_));
  }

  [[nodiscard]] double heuristic(const Vec2& p) const {
    double nearest = kInfinity;
    for (const Terminal& goal : goals_)
      nearest = std::min(nearest, options_.seconds_per_meter * (goal.pose.position() - p).norm() + goal.cost);
    return nearest;
  }

  void push(Kind kind, std::uint32_t index, double cost, double remaining) {
    open_.push({cost + remaining, cost, result_.nodes_pushed++, kind, index});
  }

  // Time of an arc from rest (or to rest), and the speed at its other end.
  struct RestArc {
    double time;
    double speed;
  };
  [[nodiscard]] RestArc rest_arc(double length, double radius, bool at_rest) const {
    const double top = vehicle_.turn_speed(radius);
    if (!at_rest) return {length / top, top};
    const double a = vehicle_.max_acceleration();
    const double speed = std::min(top, std::sqrt(2.0 * a * length));
    return {length > 0.0 ? relaxed_segment_time(length, 0.0, top, speed, a) : 0.0, speed};
  }

  void push_direct_paths() {
    for (const Terminal& start : starts_)
      for (const Terminal& goal : goals_)
        for (const double radius : options_.radii)
          for (const DubinsWord word : kDubinsWords) try_direct(start, goal, radius, word);
  }

  void try_direct(const Terminal& start, const Terminal& goal, double radius, DubinsWord word) {
    // Many terminals mean manoeuvres in a narrow place: only the plain pair of poses is worth all words there.
    if (starts_.size() * goals_.size() > kMostDirectPairs) return;
    const auto middle = dubins_path(word, start.pose, goal.pose, radius);
    if (!middle) return;
    for (const PathSegment& segment : *middle)
      if (!is_free(segment)) return;
    result_.start_connected = result_.goal_reached = true;
    Path path = start.connection;
    path.insert(path.end(), middle->begin(), middle->end());
    path.insert(path.end(), goal.connection.begin(), goal.connection.end());
    const double time = speed_profile(path, vehicle_).total_time;
    direct_paths_.push_back(std::move(path));
    push(Kind::kDirect, static_cast<std::uint32_t>(direct_paths_.size() - 1), time, 0.0);
  }

  bool is_free(const PathSegment& segment) {
    if (segment.is_line()) return is_free(Bitangent{segment.start, segment.length});
    const Side side = segment.curvature > 0.0 ? Side::kLeft : Side::kRight;
    const double radius = 1.0 / std::abs(segment.curvature);
    const Vec2 center =
        segment.start.position() + sign_of(side) * radius * perpendicular(direction_of(segment.start.heading));
    ++result_.turns_checked;
    const HeadingSet headings = sweep_.free_headings(TurningBody{center, radius, side, body_});
    return headings.reach(segment.start.heading, side) >= segment.length / radius;
  }

  void push_start_links() {
    const double a = vehicle_.max_acceleration();
    for (std::uint32_t s = 0; s < start_circles_.size(); ++s) {
      const TerminalCircle& from = start_circles_[s];
      if (from.reach < 0.0) continue;
      for (std::uint32_t c = 0; c < graph_.circles().size(); ++c) {
        if (graph_.free_headings(c).empty()) continue;
        const TurnCircle& to = graph_.circles()[c];
        const auto line = directed_bitangent(from.circle, to);
        if (!line) continue;
        const double turn = turn_between(from.heading, line->start.heading, from.circle.side);
        if (turn > from.reach || !graph_.free_headings(c).contains(line->start.heading)) continue;
        const Terminal& start = starts_[from.terminal];
        const RestArc arc = rest_arc(turn * from.circle.radius, from.circle.radius, start.connection.empty());
        const double cost =
            start.cost + arc.time +
            relaxed_segment_time(line->length, arc.speed, vehicle_.max_speed(), vehicle_.turn_speed(to.radius), a);
        start_links_.push_back({s, c, *line, turn});
        push(Kind::kStart, static_cast<std::uint32_t>(start_links_.size() - 1), cost,
             heuristic(pose_on(to, line->start.heading).position()));
      }
    }
  }

  // Straights from a circle to the goal's circles that are free but for the swept rectangle.
  std::vector<TerminalLink>& goal_links(std::uint32_t c) {
    if (goal_links_known_[c]) return goal_links_[c];
    goal_links_known_[c] = 1;
    for (std::uint32_t g = 0; g < goal_circles_.size(); ++g) {
      const TerminalCircle& to = goal_circles_[g];
      if (to.reach < 0.0) continue;
      const auto line = directed_bitangent(graph_.circles()[c], to.circle);
      if (!line) continue;
      const double turn = turn_between(line->start.heading, to.heading, to.circle.side);
      if (turn > to.reach || !graph_.free_headings(c).contains(line->start.heading)) continue;
      goal_links_[c].push_back({g, c, *line, turn});
    }
    return goal_links_[c];
  }

  // Leaves a circle from the arrival's heading on, as far as its free interval goes.
  void walk(const Entry& entry) {
    const bool from_graph = entry.kind == Kind::kGraph;
    const std::uint32_t c = from_graph ? graph_.links()[entry.index].to : start_links_[entry.index].circle;
    const double arrival =
        from_graph ? graph_.links()[entry.index].heading : start_links_[entry.index].line.start.heading;
    const Parent parent{entry.kind, entry.index};
    const TurnCircle& circle = graph_.circles()[c];
    const double reach = graph_.free_headings(c).reach(arrival, circle.side);
    const double speed = vehicle_.turn_speed(circle.radius);
    const double a = vehicle_.max_acceleration();

    for (TerminalLink& link : goal_links(c)) {
      const double turn = turn_between(arrival, link.line.start.heading, circle.side);
      if (turn > reach) continue;
      result_.goal_reached = true;
      const TerminalCircle& to = goal_circles_[link.terminal_circle];
      const Terminal& goal = goals_[to.terminal];
      const RestArc arc = rest_arc(link.turn * to.circle.radius, to.circle.radius, goal.connection.empty());
      const double cost = entry.cost + turn * circle.radius / speed +
                          relaxed_segment_time(link.line.length, speed, vehicle_.max_speed(), arc.speed, a) + arc.time +
                          goal.cost;
      if (cost >= link.best_cost) continue;
      link.best_cost = cost;
      goal_steps_.push_back({link, parent});
      push(Kind::kGoal, static_cast<std::uint32_t>(goal_steps_.size() - 1), cost, 0.0);
    }

    const std::uint32_t first = graph_.first_link(c);
    const std::uint32_t count = graph_.last_link(c) - first;
    const bool left = circle.side == Side::kLeft;
    for (std::uint32_t step = 0, at = first_ahead(c, arrival); step < count; ++step) {
      const std::uint32_t index = first + at;
      at = left ? (at + 1) % count : (at + count - 1) % count;
      const FeasibleGraph::Link& link = graph_.links()[index];
      const double turn = turn_between(arrival, link.heading, circle.side);
      if (turn > reach) break;
      const double departure = entry.cost + turn * circle.radius / speed;
      if (departure >= departure_cost_[index]) break;  // an earlier arrival has been here and went on from here
      if (closed_[index]) continue;
      departure_cost_[index] = departure;
      departure_parent_[index] = parent;
      const TurnCircle& to = graph_.circles()[link.to];
      const double cost =
          departure + relaxed_segment_time(link.length, speed, vehicle_.max_speed(), vehicle_.turn_speed(to.radius), a);
      push(Kind::kGraph, index, cost, heuristic(pose_on(to, link.heading).position()));
    }
  }

  // Position among a circle's links of the first at or ahead of a heading in turning direction.
  [[nodiscard]] std::uint32_t first_ahead(std::uint32_t c, double heading) const {
    const auto links = graph_.links().subspan(graph_.first_link(c), graph_.last_link(c) - graph_.first_link(c));
    if (links.empty()) return 0;
    const auto count = static_cast<std::uint32_t>(links.size());
    if (graph_.circles()[c].side == Side::kLeft) {
      const double from = wrap_positive(heading - kNoTurn);
      const auto it = std::lower_bound(links.begin(), links.end(), from,
                                       [](const FeasibleGraph::Link& l, double h) { return l.heading < h; });
      return static_cast<std::uint32_t>(it - links.begin()) % count;
    }
    const double from = wrap_positive(heading + kNoTurn);
    const auto it = std::upper_bound(links.begin(), links.end(), from,
                                     [](double h, const FeasibleGraph::Link& l) { return h < l.heading; });
    return (static_cast<std::uint32_t>(it - links.begin()) + count - 1) % count;
  }

  [[nodiscard]] Path path_through(std::uint32_t goal_step) const {
    const GoalStep& last = goal_steps_[goal_step];
    std::vector<std::uint32_t> chain;  // graph links, last first
    Parent at = last.parent;
    while (at.kind == Kind::kGraph) {
      chain.push_back(at.index);
      at = departure_parent_[at.index];
    }
    const TerminalLink& start = start_links_[at.index];
    const TerminalCircle& from = start_circles_[start.terminal_circle];
    Path path = starts_[from.terminal].connection;
    append_arc(path, from.circle, from.heading, start.turn);
    append_line(path, start.line.start, start.line.length);

    std::uint32_t c = start.circle;
    double heading = start.line.start.heading;
    for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
      const FeasibleGraph::Link& link = graph_.links()[*it];
      const TurnCircle& circle = graph_.circles()[c];
      append_arc(path, circle, heading, turn_between(heading, link.heading, circle.side));
      append_line(path, pose_on(circle, link.heading), link.length);
      c = link.to;
      heading = link.heading;
    }
    const TurnCircle& circle = graph_.circles()[c];
    append_arc(path, circle, heading, turn_between(heading, last.link.line.start.heading, circle.side));
    append_line(path, last.link.line.start, last.link.line.length);
    const TerminalCircle& to = goal_circles_[last.link.terminal_circle];
    append_arc(path, to.circle, last.link.line.start.heading, last.link.turn);
    const Path& connection = goals_[to.terminal].connection;
    path.insert(path.end(), connection.begin(), connection.end());
    return path;
  }

  static constexpr std::size_t kMostDirectPairs = 64;

  const FeasibleGraph& graph_;
  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  std::span<const Terminal> starts_;
  std::span<const Terminal> goals_;
  SearchOptions options_;
  Footprint body_;

  std::vector<TerminalCircle> start_circles_;
  std::vector<TerminalCircle> goal_circles_;
  std::vector<TerminalLink> start_links_;
  std::vector<GoalStep> goal_steps_;
  std::vector<Path> direct_paths_;
  std::priority_queue<Entry> open_;

  std::vector<double> departure_cost_;
  std::vector<Parent> departure_parent_;
  std::vector<std::uint8_t> closed_;
  std::vector<std::vector<TerminalLink>> goal_links_;
  std::vector<std::uint8_t> goal_links_known_;
  SearchResult result_;
};

}  // namespace

double relaxed_segment_time(double length, double v1, double v2, double v3, double acceleration) {
  if (!(length > 0.0)) return 0.0;
  const double change = 2.0 * acceleration * length;
  const double entry = std::min(v1, std::sqrt(v3 * v3 + change));
  const double exit = std::min(v3, std::sqrt(entry * entry + change));
  // Rounding of the roots may leave the change a unit in the last place too large for (9) and (10).
  if (std::abs(entry * entry - exit * exit) >= change) return 2.0 * length / (entry + exit);
  return segment_time(length, entry, v2, exit, acceleration);
}

SearchResult search_arrivals(const FeasibleGraph& graph, const Vehicle& vehicle, const SweepQuery& sweep,
                             std::span<const Terminal> starts, std::span<const Terminal> goals,
                             const SearchOptions& options) {
  return ArrivalSearch(graph, vehicle, sweep, starts, goals, options).run();
}

}  // namespace arcway
