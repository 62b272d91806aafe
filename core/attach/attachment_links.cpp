#include "core/attach/attachment_links.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "arcway/angle.h"
#include "core/attach/circle_places.h"
#include "core/attach/circle_table.h"
#include "core/attach/occlusion_horizon.h"
#include "core/base/infinity.h"

namespace arcway::internal {

namespace {

constexpr double kLengthRounding = 1e-9;  // share of a length that rounding may change

// The longest way between the other end and the center of an attachment's circle.
double longest_way(const LengthLimit& limit, const TurnCircle& own) {
  return limit.length * (1.0 + kLengthRounding) + own.radius;
}

// Backwards from the goal, a path turns in the other direction on the circle.
TurnCircle circle_away(const TurnCircle& circle, bool from_start) {
  return from_start ? circle : TurnCircle{circle.center, circle.radius, opposite(circle.side), circle.vertex};
}

// The straights between one circle of an attachment and the graph.
class CircleLinks {
 public:
  CircleLinks(const PathEnd& end, const AttachmentCircle& own, const LengthLimit& limit)
      : map_(end.map),
        circles_(*end.map.circles),
        graph_circles_(end.map.graph->circles()),
        from_start_(end.direction == Direction::kFromStart),
        own_(own),
        limit_(limit),
        ticker_(end.clock),
        is_limited_(limit.length < std::numeric_limits<double>::infinity()),
        longest_(longest_way(limit, own.circle)),
        horizon_(circle_away(own.circle, from_start_), from_start_ ? own.heading : own.heading + kPi, own.reach) {}

  // Pieces of outline that no nearer one hides, unless the clock is over. If their circles are more than the limit
  // allows, the nearest come first.
  void find_pieces(std::vector<AttachmentLinks::NearPiece>& pieces) {
    const bool body_covers_reference = map_.body.covers_reference();
    std::size_t circles = 0;
    map_.places->visit_near_first(
        own_.circle.center, [&](const Box& box) { return !ticker_.is_over() && !is_far(box) && !horizon_.hides(box); },
        [&](const Outlines::Piece& piece, std::uint32_t index) {
          if (body_covers_reference) horizon_.shorten(piece.points, piece.box);
          pieces.push_back({piece.box.distance_to(own_.circle.center), piece.first, index});
          for (const CirclePlaces::Group& group : map_.places->of(index).groups) circles += group.last - group.first;
        });
    horizon_.finish();
    if (circles > limit_.most_links)
      std::ranges::sort(pieces, {}, [](const auto& piece) { return std::pair(piece.distance, piece.first); });
  }

  // Calls found(circle, line, turn) for each straight between this circle and those of a piece.
  template <class Found>
  void visit_links(std::uint32_t piece, Found&& found) const {
    const CirclePlaces::Circles here = map_.places->of(piece);
    for (const CirclePlaces::Group& group : here.groups) {
      if (is_far(group.box) || horizon_.hides(group.box)) continue;
      const Sectors outwards = horizon_.sectors_towards(group.box);
      const Sectors sectors = from_start_ ? outwards : std::rotl(outwards, 32);
      for (const std::uint32_t c : here.of(group))
        if ((circles_.free_sectors(c) & sectors) != 0) consider(c, found);
    }
  }

 private:
  template <class Found>
  void consider(std::uint32_t circle, Found&& found) const {
    const TurnCircle& other = graph_circles_[circle];
    const Side side = from_start_ ? other.side : opposite(other.side);
    const auto tangent = horizon_.free_tangent_to(TurnCircle{other.center, other.radius, side, kNone});
    if (!tangent || is_beyond(limit_, own_.circle, other)) return;
    // Most other circles are blocked at their heading. An approximate heading shows that, and exact ones are far
    // slower.
    const double about = from_start_ ? tangent->heading : tangent->heading + (tangent->heading < kPi ? kPi : -kPi);
    if (tangent->length > 0.0 && !circles_.may_be_free(circle, about, OcclusionHorizon::kTangentError)) return;
    const auto line = from_start_ ? directed_bitangent(own_.circle, other) : directed_bitangent(other, own_.circle);
    if (!line) return;
    const double heading = line->start.heading;
    if (line->length > horizon_.reach(from_start_ ? heading : heading + kPi)) return;
    if (!circles_.is_lazy() && !map_.graph->free_headings(circle).contains(heading)) return;
    const double turn = from_start_ ? turn_between(own_.heading, heading, own_.circle.side)
                                    : turn_between(heading, own_.heading, own_.circle.side);
    if (turn <= own_.reach) found(circle, *line, turn);
  }

