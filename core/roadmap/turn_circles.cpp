#include "core/roadmap/turn_circles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/model/world_history.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

std::pair<VertexId, VertexId> vertices_of(const TurnCircle& circle) { return {circle.vertex, circle.second}; }

}  // namespace

// Which vertices share circles, and these circles. The vertices must have their own circles.
struct TurnCircles::PairRule {
  PairRule(const TurnCircles& the_circles, const World& the_world, const CircleRadii& the_radii, const Footprint& body)
      : circles(the_circles),
        world(the_world),
        grown_body(body),
        tightest(the_radii.tightest(body) - 1),
        radius(the_radii[tightest]) {}

  // No circle goes round two vertices that are further apart [m].
  [[nodiscard]] double reach() const {
    const double inner = std::max(inner_side_radius(grown_body, Side::kLeft, radius.left),
                                  inner_side_radius(grown_body, Side::kRight, radius.right));
    return 2.0 * inner * (1.0 + 1e-9);
  }
  // Calls visit(u, w), u < w, for all pairs of some vertices that are not further apart.
  template <class Visitor>
  void visit_within_reach(std::span<const VertexId> vertices, Visitor&& visit) const {
    std::vector<VertexId> by_x(vertices.begin(), vertices.end());
    std::ranges::sort(by_x, {}, [&](VertexId v) { return world.vertex(v).x(); });
    const double most = reach();
    for (auto u = by_x.begin(); u != by_x.end(); ++u) {
      const Vec2& here = world.vertex(*u);
      for (auto w = u + 1; w != by_x.end() && world.vertex(*w).x() - here.x() <= most; ++w)
        if ((world.vertex(*w) - here).norm() <= most) visit(std::min(*u, *w), std::max(*u, *w));
    }
  }
  // Whether a bitangent of their own circles leads backwards.
  [[nodiscard]] bool leads_back(VertexId u, VertexId w) const {
    const Vec2 between = world.vertex(w) - world.vertex(u);
    return std::ranges::any_of(std::array{Side::kLeft, Side::kRight}, [&](Side side) {
      const std::size_t from = circles.first_around(u, side) + 2 * tightest;
      const std::size_t to = circles.first_around(w, side) + 2 * tightest;
      return (circles.circles_[to].center - circles.circles_[from].center).dot(between) <= 0.0;
    });
  }
  // Appends the circles around both.
  void append(VertexId u, VertexId w, std::vector<TurnCircle>& of_pairs) const {
    const Side side = obstacle_side(world, w, world.vertex(u));  // traveling from u to w
    if (obstacle_side(world, u, world.vertex(w)) == side) return;
    const VertexPair pair{u, w, side};
    for (const Side turn : {Side::kLeft, Side::kRight})
      if (const auto circle = turn_circle(world, pair, radius.of(turn), turn, grown_body)) of_pairs.push_back(*circle);
  }

  const TurnCircles& circles;
  const World& world;
  const Footprint& grown_body;
  std::size_t tightest;  // index of the smallest radius that leads around vertices
  SideRadii radius;
};

// The own circles of vertices after a change: those of before where a vertex was there.
struct TurnCircles::OwnRule {
  // Writes those of a convex vertex.
  void write(VertexId v, std::span<TurnCircle> to) const {
    if (const VertexId was = change.before(v); was != kNone) {
      std::ranges::copy(before.all().subspan(before.first_around(was, Side::kLeft), to.size()), to.begin());
      for (TurnCircle& circle : to) circle.vertex = v;
      return;
    }
    auto next = to.begin();
    for (std::size_t k = 0; k < radii.size(); ++k)
      for (const Side side : {Side::kLeft, Side::kRight})
        *next++ = turn_circle(after, v, radii.of(side)[k], side, grown_body);
  }

  const TurnCircles& before;
  const VertexMap& change;
  const World& after;
  const CircleRadii& radii;
  const Footprint& grown_body;
};

