#include "arcway/body_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "arcway/vehicle.h"
#include "core/base/shortest_text.h"
#include "core/geometry/convex_pieces.h"
#include "core/geometry/grow_convex.h"
#include "core/geometry/inscribed.h"
#include "core/geometry/predicates.h"

namespace arcway {

using namespace internal;
namespace {

std::string name_of(std::size_t part) { return "footprint[" + std::to_string(part) + "]"; }
std::string name_of(std::size_t part, std::size_t vertex) { return name_of(part) + "[" + std::to_string(vertex) + "]"; }
std::string text_of(const Vec2& p) { return "(" + shortest_text(p.x()) + ", " + shortest_text(p.y()) + ")"; }

[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument("vehicle: " + message); }

void require_numbers(const Ring& ring, std::size_t part) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& p = ring[i];
    if (!is_in_range(p) || p.cwiseAbs().maxCoeff() > kLargestVehicleNumber)
      fail(name_of(part, i) + " is " + text_of(p) + ", each coordinate must be 0 or of magnitude " +
           shortest_text(kMinMagnitude) + " to " + shortest_text(kLargestVehicleNumber) + " m");
  }
}

std::string conflict_text(const Ring& ring, const RingConflict& conflict, std::size_t part) {
  const std::size_t a = conflict.edge_a, b = conflict.edge_b, n = ring.size();
  if (conflict.kind == RingConflict::Kind::kRepeatedVertex)
    return name_of(part, a) + " and " + name_of(part, (a + 1) % n) + " are both " + text_of(conflict.place) +
           ", remove one of them";
  const auto side = [&](std::size_t i) {
    return "the side from vertex " + std::to_string(i) + " to " + std::to_string((i + 1) % n);
  };
  return name_of(part) + ": " + side(a) + (conflict.kind == RingConflict::Kind::kCrossing ? " crosses " : " lies on ") +
         side(b) + " at " + text_of(conflict.place) + ", give the corners in their order around the body";
}

// Where a ring touches itself: a vertex on another one, or on a side.
void require_no_contact(const Ring& ring, std::span<const RingContact> contacts, std::size_t part) {
  if (!contacts.empty()) {
    const RingContact& c = contacts.front();
    fail(name_of(part, c.vertex) + ", " + text_of(ring[c.vertex]) + ", lies on the side from vertex " +
         std::to_string(c.edge) + " to " + std::to_string((c.edge + 1) % ring.size()) +
         ": a ring may not touch itself, give two parts");
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto again = std::find(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, ring.end(), ring[i]);
    if (again != ring.end())
      fail(name_of(part, i) + " and " + name_of(part, static_cast<std::size_t>(again - ring.begin())) + " are both " +
           text_of(ring[i]) + ": a ring may not touch itself, give two parts");
  }
}

// A simple ring, counter-clockwise, without straight corners.
Ring normalized(Ring ring, std::size_t part) {
  require_numbers(ring, part);
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) fail(name_of(part) + " has " + std::to_string(ring.size()) + " corners, must have >= 3");
  std::vector<RingContact> contacts;
  const auto conflict = find_conflict({ring, {}}, &contacts);
  const bool is_crossed = conflict && conflict->kind == RingConflict::Kind::kCrossing;
  if (winding(ring) == 0 && !is_crossed) fail(name_of(part) + " has no area");
  if (conflict) fail(conflict_text(ring, *conflict, part));
  require_no_contact(ring, contacts, part);
  if (winding(ring) < 0) std::reverse(ring.begin(), ring.end());
  return without_straight_corners(ring);
}

bool is_upright_rectangle(const Ring& ring) {
  if (ring.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 along = ring[(i + 1) % 4] - ring[i];
    if (along.x() != 0.0 && along.y() != 0.0) return false;
  }
  return true;
}

Vec2 mean_of(const Ring& ring) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : ring) sum += p;
  return sum / static_cast<double>(ring.size());
}

double area_of(const Box& box) { return box.empty() ? 0.0 : (box.max - box.min).prod(); }

// @param first  index of each part's first piece.
void require_apart(std::span<const Ring> pieces, std::span<const std::size_t> first) {
  for (std::size_t a = 0; a < first.size(); ++a) {
    for (std::size_t b = a + 1; b < first.size(); ++b) {
      const std::size_t end_a = first[a + 1], end_b = b + 1 < first.size() ? first[b + 1] : pieces.size();
      for (std::size_t i = first[a]; i < end_a; ++i)
        for (std::size_t j = first[b]; j < end_b; ++j)
          if (interiors_meet(pieces[i], pieces[j]))
            fail(name_of(a) + " and " + name_of(b) + " overlap near " + text_of(mean_of(pieces[j])) +
                 ", join them to one part or move them apart");
    }
  }
}

}  // namespace

BodyShape::BodyShape(std::vector<Ring> parts) : parts_(std::move(parts)) {
  if (parts_.empty()) fail("footprint has 0 parts, must have >= 1");
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i] = normalized(std::move(parts_[i]), i);
    const Ring& ring = parts_[i];
    for (const Vec2& p : ring) bounds_.extend(p);
    first.push_back(pieces_.size());
    for (Ring& piece : convex_pieces(ring)) pieces_.push_back(std::move(piece));
    const InscribedDisc disc = largest_disc_in(ring, mean_of(pieces_[first.back()]));
    inner_points_.push_back(disc.center);
    disc_ = std::max(disc_, 2.0 * disc.radius);
    if (const Box box = large_box_in(ring); area_of(box) > area_of(core_)) core_ = box;
  }
  require_apart(pieces_, first);
  is_rectangle_ = parts_.size() == 1 && is_upright_rectangle(parts_.front());
  if (is_rectangle_) core_ = bounds_;
}

GrownBody::GrownBody(const BodyShape& shape, double margin)
    : outline(shape.parts().begin(), shape.parts().end()),
      inner_points(shape.inner_points().begin(), shape.inner_points().end()) {
  for (const Ring& piece : shape.pieces()) {
    pieces.push_back(grow_convex(piece, margin));
    for (const Vec2& corner : pieces.back()) bounds.extend(corner);
  }
}

}  // namespace arcway
