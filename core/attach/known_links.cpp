#include "core/attach/known_links.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace arcway::internal {

namespace {

// Number of circles whose straights are kept: more than the searches of a query have.
constexpr std::size_t kMostKnown = 64;
// Number of straights that are kept. In open places a circle has ten thousands, and they would take megabytes. Queries
// among 100 obstacles have some hundred a circle.
constexpr std::size_t kMostLinks = 1 << 13;

bool is_same(const AttachmentCircle& a, const AttachmentCircle& b) {
  return a.circle.center == b.circle.center && a.circle.radius == b.circle.radius && a.circle.side == b.circle.side &&
         a.heading == b.heading && a.reach == b.reach;
}

bool is_same(const Footprint& a, const Footprint& b) {
  return a.front == b.front && a.rear == b.rear && a.left == b.left && a.right == b.right;
}

// Whether radii are the smallest ones of more. Without memory.
bool are_smallest(const CircleRadii& radii, const CircleRadii& more) {
  return radii.size() < more.size() && std::ranges::all_of(std::array{Side::kLeft, Side::kRight}, [&](Side side) {
           return std::ranges::equal(radii.of(side), more.of(side).first(radii.size()));
         });
}

// Where the circles of a graph are in one of fewer radii.
class SmallerGraph {
 public:
  SmallerGraph(const TurnCircles& larger, std::size_t radii, std::size_t fewer)
      : block_(2 * static_cast<std::uint32_t>(radii)),
        smaller_(2 * static_cast<std::uint32_t>(fewer)),
        own_(static_cast<std::uint32_t>(larger.own_count())),
        own_smaller_(own_ / block_ * smaller_),
        base_(static_cast<std::uint32_t>(larger.base_count())) {}

  // The number of circles of the smaller graph, if it has no added ones.
  [[nodiscard]] std::size_t size() const { return own_smaller_ + (base_ - own_); }
  [[nodiscard]] std::optional<std::uint32_t> circle(std::uint32_t c) const {
    if (c >= base_) return std::nullopt;
    if (c >= own_) return c - own_ + own_smaller_;
    return c % block_ < smaller_ ? std::optional(c / block_ * smaller_ + c % block_) : std::nullopt;
  }

 private:
  std::uint32_t block_, smaller_;    // circles of a vertex
  std::uint32_t own_, own_smaller_;  // circles around single vertices
  std::uint32_t base_;               // of the larger graph
};

}  // namespace

void KnownLinks::begin() {
  keeps_ = true;
  size_ = links_ = 0;
}

bool KnownLinks::append(const PathEnd& end, const AttachmentCircle& own, const LengthLimit& limit, std::uint32_t index,
                        HugeVector<AttachmentLink>& links) const {
  if (!is_all(limit)) return false;
  for (const Entry& entry : std::span(entries_).first(size_)) {
    const bool is_known = entry.direction == end.direction && is_same(entry.own, own) &&
                          entry.other_end == limit.other_end && entry.length >= limit.length &&
                          is_same(entry.body, end.map.vehicle.footprint()) && entry.gaps.lock() == end.map.gaps &&
                          entry.sweep.lock() == end.map.queries.sweep;
    if (is_known && append_from(entry, end.map, limit, index, links)) return true;
  }
  return false;
}

bool KnownLinks::append_from(const Entry& entry, const Roadmap& map, const LengthLimit& limit, std::uint32_t index,
                             HugeVector<AttachmentLink>& links) {
  const auto graph = entry.graph.lock();
  if (!graph) return false;
  const bool is_same_graph = entry.circles.lock() == map.circles;
  if (!is_same_graph && !are_smallest(map.radii, entry.radii)) return false;
  const std::span<const TurnCircle> circles = map.graph->circles();
  const SmallerGraph smaller(graph->turn_circles(), entry.radii.size(), map.radii.size());
  if (!is_same_graph && smaller.size() != circles.size()) return false;
  const std::size_t first = links.size();
  for (const AttachmentLink& link : entry.links) {
    const auto circle = is_same_graph ? std::optional(link.circle) : smaller.circle(link.circle);
    if (!circle || is_beyond(limit, entry.own.circle, circles[*circle])) continue;
    if (circles[*circle].center != graph->circles()[link.circle].center) {  // no part of that graph
      links.resize(first);
      return false;
    }
    links.push_back({index, *circle, link.line, link.turn});
  }
  return true;
}

void KnownLinks::keep(const PathEnd& end, const AttachmentCircle& own, const LengthLimit& limit,
                      const HugeVector<AttachmentLink>& links, std::size_t first) {
  if (!keeps_ || !is_all(limit) || size_ == kMostKnown || links_ + links.size() - first > kMostLinks) return;
  links_ += links.size() - first;
  if (size_ == entries_.size()) entries_.emplace_back();
  Entry& entry = entries_[size_++];
  entry.circles = end.map.circles;
  entry.graph = end.map.graph;
  entry.gaps = end.map.gaps;
  entry.body = end.map.vehicle.footprint();
  entry.sweep = end.map.queries.sweep;
  if (!(entry.radii == end.map.radii)) entry.radii = end.map.radii;
  entry.direction = end.direction;
  entry.own = own;
  entry.other_end = limit.other_end;
  entry.length = limit.length;
  entry.links.assign(links.begin() + static_cast<std::ptrdiff_t>(first), links.end());
}

}  // namespace arcway::internal
