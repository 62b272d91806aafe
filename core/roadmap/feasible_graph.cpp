#include "core/roadmap/feasible_graph.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/snapshot.h"
#include "core/base/bytes.h"
#include "core/geometry/tiles.h"
#include "core/roadmap/circle_change.h"
#include "core/roadmap/destinations.h"
#include "core/roadmap/require_snapshot.h"
#include "core/roadmap/slot_cache.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

using Link = FeasibleGraph::Link;

// A turn round the thinnest vertex begins and ends at a right angle to the heading at the vertex; and a little more.
constexpr double kWidestTurn = 0.55 * kPi;

std::span<const double> checked_radii(std::span<const double> radii) {
  const auto is_radius = [](double radius) { return radius > 0.0 && std::isfinite(radius); };
  if (radii.empty() || !std::ranges::all_of(radii, is_radius) || !std::ranges::is_sorted(radii, std::less_equal<>()))
    throw std::invalid_argument("feasible graph: radii must be positive, finite and ascending, at least one");
  return radii;
}

// Links that leave one circle, and why others do not.
struct Departures {
  std::vector<Link> links;
  LinkCounts counts;
};

enum class Verdict : std::uint8_t { kUnknown, kKept, kArrival, kStraight };

// Links of which each is decided when it is first asked for.
struct LazyRow {
  explicit LazyRow(Departures d) : departures(std::move(d)), verdicts(departures.links.size()) {}
  Departures departures;
  mutable std::vector<std::atomic<Verdict>> verdicts;
};

}  // namespace