TurnCircles::TurnCircles(const World& world, const VisibilityRows& rows, const CircleRadii& radii,
                         const Footprint& grown_body, const Executor& executor)
    : radius_count_(radii.size()), first_(world.vertices().size(), kNone) {
  constexpr std::size_t kGrain = 256;
  HugeVector<VertexId> convex;
  for (VertexId v = 0; v < first_.size(); ++v)
    if (number(world, v, 2 * radius_count_ * convex.size())) convex.push_back(v);
  own_count_ = 2 * radius_count_ * convex.size();
  unused_count_ = own_count_ - 2 * radius_count_ * world.graph_vertex_count();
  circles_.reserve(own_count_ + own_count_ / 8);  // for those of two vertices
  circles_.resize(own_count_);
  executor.begin_stage("turn circles");
  executor.for_ranges(convex.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::size_t c = 2 * radius_count_ * i;
      for (std::size_t k = 0; k < radius_count_; ++k)
        for (const Side side : {Side::kLeft, Side::kRight})
          circles_[c++] = turn_circle(world, convex[i], radii.of(side)[k], side, grown_body);
    }
  });

  const PairRule rule{*this, world, radii, grown_body};
  const auto leads_back = [&](VertexId u, VertexId w) { return rule.leads_back(u, w); };
  std::vector<TurnCircle> of_pairs;
  for (const auto& [u, w] : rows.pairs_within(rule.reach(), leads_back, executor)) rule.append(u, w, of_pairs);
  circles_.insert(circles_.end(), of_pairs.begin(), of_pairs.end());
  base_count_ = first_of_gap_straights_ = circles_.size();
  more_ = by_vertex(own_count_, base_count_, executor.clock());
}

TurnCircles::~TurnCircles() {
  if (!origin_.room) return;
  origin_.room->circles.swap(circles_);
  origin_.room->first.swap(first_);
  origin_.spare->give(std::move(origin_.room));
}

bool TurnCircles::number(const World& world, VertexId v, std::size_t next) {
  first_[v] = kNone;
  if (!world.is_convex(v)) return false;
  first_[v] = static_cast<std::uint32_t>(next) | (world.is_covered(v) ? kCovered : 0);
  return true;
}

bool TurnCircles::exchange(const World::VertexRange& range, const OwnRule& rule) {
  const auto here = std::span(first_).subspan(range.first, range.last - range.first);
  const auto begin = std::ranges::find_if(here, [](std::uint32_t first) { return first != kNone; });
  const auto were = here.size() - static_cast<std::size_t>(std::ranges::count(here, kNone));
  std::size_t are = 0;
  for (VertexId v = range.first; v < range.last; ++v) are += rule.after.is_convex(v) ? 1 : 0;
  if (are != were) return false;
  std::size_t next = were == 0 ? 0 : *begin & ~kCovered;
  for (VertexId v = range.first; v < range.last; ++v) {
    if (!number(rule.after, v, next)) continue;
    rule.write(v, std::span(circles_).subspan(next, 2 * radius_count_));
    next += 2 * radius_count_;
  }
  return true;
}

void TurnCircles::take_arrays(const OwnRule& rule) {
  const WorldHistory& history = rule.after.history();
  const std::unique_ptr<Arrays> gone = origin_.spare->take();
  origin_.room = std::make_unique<Arrays>(Arrays{history, {}, {}});
  if (!gone) return;
  circles_.swap(gone->circles);
  first_.swap(gone->first);
  const auto is_convex = [](std::uint32_t first) { return first != kNone; };
  for (const VertexId v : history.flipped_from(gone->history))
    if (v < first_.size() && is_convex(first_[v])) first_[v] ^= kCovered;
  // Where the vertices are the same ones, so are the indices of circles, behind others as long as these are as many.
  std::size_t same =
      std::min<std::size_t>({first_.size(), rule.after.vertices().size(), history.aligned_with(gone->history)});
  for (const World::VertexRange& range : history.map().added_in_either(gone->history.map())) {
    if (range.first >= same) break;
    if (range.last > same || !exchange(range, rule)) same = range.first;
  }
  first_.resize(same);
  const auto last = std::find_if(first_.rbegin(), first_.rend(), is_convex);
  circles_.resize(last == first_.rend() ? 0 : (*last & ~kCovered) + 2 * radius_count_);
}