  [[nodiscard]] bool is_far(const Box& box) const {
    return is_limited_ && box.distance_to(limit_.other_end) + box.distance_to(own_.circle.center) > longest_;
  }

  const Roadmap& map_;
  const CircleTable& circles_;
  std::span<const TurnCircle> graph_circles_;
  bool from_start_;
  const AttachmentCircle& own_;
  const LengthLimit& limit_;
  StopTicker ticker_;
  bool is_limited_;
  double longest_;  // way between the other end and the circle's center [m]
  OcclusionHorizon horizon_;
};

}  // namespace

bool is_beyond(const LengthLimit& limit, const TurnCircle& own, const TurnCircle& other) {
  const double way = (limit.other_end - other.center).norm() + (own.center - other.center).norm();
  return way > longest_way(limit, own) + 2.0 * other.radius;
}

void AttachmentLinks::append_circles(const PathEnd& end, std::span<const Attachment> attachments, std::size_t first,
                                     std::vector<AttachmentCircle>& circles) {
  const Roadmap& map = end.map;
  for (auto t = static_cast<std::uint32_t>(first); t < attachments.size() && !end.clock.is_over(); ++t) {
    // Maneuvers join by the smallest radius only: they serve narrow places, and their poses are many.
    const bool plain = attachments[t].connection.empty();
    const std::size_t radii = plain ? std::min(end.radii, map.radii.size()) : 1;
    for (std::size_t k = 0; k < radii; ++k)
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const double radius = std::max(map.radii.of(side)[k], attachments[t].tightest);
        const bool is_known = k > 0 && radius == attachments[t].tightest;
        if (attachments[t].shared == side || is_known || radius == kInfinity) continue;
        const Pose& pose = attachments[t].pose;
        const TurnCircle circle = turn_circle(pose, radius, side);
        const Side towards = end.direction == Direction::kFromStart ? side : opposite(side);
        const TurningBody body{circle.center, radius, side, map.body};
        circles.push_back(
            {t, circle, wrap_positive(pose.heading), map.queries.sweep->reach(body, pose.heading, towards, headings_)});
      }
  }
}

bool AttachmentLinks::append_links(const PathEnd& end, std::span<const AttachmentCircle> circles, std::uint32_t index,
                                   const LengthLimit& limit, HugeVector<AttachmentLink>& links) {
  if (circles[index].reach < 0.0) return true;
  CircleLinks own(end, circles[index], limit);
  pieces_.clear();
  own.find_pieces(pieces_);
  const std::size_t first = links.size();
  for (const NearPiece& piece : pieces_) {
    if (links.size() - first >= limit.most_links || end.clock.is_over()) break;
    own.visit_links(piece.index, [&](std::uint32_t circle, const Bitangent& line, double turn) {
      links.push_back({index, circle, line, turn});
    });
  }
  const bool is_cut = end.clock.is_over();
  links.resize(first + (is_cut ? 0 : std::min(links.size() - first, limit.most_links)));
  // The order does not depend on that of the pieces.
  std::sort(links.begin() + static_cast<std::ptrdiff_t>(first), links.end(),
            [](const AttachmentLink& a, const AttachmentLink& b) { return a.circle < b.circle; });
  return !is_cut;
}

}  // namespace arcway::internal