struct FeasibleGraph::Data {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): not moved on, as the circles look at it as well
  Data(const World& w, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> r, QuerySet q,
       std::span<const double> radii, GraphMode m, const Executor& executor)
      : Data(w, vehicle, r, std::move(q), checked_radii(radii).front(),
             TurnCircles(w, *r, checked_radii(radii), vehicle.footprint(vehicle.safety_margin()), executor), m) {}

  Data(const World& w, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> r, QuerySet q, double smallest,
       TurnCircles c, GraphMode m)
      : world(w),
        queries(std::move(q)),
        body(vehicle.footprint(0.5 * vehicle.safety_margin())),
        body_covers_reference(body.front >= 0.0 && body.rear >= 0.0),
        mode(m),
        smallest_radius(smallest),
        rows(std::move(r)),
        turn_circles(std::move(c)),
        destinations(world, *rows, turn_circles),
        circles(turn_circles.all()),
        lazy_headings(m == GraphMode::kLazy ? circles.size() : 0),
        lazy_rows(m == GraphMode::kLazy ? circles.size() : 0) {
    counts.circles = circles.size();
  }

  void check_all(const Executor& executor, const ProcessGroup& process_group) {
    const auto [begin, end] = process_group.share_of(circles.size());
    std::vector<std::uint32_t> share(end - begin);
    std::iota(share.begin(), share.end(), static_cast<std::uint32_t>(begin));
    headings.resize(circles.size());
    find_headings(share, executor);
    if (process_group.size() > 1) exchange_headings(share, process_group);

    const std::vector<Departures> found = find_kept(share, executor);
    if (process_group.size() > 1) {
      exchange_rows(found, process_group);
    } else {
      for (const Departures& row : found) append(row.links, row.counts);
    }
    count_all();
  }

  // What another graph has found out, as far as a change of the world leaves it; the rest as the mode says.
  void take_over(const Data& before, const WorldChange& change, const Footprint& grown_body, const Executor& executor) {
    const CircleChange kept({before.world, *before.rows, before.turn_circles}, {world, *rows, turn_circles}, change,
                            grown_body, Destinations::kMostSteps);
    headings.resize(circles.size());
    known_headings.resize(circles.size());
    known_rows.resize(circles.size());
    executor.begin_stage("changes");
    executor.for_ranges(circles.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
        const HeadingSet* free = keeps_headings(c, kept) ? before.find_headings(kept.before(c)) : nullptr;
        if (free) headings[c] = *free;
        known_headings[c] = free ? 1 : 0;
        const bool keeps = keeps_row(c, kept);
        known_rows[c] = keeps && before.has_row(kept.before(c)) ? 1 : 0;
        if (!keeps || known_rows[c] || mode == GraphMode::kEager) continue;
        if (const LazyRow* row = before.lazy_rows.find(kept.before(c)))
          lazy_rows.get(c, [&] { return moved_row(*row, c, kept); });
      }
    });

    std::vector<Departures> found;
    if (mode == GraphMode::kEager) {
      find_headings(those_without(known_headings), executor);
      found = find_kept(those_without(known_rows), executor);
    }
    auto next = found.begin();
    for (std::uint32_t c = 0; c < circles.size(); ++c) {
      if (known_rows[c]) {
        append(moved_links(before.links_of(kept.before(c)), c, kept), before.link_counts[kept.before(c)]);
      } else if (mode == GraphMode::kEager) {
        append(next->links, next->counts);
        ++next;
      } else {
        append({}, {});
      }
    }
    count_all();
  }

  [[nodiscard]] bool keeps_headings(std::uint32_t c, const CircleChange& kept) const {
    return kept.before(c) != kNone && kept.is_quiet_at(circles[c].vertex);
  }

  // Whether the same vertices are arrived at from a circle, and the ways there are as free as before.
  [[nodiscard]] bool keeps_row(std::uint32_t c, const CircleChange& kept) const {
    const TurnCircle& circle = circles[c];
    if (kept.before(c) == kNone || !kept.keeps_row(circle.vertex)) return false;
    if (circle.second != kNone && !kept.keeps_row(circle.second)) return false;
    for (const VertexId u : {circle.vertex, circle.second})
      if (const VertexId before = u == kNone ? kNone : destinations.vertex_before(u, circle.side);
          before != kNone && !kept.keeps_row(before))
        return false;
    if (circle.second == kNone && kept.is_still_around(circle.vertex)) return true;
    return std::ranges::all_of(destinations.from(circle), [&](const Destinations::Arrival& arrival) {
      return kept.keeps_row(arrival.vertex) && kept.is_quiet_between(circle.vertex, arrival.vertex);
    });
  }

  [[nodiscard]] static std::vector<Link> moved_links(std::span<const Link> before, std::uint32_t c,
                                                     const CircleChange& kept) {
    std::vector<Link> moved(before.begin(), before.end());
    for (Link& link : moved) {
      link.from = c;
      link.to = kept.after(link.to);
    }
    return moved;
  }

  [[nodiscard]] static std::unique_ptr<const LazyRow> moved_row(const LazyRow& before, std::uint32_t c,
                                                                const CircleChange& kept) {
    auto row =
        std::make_unique<LazyRow>(Departures{moved_links(before.departures.links, c, kept), before.departures.counts});
    for (std::size_t i = 0; i < row->verdicts.size(); ++i)
      row->verdicts[i].store(before.verdicts[i].load(std::memory_order_relaxed), std::memory_order_relaxed);
    return row;
  }

  [[nodiscard]] static std::vector<std::uint32_t> those_without(const std::vector<std::uint8_t>& known) {
    std::vector<std::uint32_t> unknown;
    for (std::uint32_t c = 0; c < known.size(); ++c)
      if (!known[c]) unknown.push_back(c);
    return unknown;
  }

  void take(FeasibleGraphSnapshot known) {
    require_snapshot(known, circles.size());
    take_headings(known);
    links = std::move(known.links);
    link_starts = std::move(known.link_starts);
    link_counts = std::move(known.link_counts);
    count_all();
  }

  void find_headings(std::span<const std::uint32_t> which, const Executor& executor) {
    const std::vector<std::uint32_t> order = places_along_curve(which);
    executor.begin_stage("free headings");
    executor.for_ranges(which.size(), 16, [&](std::size_t begin, std::size_t end) {
      std::vector<TurningBody> bodies;
      for (std::size_t i = begin; i < end; ++i) bodies.push_back(body_on(circles[which[order[i]]]));
      std::vector<HeadingSet> found(bodies.size());
      queries.sweep->free_headings(bodies, found);
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t c = which[order[i]];
        keep_at_vertex(c, found[i - begin]);
        headings[c] = std::move(found[i - begin]);
      }
    });
  }

  [[nodiscard]] std::vector<Departures> find_kept(std::span<const std::uint32_t> which,
                                                  const Executor& executor) const {
    std::vector<Departures> found(which.size());
    const std::vector<std::uint32_t> order = places_along_curve(which);
    const StopClock clock = executor.clock();
    executor.begin_stage("bitangents");
    executor.for_ranges(which.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) found[order[i]] = kept_departures(which[order[i]], clock);
    });
    return found;
  }

  // Circles by their places in `which`, near ones one after the other: they ask about the same parts of the map.
  [[nodiscard]] std::vector<std::uint32_t> places_along_curve(std::span<const std::uint32_t> which) const {
    const Tiles tiles(world.box(), which.size());
    std::vector<std::uint32_t> tile;
    tile.reserve(which.size());
    for (const std::uint32_t c : which) tile.push_back(tiles.of(circles[c].center));
    return sorted_by_tile(std::move(tile), tiles.count());
  }

  void exchange_headings(std::span<const std::uint32_t> share, const ProcessGroup& process_group) {
    std::string bytes;
    for (const std::uint32_t c : share) {
      append_bytes(bytes, static_cast<std::uint32_t>(headings[c].intervals().size()));
      append_bytes(bytes, headings[c].intervals());
    }
    const std::vector<std::string> all = process_group.gather(std::move(bytes));
    for (std::size_t rank = 0; rank < process_group.size(); ++rank) {
      if (rank == process_group.rank()) continue;
      const auto [begin, end] = process_group.share_of(circles.size(), rank);
      std::string_view rest = all[rank];
      for (std::size_t c = begin; c < end; ++c) {
        const auto size = take_bytes<std::uint32_t>(rest);
        headings[c] = HeadingSet::of_intervals(take_bytes<HeadingInterval>(rest, size));
      }
    }
  }

  void exchange_rows(std::span<const Departures> share, const ProcessGroup& process_group) {
    std::string bytes;
    for (const Departures& row : share) {
      append_bytes(bytes, static_cast<std::uint32_t>(row.links.size()));
      append_bytes(bytes, row.counts);
      append_bytes(bytes, std::span<const Link>(row.links));
    }
    for (std::string_view rest : process_group.gather(std::move(bytes))) {
      while (!rest.empty()) {
        const auto size = take_bytes<std::uint32_t>(rest);
        const auto reasons = take_bytes<LinkCounts>(rest);
        append(take_bytes<Link>(rest, size), reasons);
      }
    }
  }

  void append(std::span<const Link> row, const LinkCounts& counts_of_row) {
    links.insert(links.end(), row.begin(), row.end());
    link_starts.push_back(links.size());
    link_counts.push_back(counts_of_row);
  }

  void count_all() {
    for (std::uint32_t c = 0; c < circles.size(); ++c)
      counts.circles_blocked += has_headings(c) && headings[c].empty() ? 1 : 0;
    for (const LinkCounts& row : link_counts) count(row, counts);
    counts.kept = links.size();
  }

  void take_headings(const FeasibleGraphSnapshot& known) {
    headings.resize(circles.size());
    for (std::size_t c = 0; c < circles.size(); ++c) {
      const auto row = std::span(known.intervals)
                           .subspan(known.interval_starts[c], known.interval_starts[c + 1] - known.interval_starts[c]);
      try {
        headings[c] = HeadingSet::of_intervals({row.begin(), row.end()});
      } catch (const std::invalid_argument& error) {
        throw SnapshotError(SnapshotArray::kIntervals, known.interval_starts[c],
                            "of circle " + std::to_string(c) + ": " + error.what());
      }
    }
  }

  [[nodiscard]] Departures kept_departures(std::uint32_t c, const StopClock& clock) const {
    Departures row = departures(c, clock);
    row.counts.arrivals = static_cast<std::uint32_t>(
        std::erase_if(row.links, [&](const Link& link) { return !headings[link.to].contains(link.heading); }));
    std::vector<SweptRectangle> rectangles;
    rectangles.reserve(row.links.size());
    for (const Link& link : row.links) rectangles.push_back(swept_by(link));
    std::vector<std::uint8_t> free(rectangles.size());
    queries.sweep->straight_free(rectangles, free);
    std::vector<Link> kept;
    for (std::size_t i = 0; i < row.links.size(); ++i)
      if (free[i]) kept.push_back(row.links[i]);
    row.counts.straights = static_cast<std::uint32_t>(row.links.size() - kept.size());
    row.links = std::move(kept);
    return row;
  }

  // Calls visit(circle) for those that a straight from a circle may lead to, for some of them repeatedly.
  template <class Visitor>
  void visit_destinations(std::uint32_t c, const StopClock& clock, Visitor&& visit) const {
    const TurnCircle& circle = circles[c];
    if (!turn_circles.is_of_gap_straight(c)) {
      for (const Destinations::Arrival& arrival : destinations.from(circle, clock))
        turn_circles.visit_around(arrival.vertex, arrival.side, visit);
    } else if (!turn_circles.is_exit(c)) {
      return turn_circles.visit_exits_behind(c, visit);
    }
    if (turn_circles.base_count() == circles.size()) return;
    for (const VertexId u : {circle.vertex, circle.second}) {
      if (u == kNone) continue;
      turn_circles.visit_entries(u, visit);
      for (const VertexId v : rows->of(u)) turn_circles.visit_entries(v, visit);
      if (!turn_circles.is_of_gap_straight(c)) continue;
      for (const Side side : {Side::kLeft, Side::kRight}) turn_circles.visit_around(u, side, visit);
      for (const VertexId v : rows->of(u))
        turn_circles.visit_around(v, obstacle_side(world, v, world.vertex(u)), visit);
    }
  }

  // Bitangents that leave a circle at a free heading.
  [[nodiscard]] Departures departures(std::uint32_t c, const StopClock& clock) const {
    const TurnCircle& circle = circles[c];
    const HeadingSet& free = headings_of(c);
    Departures row;
    StopTicker ticker(clock);
    visit_destinations(c, clock, [&](std::uint32_t to) {
      end_if_over(ticker);
      ++row.counts.candidates;
      const auto line = directed_bitangent(circle, circles[to]);
      if (!line) {
        ++row.counts.overlaps;
      } else if (!free.contains(line->start.heading)) {
        ++row.counts.departures;
      } else {
        row.links.push_back({c, to, line->start.heading, line->length});
      }
    });
    std::sort(row.links.begin(), row.links.end(), [](const Link& a, const Link& b) {
      if (a.heading != b.heading) return a.heading < b.heading;
      return a.to < b.to;
    });
    // Circles that know two vertices are found at both.
    const auto repeated =
        std::unique(row.links.begin(), row.links.end(), [](const Link& a, const Link& b) { return a.to == b.to; });
    row.counts.repeated = static_cast<std::uint32_t>(row.links.end() - repeated);
    row.links.erase(repeated, row.links.end());
    return row;
  }

  [[nodiscard]] const HeadingSet& headings_of(std::uint32_t c) const {
    if (base && c < base->circles.size()) return base->headings_of(c);
    if (has_headings(c)) return headings[c];
    return lazy_headings.get(c, [&] {
      auto found = std::make_unique<HeadingSet>(queries.sweep->free_headings(body_on(circles[c])));
      keep_at_vertex(c, *found);
      return std::unique_ptr<const HeadingSet>(std::move(found));
    });
  }

  // A wide circle passes through much that has nothing to do with its vertex; there the smallest radius turns as well.
  void keep_at_vertex(std::uint32_t c, HeadingSet& found) const {
    if (circles[c].radius == smallest_radius || !body_covers_reference) return;
    found = found.around(heading_at_vertex(world, circles[c]), kWidestTurn);
  }

  // Whether a circle's headings, or row, were all found when the graph was made.
  [[nodiscard]] bool has_headings(std::uint32_t c) const {
    return mode == GraphMode::kEager || (!known_headings.empty() && known_headings[c]);
  }
  [[nodiscard]] bool has_row(std::uint32_t c) const {
    return mode == GraphMode::kEager || (!known_rows.empty() && known_rows[c]);
  }
  [[nodiscard]] const HeadingSet* find_headings(std::uint32_t c) const {
    return has_headings(c) ? &headings[c] : lazy_headings.find(c);
  }
  // Of a circle that has its row.
  [[nodiscard]] std::span<const Link> links_of(std::uint32_t c) const {
    return std::span(links).subspan(link_starts[c], link_starts[c + 1] - link_starts[c]);
  }

  [[nodiscard]] const LazyRow& lazy_row(std::uint32_t c, const StopClock& clock = {}) const {
    return lazy_rows.get(c, [&] { return std::make_unique<const LazyRow>(departures(c, clock)); });
  }

  [[nodiscard]] bool decide(std::uint32_t c, std::size_t index) const {
    const LazyRow& row = lazy_row(c);
    std::atomic<Verdict>& verdict = row.verdicts[index];
    if (const Verdict known = verdict.load(std::memory_order_relaxed); known != Verdict::kUnknown)
      return known == Verdict::kKept;
    const Link& link = row.departures.links[index];
    Verdict found = Verdict::kKept;
    if (!headings_of(link.to).contains(link.heading)) {
      found = Verdict::kArrival;
    } else if (!queries.sweep->straight_free(swept_by(link))) {
      found = Verdict::kStraight;
    }
    verdict.store(found, std::memory_order_relaxed);
    return found == Verdict::kKept;
  }

  [[nodiscard]] FeasibleGraphCounts counts_so_far() const {
    FeasibleGraphCounts sum = counts;
    if (mode == GraphMode::kEager) return sum;
    for (std::uint32_t c = 0; c < circles.size(); ++c) {
      if (const HeadingSet* set = lazy_headings.find(c); set && set->empty()) ++sum.circles_blocked;
      const LazyRow* row = lazy_rows.find(c);
      if (!row) continue;
      count(row->departures.counts, sum);
      for (const std::atomic<Verdict>& verdict : row->verdicts) {
        const Verdict known = verdict.load(std::memory_order_relaxed);
        sum.kept += known == Verdict::kKept ? 1 : 0;
        sum.rejected_arrival += known == Verdict::kArrival ? 1 : 0;
        sum.rejected_straight += known == Verdict::kStraight ? 1 : 0;
      }
    }
    return sum;
  }

  static void count(const LinkCounts& row, FeasibleGraphCounts& sum) {
    sum.candidates += row.candidates;
    sum.repeated += row.repeated;
    sum.rejected_overlap += row.overlaps;
    sum.rejected_departure += row.departures;
    sum.rejected_arrival += row.arrivals;
    sum.rejected_straight += row.straights;
  }

  [[nodiscard]] TurningBody body_on(const TurnCircle& circle) const {
    return {circle.center, circle.radius, circle.side, body};
  }
  [[nodiscard]] SweptRectangle swept_by(const Link& link) const {
    return swept_rectangle(pose_on(circles[link.from], link.heading), link.length, body);
  }

  World world;
  QuerySet queries;
  Footprint body;
  bool body_covers_reference;  // else other points of it touch the vertex first
  GraphMode mode;
  double smallest_radius;
  std::shared_ptr<const VisibilityRows> rows;
  TurnCircles turn_circles;
  Destinations destinations;
  std::span<const TurnCircle> circles;
  FeasibleGraphCounts counts;
  std::shared_ptr<const Data> base;  // of a graph with added circles: what it knows of the others

  std::vector<HeadingSet> headings;  // if eager, or known before a change
  std::vector<Link> links;
  std::vector<std::uint64_t> link_starts{0};
  std::vector<LinkCounts> link_counts;
  std::vector<std::uint8_t> known_headings, known_rows;  // by circle, after a change: whether they are in those

  SlotCache<HeadingSet> lazy_headings;  // if lazy, all others
  SlotCache<LazyRow> lazy_rows;
};

