#include "core/search/tree_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "core/collision/motion_free.h"
#include "core/model/side_radii.h"
#include "core/motion/biarc.h"
#include "core/motion/dubins.h"
#include "core/search/effort.h"
#include "core/search/forward_tree.h"
#include "core/search/near_poses.h"
#include "core/search/path_ends.h"
#include "core/search/route_field.h"
#include "core/search/surroundings.h"

namespace arcway::internal {

namespace {

constexpr double kSameLength = 1e-9;  // paths whose lengths differ by a smaller share count as duplicates

Direction direction_at(std::size_t end) { return end == kStartEnd ? Direction::kFromStart : Direction::kToGoal; }

class TreeSearch {
 public:
  TreeSearch(const TreeQuery& query, const SearchOptions& options, ArrivalSearch& arrivals, FoundPath& found,
             TreesEnd& end)
      : map_(query.map),
        roots_{query.start, query.goal},
        limits_(query.limits),
        options_(options),
        arrivals_(arrivals),
        end_(end),
        result_(found.search),
        radii_(map_.vehicle),
        body_length_(map_.body.front + map_.body.rear),
        contact_(*map_.outlines, map_.body, map_.one_way_zones.get()) {}

  void run() {
    fields_ = {field(kGoalEnd), field(kStartEnd)};
    std::span<const TreePass> passes = limits_.passes;
    while (!passes.empty()) {
      const TreePass& pass = passes.front();
      passes = passes.subspan(1);
      if (pass.heeds_turns && !std::exchange(heed_turns_, true))
        for (RouteField& field : fields_) field.heed_turns(radii_.smaller(), options_.clock);
      const bool was_explored = is_explored();
      grow(pass);
      if (result_.path || result_.interrupted || end_.surroundings == Surroundings::kClosed) return;
      if (!was_explored && end_.surroundings == Surroundings::kDeadEnd) passes = limits_.dead_end_passes;
    }
  }

 private:
  // The tree of one end.
  struct Side {
    ForwardTree tree;
    NearPoses near;
    std::vector<std::uint32_t> attachments;
    std::unordered_map<std::uint32_t, bool> is_free;  // of the motions that end at nodes, as far as was asked
  };

  // A route to a pose, backwards, is one from the pose turned round.
  static Pose turned_round(const Pose& pose) { return {pose.x, pose.y, pose.heading + kPi}; }

  [[nodiscard]] bool is_explored() const { return is_explored_ || !limits_.surroundings_effort; }

  // Explores the surroundings of the ends whose trees have not left them, once. Returns whether the trees may go on
  // growing. Where they find a path, that is soon in most cases, and the surroundings need not be known.
  bool explore(const std::array<Side, 2>& sides) {
    if (is_explored()) return true;
    is_explored_ = true;
    for (const std::size_t at : {kStartEnd, kGoalEnd}) {
      if (sides[at].tree.extent() >= dead_end_radius(map_)) continue;
      const ExploredSurroundings found =
          explore_surroundings(map_, roots_[at], direction_at(at), *limits_.surroundings_effort, options_.clock);
      end_.poses += found.poses;
      end_.surroundings = std::max(end_.surroundings, found.surroundings);
      if (found.surroundings != Surroundings::kClosed) continue;
      (at == kStartEnd ? end_.start_in_dead_end : end_.goal_in_dead_end) = end_.ran_dry = true;
      break;
    }
    return end_.surroundings == Surroundings::kOpen;
  }

  [[nodiscard]] RouteField field(std::size_t to) const {
    const Pose& pose = roots_[to];
    return {
        map_,
        {roots_[kStartEnd], to == kGoalEnd ? pose : turned_round(pose), limits_.effort.field_cells, limits_.avoided},
        options_.clock};
  }

  [[nodiscard]] Side side(std::size_t at, const TreePass& pass) const {
    return {{map_, roots_[at], direction_at(at), pass,
             [this, at](const Pose& pose) {
               return kTree.greed * fields_[at](at == kStartEnd ? pose : turned_round(pose));
             }},
            NearPoses(limits_.effort.near * body_length_),
            {},
            {}};
  }

  bool interrupted() {
    result_.interrupted = result_.interrupted || options_.interrupted();
    return result_.interrupted;
  }