// Many parameters because it is made of two worlds.
TurnCircles::TurnCircles(const TurnCircles& before, const VertexMap& change, const World& after,
                         const VisibilityRows& rows, std::span<const VertexId> may_differ, const CircleRadii& radii,
                         const Footprint& grown_body)
    : radius_count_(before.radius_count_), origin_(before.origin_) {
  const OwnRule own{before, change, after, radii, grown_body};
  take_arrays(own);
  const std::size_t most = before.own_count_ + 2 * radius_count_ * change.added_count();
  circles_.reserve(most + most / 8);  // for those of two vertices
  auto v = static_cast<VertexId>(first_.size());
  first_.resize(after.vertices().size());
  for (; v < first_.size(); ++v) {
    const std::size_t next = circles_.size();
    if (!number(after, v, next)) continue;
    circles_.resize(next + 2 * radius_count_);
    own.write(v, std::span(circles_).subspan(next));
  }
  own_count_ = circles_.size();
  unused_count_ = own_count_ - 2 * radius_count_ * after.graph_vertex_count();

  std::vector<TurnCircle> fresh;
  const PairRule rule{*this, after, radii, grown_body};
  rule.visit_within_reach(may_differ, [&](VertexId u, VertexId w) {
    if (rule.leads_back(u, w) && std::ranges::binary_search(rows.of(u), w)) rule.append(u, w, fresh);
  });
  std::ranges::stable_sort(fresh, {}, vertices_of);
  take_pairs(before, change, pairs_gone(before, change, after, may_differ), fresh);
}

std::vector<std::uint32_t> TurnCircles::pairs_gone(const TurnCircles& before, const VertexMap& change,
                                                   const World& after, std::span<const VertexId> may_differ) const {
  std::vector<std::uint32_t> gone;
  const auto may_be_other = [&](VertexId v) { return std::ranges::binary_search(may_differ, v); };
  const auto look_at = [&](std::uint32_t c) {
    const VertexId v = change.after(before.circles_[c].vertex), w = change.after(before.circles_[c].second);
    if (v == kNone || w == kNone || !has(v) || !has(w) || (may_be_other(v) && may_be_other(w))) gone.push_back(c);
  };
  const WorldHistory& history = after.history();
  if (!before.origin_.room || !history.has_origin_of(before.origin_.room->history)) {
    for (auto c = static_cast<std::uint32_t>(before.own_count_); c < before.base_count_; ++c) look_at(c);
    return gone;
  }
  // Where nothing was near the change, to look for circles of each vertex costs most of it on large maps.
  const auto look_around = [&](VertexId was) {
    if (was == kNone) return;
    for (const CirclesByVertex::Entry& entry : before.more_.of(was))
      if (entry.circle < before.base_count_) look_at(entry.circle);
  };
  for (const World::VertexRange& range : change.removed())
    for (VertexId v = range.first; v < range.last; ++v) look_around(v);
  for (const VertexId v : history.flipped_from(before.origin_.room->history)) look_around(change.before(v));
  for (const World::VertexRange& range : history.map().added())  // the history does not tell whether they flipped
    for (VertexId v = range.first; v < range.last; ++v) look_around(change.before(v));
  for (const VertexId v : may_differ) look_around(change.before(v));
  std::ranges::sort(gone);
  gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
  return gone;
}