FeasibleGraph::FeasibleGraph(const World& world, const Vehicle& vehicle, const VisibilityGraph& graph,
                             const QuerySet& queries, std::span<const double> radii, const Executor& executor,
                             GraphMode mode, const ProcessGroup& process_group)
    : FeasibleGraph(world, vehicle, rows_of(world, graph), queries, radii, executor, mode, process_group) {}

FeasibleGraph::FeasibleGraph(const World& world, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> rows,
                             const QuerySet& queries, std::span<const double> radii, const Executor& executor,
                             GraphMode mode, const ProcessGroup& process_group) {
  auto data = std::make_shared<Data>(world, vehicle, std::move(rows), queries, radii, mode, executor);
  if (mode == GraphMode::kEager) data->check_all(executor, process_group);
  data_ = std::move(data);
}

FeasibleGraph::FeasibleGraph(const World& world, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> rows,
                             const QuerySet& queries, std::span<const double> radii, FeasibleGraphSnapshot known) {
  auto data =
      std::make_shared<Data>(world, vehicle, std::move(rows), queries, radii, GraphMode::kEager, SerialExecutor());
  data->take(std::move(known));
  data_ = std::move(data);
}

FeasibleGraph::FeasibleGraph(const FeasibleGraph& before, const World& world, const WorldChange& change,
                             const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> rows,
                             const QuerySet& queries, std::span<const double> radii, const Executor& executor,
                             GraphMode mode) {
  auto data = std::make_shared<Data>(world, vehicle, std::move(rows), queries, radii, mode, executor);
  data->take_over(*before.data_, change, vehicle.footprint(vehicle.safety_margin()), executor);
  data_ = std::move(data);
}