  void grow(const TreePass& pass) {
    std::array<Side, 2> sides{side(kStartEnd, pass), side(kGoalEnd, pass)};
    std::size_t next_roadmap = limits_.effort.first_roadmap;
    attachments_joined_ = 0;
    std::array<bool, 2> dry{false, false};
    auto most = static_cast<std::size_t>(pass.share * static_cast<double>(limits_.poses));
    const std::uint64_t most_edges = limits_.effort.edges * most;
    const auto edges = [&] { return sides[kStartEnd].tree.edges_compared() + sides[kGoalEnd].tree.edges_compared(); };
    for (std::size_t i = 0; i < most && edges() < most_edges && end_.refused < limits_.effort.most_refused &&
                            !(dry[kStartEnd] && dry[kGoalEnd]) && !interrupted();
         ++i) {
      const std::size_t at = i % 2;
      if (dry[at]) continue;
      const auto node = sides[at].tree.expand();
      if (!node) {
        if (!explore(sides)) return;
        dry[at] = true;
        // The other tree may still come near, but not by growing all over the map.
        most = std::min(most, limits_.effort.after_dry * (i + 1));
        continue;
      }
      ++end_.poses;
      ++grown_;
      join(sides, at, *node);
      if (!result_.path && i + 1 >= next_roadmap) {
        join_roadmap(sides);
        next_roadmap *= limits_.effort.roadmap_factor;
      }
      if (result_.path) return;
    }
    if (interrupted() || !explore(sides)) return;
    const double dead_end = dead_end_radius(map_);
    end_.start_in_dead_end = sides[kStartEnd].tree.extent() < dead_end;
    end_.goal_in_dead_end = sides[kGoalEnd].tree.extent() < dead_end;
    end_.ran_dry = dry[kStartEnd] || dry[kGoalEnd];
    if (!interrupted()) join_roadmap(sides);
  }

  // The nearest poses of a tree that lie ahead, or behind for the tree of the goal.
  void find_near(const Side& other, const Pose& pose, double forwards) {
    const Vec2 ahead = direction_of(pose.heading);
    near_.clear();
    other.near.visit(pose, [&](const NearPoses::Entry& entry) {
      const Vec2 way = forwards * (entry.pose.position() - pose.position());
      const bool is_full = near_.size() == limits_.effort.nearest;
      if (is_full && way.norm() >= near_.back().distance) return;
      if (way.dot(ahead) < 0.0 || way.dot(entry.ahead) < 0.0) return;
      const NearPose found{way.norm() + body_length_ * std::abs(wrap_signed(entry.pose.heading - pose.heading)),
                           entry.node};
      if (is_full && !(found < near_.back())) return;
      if (is_full) near_.pop_back();
      near_.insert(std::upper_bound(near_.begin(), near_.end(), found), found);
    });
  }

  // Joins a new pose to the root of the other tree and to its poses near by.
  void join(std::array<Side, 2>& sides, std::size_t at, std::uint32_t node) {
    const Pose pose = sides[at].tree[node].pose;
    find_near(sides[other_end(at)], pose, at == kStartEnd ? 1.0 : -1.0);
    near_.push_back({0.0, ForwardTree::kRoot});
    for (const NearPose& n : near_)
      if (connect(sides, at, at == kStartEnd ? node : n.node, at == kStartEnd ? n.node : node)) return;
    sides[at].near.add(node, pose);
    add_attachment(sides[at], node);
  }

  // Joins two poses of the trees. The tree of end `at` expanded its pose last.
  bool connect(const std::array<Side, 2>& sides, std::size_t at, std::uint32_t from, std::uint32_t to) {
    const Pose& start = sides[kStartEnd].tree[from].pose;
    const Pose& goal = sides[kGoalEnd].tree[to].pose;
    const auto take = [&](std::span<const PathSegment> between) {
      if (between.empty() || !has_room(sides[at].tree, at == kStartEnd ? between.front() : between.back()))
        return false;
      if (!is_free(between)) return false;
      Path path = sides[kStartEnd].tree.connection(from);
      path.insert(path.end(), between.begin(), between.end());
      const Path rest = sides[kGoalEnd].tree.connection(to);
      path.insert(path.end(), rest.begin(), rest.end());
      if (!motion_free(*map_.queries.sweep, map_.body, path)) return false;
      return take_path(merged(path));
    };
    for (const double ratio : limits_.effort.ratios) {
      const auto arcs = biarc(start, goal, ratio, radii_);
      if (arcs && take(*arcs)) return true;
    }
    for (const DubinsWord word : kDubinsWords) {
      const auto path = dubins_word(word, start, goal, radii_);
      if (path && take(path->segments())) return true;
    }
    return false;
  }