void TurnCircles::take_pairs(const TurnCircles& before, const VertexMap& change, std::span<const std::uint32_t> gone,
                             std::span<const TurnCircle> fresh) {
  const bool stay = change.keeps_numbers();
  const auto moved = [&](VertexId v) { return stay ? v : change.after(v); };
  std::vector<std::uint32_t> now(before.base_count_ - before.own_count_, kNone);  // number of each one of before
  std::vector<CirclesByVertex::Entry> of_fresh;
  auto next_gone = gone.begin();
  auto next_fresh = fresh.begin();
  const auto append_fresh = [&] {
    for (const VertexId v : {next_fresh->vertex, next_fresh->second})
      of_fresh.push_back({v, static_cast<std::uint32_t>(circles_.size())});
    circles_.push_back(*next_fresh++);
  };
  for (std::size_t c = before.own_count_; c < before.base_count_; ++c) {
    if (next_gone != gone.end() && *next_gone == c) {
      ++next_gone;
      continue;
    }
    TurnCircle circle = before.circles_[c];
    circle.vertex = moved(circle.vertex);
    circle.second = moved(circle.second);
    while (next_fresh != fresh.end() && vertices_of(*next_fresh) < vertices_of(circle)) append_fresh();
    now[c - before.own_count_] = static_cast<std::uint32_t>(circles_.size());
    circles_.push_back(circle);
  }
  while (next_fresh != fresh.end()) append_fresh();
  base_count_ = first_of_gap_straights_ = circles_.size();

  std::vector<CirclesByVertex::Entry> entries;
  entries.reserve(before.more_.entries().size() + of_fresh.size());
  for (const CirclesByVertex::Entry& entry : before.more_.entries())
    if (entry.circle < before.base_count_ && now[entry.circle - before.own_count_] != kNone)
      entries.push_back({moved(entry.vertex), now[entry.circle - before.own_count_]});
  const auto first_fresh = static_cast<std::ptrdiff_t>(entries.size());
  entries.insert(entries.end(), of_fresh.begin(), of_fresh.end());
  std::ranges::sort(entries.begin() + first_fresh, entries.end(), {}, &CirclesByVertex::Entry::key);
  std::ranges::inplace_merge(entries, entries.begin() + first_fresh, {}, &CirclesByVertex::Entry::key);
  more_ = CirclesByVertex(std::move(entries), first_.size());
}

TurnCircles::TurnCircles(const TurnCircles& base, const AddedCircles& added, const StopClock& clock)
    : radius_count_(base.radius_count_),
      own_count_(base.own_count_),
      unused_count_(base.unused_count_),
      first_(base.first_),
      base_count_(base.base_count_) {
  std::size_t count = base_count_ + added.around_vertices.size();
  for (const GapStraight& straight : added.gap_straights) count += straight.entries.size() + straight.exits.size();
  circles_.reserve(count);
  // One by one, as memory that is written for the first time takes longest.
  StopTicker ticker(clock);
  const auto append = [&](std::span<const TurnCircle> circles) {
    for (const TurnCircle& circle : circles) {
      end_if_over(ticker);
      circles_.push_back(circle);
    }
  };
  append(base.circles_);
  append(added.around_vertices);
  first_of_gap_straights_ = circles_.size();
  for (const GapStraight& straight : added.gap_straights) {
    append(straight.entries);
    const auto exits = static_cast<std::uint32_t>(circles_.size());
    append(straight.exits);
    gap_straight_.resize(circles_.size() - first_of_gap_straights_, static_cast<std::uint32_t>(gap_straights_.size()));
    gap_straights_.push_back({exits, static_cast<std::uint32_t>(circles_.size())});
  }
  more_ = by_vertex(own_count_, first_of_gap_straights_, clock);
  beside_ = by_vertex(first_of_gap_straights_, circles_.size(), clock);
}

CirclesByVertex TurnCircles::by_vertex(std::size_t first, std::size_t last, const StopClock& clock) const {
  std::vector<CirclesByVertex::Entry> entries;
  StopTicker ticker(clock);
  for (auto c = static_cast<std::uint32_t>(first); c < last; ++c) {
    end_if_over(ticker);
    for (const VertexId v : {circles_[c].vertex, circles_[c].second})
      if (v != kNone) entries.push_back({v, c});
  }
  std::ranges::sort(entries, [&](const CirclesByVertex::Entry& a, const CirclesByVertex::Entry& b) {
    end_if_over(ticker);
    return a.key() < b.key();
  });
  return {std::move(entries), first_.size()};
}

}  // namespace arcway::internal
