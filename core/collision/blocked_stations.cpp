#include "core/collision/blocked_stations.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/base/infinity.h"

namespace arcway::internal {

namespace {

// A range that grows by values. Empty at first.
struct ValueRange {
  double low = kInfinity, high = -kInfinity;
  void extend(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Extends a range by the places along x where a segment has a height, if it gets there.
void extend_at(double height, const Vec2& a, const Vec2& b, ValueRange& xs) {
  if (height < std::min(a.y(), b.y()) || height > std::max(a.y(), b.y())) return;
  if (a.y() == b.y()) {
    xs.extend(a.x());
    xs.extend(b.x());
  } else {
    xs.extend(a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
}

// How far a convex piece moves along x until it touches an edge, and until it has passed it: differences of places at
// one height. Between heights of corners and ends both are linear, so that the extremes lie at such heights.
ValueRange contacts(std::span<const Vec2> piece, const LineSegment& edge) {
  ValueRange stations;
  const auto add = [&](const ValueRange& of_edge, const ValueRange& of_piece) {
    if (of_edge.low > of_edge.high || of_piece.low > of_piece.high) return;
    stations.extend(of_edge.low - of_piece.high);
    stations.extend(of_edge.high - of_piece.low);
  };
  const auto across_piece = [&](double height) {
    ValueRange xs;
    for (std::size_t i = 0; i < piece.size(); ++i) extend_at(height, piece[i], piece[(i + 1) % piece.size()], xs);
    return xs;
  };
  for (const Vec2& corner : piece) {
    ValueRange of_edge;
    extend_at(corner.y(), edge.a, edge.b, of_edge);
    if (of_edge.low <= of_edge.high) add(of_edge, across_piece(corner.y()));
  }
  for (const Vec2& end : {edge.a, edge.b}) {
    ValueRange of_edge;
    extend_at(end.y(), edge.a, edge.b, of_edge);
    add(of_edge, across_piece(end.y()));
  }
  return stations;
}

}  // namespace

void append_blocked_stations(const StraightBody& body, const LineSegment& edge, std::vector<BlockedRange>& blocked) {
  const Vec2 ahead = direction_of(body.from.heading);
  const auto seen = [&](const Vec2& p) {
    const Vec2 d = p - body.from.position();
    return Vec2(ahead.dot(d), cross(ahead, d));
  };
  const LineSegment from_body{seen(edge.a), seen(edge.b)};
  const auto append = [&](std::span<const Vec2> piece) {
    const ValueRange stations = contacts(piece, from_body);
    const double low = std::max(stations.low, 0.0), high = std::min(stations.high, body.length);
    if (low <= high) blocked.push_back({low, high});
  };
  if (body.body.shape != nullptr) {
    for (const Ring& piece : body.body.shape->pieces) append(piece);
    return;
  }
  const Footprint& f = body.body;
  append(Box{{-f.rear, -f.right}, {f.front, f.left}}.corners());
}

double length_of_union(std::vector<BlockedRange>& ranges) {
  std::ranges::sort(ranges, {}, &BlockedRange::low);
  double length = 0.0, end = -kInfinity;
  for (const BlockedRange& range : ranges) {
    if (range.high <= end) continue;
    length += range.high - std::max(range.low, end);
    end = range.high;
  }
  return length;
}

}  // namespace arcway::internal