  // Paths that are found one after the other are much alike: some are left out after each that is refused.
  bool take_path(Path path) {
    if (!limits_.accept) {
      result_.path = std::move(path);
      return true;
    }
    if (grown_ < next_asked_) return false;
    const double length = length_of(path);
    if (std::ranges::any_of(refused_, [&](double known) { return std::abs(length - known) <= kSameLength * known; }))
      return false;
    result_.path = limits_.accept(path);
    if (result_.path) return true;
    refused_.push_back(length);
    next_asked_ = grown_ + limits_.effort.refused_poses * ++end_.refused;
    return false;
  }

  static bool has_room(const ForwardTree& tree, const PathSegment& motion) {
    return tree.room(motion.curvature) >= std::min(motion.length, tree.longest_motion());
  }

  bool is_free(std::span<const PathSegment> motion) {
    for (const PathSegment& s : motion) {
      contact_.begin(s.start, s.length);
      if (contact_(s.curvature, Gear::kForward) < s.length) return false;
    }
    return true;
  }

  void add_attachment(Side& side, std::uint32_t node) {
    if (node == ForwardTree::kRoot || side.attachments.size() >= limits_.effort.attachments) return;
    side.attachments.push_back(node);
  }

  // Whether the way between a node and the root is free; many share their motions.
  bool is_connected(Side& side, std::uint32_t node) {
    for (; node != ForwardTree::kRoot; node = side.tree[node].parent) {
      const auto [known, is_new] = side.is_free.try_emplace(node, false);
      if (is_new) known->second = motion_free(*map_.queries.sweep, map_.body, {&side.tree[node].motion, 1});
      if (!known->second) return false;
    }
    return true;
  }

  void join_roadmap(std::array<Side, 2>& sides) {
    const std::size_t attachment_count = sides[kStartEnd].attachments.size() + sides[kGoalEnd].attachments.size();
    if (std::exchange(attachments_joined_, attachment_count) == attachment_count) return;
    const auto attachments = [&](std::size_t at) {
      std::vector<Attachment> found{{roots_[at], {}}};
      for (const std::uint32_t node : sides[at].attachments) {
        if (options_.interrupted()) break;
        if (is_connected(sides[at], node))
          found.push_back({sides[at].tree[node].pose, sides[at].tree.connection(node)});
      }
      return found;
    };
    const std::vector<Attachment> starts = attachments(kStartEnd), goals = attachments(kGoalEnd);
    SearchResult joined = arrivals_.find(map_, starts, goals, options_);
    result_.counts += joined.counts;
    result_.interrupted = result_.interrupted || joined.interrupted;
    if (joined.path) take_path(std::move(*joined.path));
  }

  const Roadmap& map_;
  std::array<Pose, 2> roots_;
  TreeLimits limits_;
  const SearchOptions& options_;
  ArrivalSearch& arrivals_;
  TreesEnd& end_;
  SearchResult& result_;
  SideRadii radii_;
  double body_length_;
  bool is_explored_ = false;     // the surroundings of both ends
  std::size_t grown_ = 0;        // poses of the trees
  std::size_t next_asked_ = 0;   // number of these before which no path is offered to `accept`
  std::vector<double> refused_;  // lengths of the paths that were refused [m]
  ContactReach contact_;
  std::vector<RouteField> fields_;  // by end: routes to the other one
  bool heed_turns_ = false;
  std::size_t attachments_joined_ = 0;  // to the roadmap, of this pass
  std::vector<NearPose> near_;          // memory of find_near
};

}  // namespace

FoundPath search_trees(const TreeQuery& query, const SearchOptions& options, ArrivalSearch& arrivals, TreesEnd& end) {
  FoundPath found;
  TreeSearch(query, options, arrivals, found, end).run();
  return found;
}

}  // namespace arcway::internal