FeasibleGraph::FeasibleGraph(const FeasibleGraph& base, const Vehicle& vehicle, const AddedCircles& added) {
  const Data& known = *base.data_;
  auto data = std::make_shared<Data>(known.world, vehicle, known.rows, known.queries, known.smallest_radius,
                                     TurnCircles(known.turn_circles, added), GraphMode::kLazy);
  data->base = base.data_;
  data_ = std::move(data);
}

FeasibleGraphSnapshot FeasibleGraph::snapshot() const {
  FeasibleGraphSnapshot snapshot;
  snapshot.interval_starts.push_back(0);
  for (const HeadingSet& set : data_->headings) {
    snapshot.intervals.insert(snapshot.intervals.end(), set.intervals().begin(), set.intervals().end());
    snapshot.interval_starts.push_back(snapshot.intervals.size());
  }
  snapshot.link_starts = data_->link_starts;
  snapshot.links = data_->links;
  snapshot.link_counts = data_->link_counts;
  return snapshot;
}

GraphMode FeasibleGraph::mode() const { return data_->mode; }
std::span<const TurnCircle> FeasibleGraph::circles() const { return data_->circles; }
const TurnCircles& FeasibleGraph::turn_circles() const { return data_->turn_circles; }
const HeadingSet& FeasibleGraph::free_headings(std::uint32_t circle) const { return data_->headings_of(circle); }
std::span<const FeasibleGraph::Link> FeasibleGraph::links() const { return data_->links; }
FeasibleGraphCounts FeasibleGraph::counts() const { return data_->counts_so_far(); }

std::span<const FeasibleGraph::Link> FeasibleGraph::links_from(std::uint32_t circle, const StopClock& clock) const {
  return data_->has_row(circle) ? data_->links_of(circle) : data_->lazy_row(circle, clock).departures.links;
}

bool FeasibleGraph::is_kept(std::uint32_t circle, std::size_t index) const {
  return data_->has_row(circle) || data_->decide(circle, index);
}

}  // namespace arcway::internal
