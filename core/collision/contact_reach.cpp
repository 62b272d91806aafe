#include "core/collision/contact_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arcway/angle.h"
#include "core/base/infinity.h"

namespace arcway::internal {

namespace {

// Share of the distance from the center of a turn by which an edge may miss a contact and still count as one.
constexpr double kReachRounding = 1e-12;

constexpr double kQuarterTurn = 0.5 * kPi;

constexpr double kShorter = 1e-9;  // by which share distances count as shorter than they are: more than rounding

// The first contact of a body that turns about the origin with an edge.
class TurnContacts {
 public:
  // Contacts at a turn of `least` [rad] or more do not count.
  TurnContacts(Side side, double least) : turning_(sign_of(side)) { set_least(least); }

  // A point of the body that turns to a point of the edge.
  void add(const Vec2& of_body, const Vec2& of_edge) {
    const double sine = turning_ * cross(of_body, of_edge), cosine = of_body.dot(of_edge);
    // Most contacts are seen to come later, or to lie behind, without an arc tangent.
    if (least_ < kPi && (sine < 0.0 || sine * cosine_ > cosine * sine_)) return;
    const double turn = std::atan2(sine, cosine);
    if (const double ahead = turn < 0.0 ? turn + kTwoPi : turn; ahead < least_) set_least(ahead);
  }
  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] double cosine() const { return cosine_; }  // of least()
  [[nodiscard]] double sine() const { return sine_; }

 private:
  void set_least(double least) {
    least_ = least;
    sine_ = std::sin(least);
    cosine_ = std::cos(least);
  }

  double turning_;
  double least_ = kTwoPi;
  double sine_ = 0.0, cosine_ = 1.0;
};

struct TurnedBody {
  double x_low, x_high, y_low, y_high;  // about the center of the turn
  [[nodiscard]] std::array<Vec2, 4> corners() const {
    return {Vec2(x_low, y_low), Vec2(x_high, y_low), Vec2(x_high, y_high), Vec2(x_low, y_high)};
  }
};

// Whether edges may meet the body before it has turned by an angle: the box around the area that it sweeps until then.
class SweptBox {
 public:
  SweptBox(const std::array<Vec2, 4>& corners, Side side) : turning_(sign_of(side)) {
    for (std::size_t i = 0; i < corners.size(); ++i) corners_[i] = {corners[i], corners[i].norm()};
    for (const Corner& corner : corners_) slack_ = std::max(slack_, kSlack * corner.far);
  }

  // The turn ends at an angle of least().
  void shrink(const TurnContacts& contacts) {
    if (contacts.least() > kShrink * angle_ || contacts.least() > kPi) return;
    angle_ = contacts.least();
    const double cosine = contacts.cosine(), sine = contacts.sine();
    box_ = Box();
    for (const Corner& corner : corners_) {
      const double x = corner.at.x(), y = corner.at.y(), far = corner.far;
      const auto most = [&](double along, double rise) {
        return rise >= 0.0 && along >= far * cosine ? far : std::max(along, along * cosine + rise * sine);
      };
      box_.extend(Vec2(most(x, -turning_ * y), most(y, turning_ * x)));
      box_.extend(Vec2(-most(-x, turning_ * y), -most(-y, -turning_ * x)));
    }
    box_ = box_.grown(slack_);
  }

  [[nodiscard]] bool may_meet(const Vec2& p, const Vec2& q) const {
    return std::max(p.x(), q.x()) >= box_.min.x() && std::min(p.x(), q.x()) <= box_.max.x() &&
           std::max(p.y(), q.y()) >= box_.min.y() && std::min(p.y(), q.y()) <= box_.max.y();
  }

 private:
  static constexpr double kShrink = 0.8;  // a smaller box is worth its while
  static constexpr double kSlack = 1e-9;  // of the largest distance from the center: more than rounding
  struct Corner {
    Vec2 at;
    double far;
  };
  double turning_;
  std::array<Corner, 4> corners_;
  double slack_ = 0.0;
  double angle_ = std::numeric_limits<double>::infinity();
  Box box_{Vec2::Constant(-std::numeric_limits<double>::infinity()),
           Vec2::Constant(std::numeric_limits<double>::infinity())};
};

// A corner of the body meets the edge from p to q.
void add_corner(const Vec2& corner, const Vec2& p, const Vec2& q, TurnContacts& contacts) {
  const Vec2 d = q - p;
  const double rr = corner.squaredNorm(), dd = d.squaredNorm();
  const double along = -p.dot(d) / dd;
  const double rest = rr - (p + along * d).squaredNorm();
  if (rest < 0.0) return;
  const double half = std::sqrt(rest / dd);
  for (const double t : {along - half, along + half})
    if (t >= 0.0 && t <= 1.0) contacts.add(corner, p + t * d);
}

// A side of the body meets an end of an edge.
void add_end(const Vec2& p, const TurnedBody& b, TurnContacts& contacts) {
  const double rr = p.squaredNorm();
  const double slack = kReachRounding * std::sqrt(rr);
  for (const double x : {b.x_low, b.x_high}) {
    const double rest = rr - x * x;
    if (rest < 0.0) continue;
    for (const double y : {std::sqrt(rest), -std::sqrt(rest)})
      if (y >= b.y_low - slack && y <= b.y_high + slack) contacts.add({x, y}, p);
  }
  for (const double y : {b.y_low, b.y_high}) {
    const double rest = rr - y * y;
    if (rest < 0.0) continue;
    for (const double x : {std::sqrt(rest), -std::sqrt(rest)})
      if (x >= b.x_low - slack && x <= b.x_high + slack) contacts.add({x, y}, p);
  }
}

// A convex piece of the body meets the edge from p to q.
// @param center  of the turn, in the frame of the body.
void add_piece(const Ring& piece, const Vec2& center, const LineSegment& edge, TurnContacts& contacts) {
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Vec2 corner = piece[i] - center, way = piece[i + 1 < piece.size() ? i + 1 : 0] - piece[i];
    add_corner(corner, edge.a, edge.b, contacts);
    const double length2 = way.squaredNorm(), foot = -corner.dot(way) / length2;
    const double least2 = (corner + foot * way).squaredNorm();
    for (const Vec2& p : {edge.a, edge.b}) {
      const double rest = p.squaredNorm() - least2;
      if (rest < 0.0) continue;
      const double half = std::sqrt(rest / length2);
      for (const double t : {foot - half, foot + half})
        if (t >= -kReachRounding && t <= 1.0 + kReachRounding) contacts.add(corner + t * way, p);
    }
  }
}

// How far ahead of a segment a point of the same height as it lies along +x. Infinite where it has none at that height.
double distance_ahead(const Vec2& p, const Vec2& a, const Vec2& b) {
  if ((a.y() > p.y() && b.y() > p.y()) || (a.y() < p.y() && b.y() < p.y())) return kInfinity;
  const double rise = b.y() - a.y();
  const double x = rise == 0.0 ? std::max(std::min(a.x(), b.x()), std::min(std::max(a.x(), b.x()), p.x()))
                               : std::lerp(a.x(), b.x(), std::clamp((p.y() - a.y()) / rise, 0.0, 1.0));
  return p.x() - x;
}

}  // namespace

ContactReach::ContactReach(const Outlines& outlines, const Body& body, const OneWayZones* zones, Gear forwards)
    : outlines_(&outlines), body_(body), zones_(zones), forwards_(forwards), around_(body.farthest()) {}

void ContactReach::begin(const Pose& pose, double most) {
  most_ = most;
  pose_ = pose;
  edges_.clear();
  const double far = most + around_;
  const Vec2 place = pose.position(), ahead = direction_of(pose.heading);
  const Box near{place - Vec2(far, far), place + Vec2(far, far)};
  const auto add = [&](const Vec2& p, const Vec2& q) {
    if (!box_of(LineSegment{p, q}).overlaps(near)) return;
    const Vec2 a = p - place, b = q - place, d = b - a;
    const double dd = d.squaredNorm();
    const double at = dd > 0.0 ? std::clamp(-a.dot(d) / dd, 0.0, 1.0) : 0.0;
    if ((a + at * d).squaredNorm() > far * far) return;
    const LineSegment edge{{ahead.dot(a), cross(ahead, a)}, {ahead.dot(b), cross(ahead, b)}};
    edges_.push_back({distance_to_body(edge), edge});
  };
  outlines_->visit_if([&](const Box& box) { return box.overlaps(near); },
                      [&](const Outlines::Piece& piece) {
                        for (std::size_t i = 0; i < piece.edge_count(); ++i) add(piece.points[i], piece.points[i + 1]);
                        return true;
                      });
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.distance < b.distance; });
}

// No larger than the distance of an edge from the body.
double ContactReach::distance_to_body(const LineSegment& edge) const {
  const auto [low_x, high_x] = std::minmax(edge.a.x(), edge.b.x());
  const auto [low_y, high_y] = std::minmax(edge.a.y(), edge.b.y());
  const double x = std::max({0.0, low_x - body_.front, -body_.rear - high_x});
  const double y = std::max({0.0, low_y - body_.left, -body_.right - high_y});
  return (1.0 - kShorter) * std::sqrt(x * x + y * y);
}

double ContactReach::operator()(double curvature, Gear gear) const {
  const double free = until_contact(curvature, gear);
  if (zones_ == nullptr) return free;
  const Gear driven = gear == forwards_ ? Gear::kForward : Gear::kReverse;
  return zones_->allowed_length({pose_, free, curvature, gear}, driven);
}

double ContactReach::until_contact(double curvature, Gear gear) const {
  if (curvature == 0.0) return along_line(gear);
  const double radius = 1.0 / std::abs(curvature);
  const Vec2 center(0.0, 1.0 / curvature);
  const TurnedBody body{-body_.rear, body_.front, -body_.right - center.y(), body_.left - center.y()};
  const std::array<Vec2, 4> corners = body.corners();
  double outer = 0.0;  // squares of distances from the center
  for (const Vec2& corner : corners) outer = std::max(outer, corner.squaredNorm());
  const double farthest = std::sqrt(outer);
  // How far the sides lie from the center: towards it, and away from it.
  const Side center_side = curvature > 0.0 ? Side::kLeft : Side::kRight;
  const double towards = radius - body_.beside(center_side), away = radius + body_.beside(opposite(center_side));
  const double inside = std::max({0.0, towards, -away}), inner = inside * inside;
  const bool to_left = (curvature > 0.0) == (gear == Gear::kForward);
  const Side side = to_left ? Side::kLeft : Side::kRight;
  TurnContacts contacts(side, std::min(kTwoPi, most_ / radius));
  SweptBox swept(corners, side);
  // Where the center of the turn is beside the body on its side, all of it moves ahead at first.
  const double ahead = sign_of(gear), tail = gear == Gear::kForward ? -body_.rear : -body_.front;
  const bool moves_ahead = towards >= 0.0;
  for (const auto& [distance, edge] : edges_) {
    if (distance > contacts.least() * farthest) break;
    ++edges_compared_;
    if (moves_ahead && contacts.least() < kQuarterTurn && std::max(ahead * edge.a.x(), ahead * edge.b.x()) < tail)
      continue;
    const Vec2 p = edge.a - center, q = edge.b - center, d = q - p;
    swept.shrink(contacts);
    if (!swept.may_meet(p, q)) continue;
    const double dd = d.squaredNorm();
    if (dd == 0.0) continue;
    const double from_p = p.squaredNorm(), from_q = q.squaredNorm();
    if (std::max(from_p, from_q) < inner) continue;
    if ((p + std::clamp(-p.dot(d) / dd, 0.0, 1.0) * d).squaredNorm() > outer) continue;
    if (body_.shape != nullptr) {
      for (const Ring& piece : body_.shape->pieces) add_piece(piece, center, {p, q}, contacts);
      continue;
    }
    for (const Vec2& corner : corners) add_corner(corner, p, q, contacts);
    if (from_p <= outer) add_end(p, body, contacts);
    if (from_q <= outer) add_end(q, body, contacts);
  }
  return contacts.least() * radius;
}

double ContactReach::along_line(Gear gear) const {
  if (body_.shape != nullptr) return of_shape_along_line(gear);
  double least = most_;
  const double nose = gear == Gear::kForward ? body_.front : body_.rear;
  for (const auto& [distance, edge] : edges_) {
    if (distance > least) break;
    ++edges_compared_;
    // The part of the edge within the width of the body.
    double low = 0.0, high = 1.0;
    const double y = edge.a.y(), rise = edge.b.y() - y;
    if (std::abs(rise) > 0.0) {
      const double at_low = (-body_.right - y) / rise, at_high = (body_.left - y) / rise;
      low = std::max(low, std::min(at_low, at_high));
      high = std::min(high, std::max(at_low, at_high));
    } else if (y > body_.left || y < -body_.right) {
      continue;
    }
    if (low > high) continue;
    for (const double t : {low, high}) {
      const double x = sign_of(gear) * (edge.a.x() + t * (edge.b.x() - edge.a.x()));
      if (x >= nose) least = std::min(least, x - nose);
    }
  }
  return least;
}

// By the corners of each piece on their way to the edge, and by the ends of the edge on theirs to the sides.
double ContactReach::of_shape_along_line(Gear gear) const {
  double least = most_;
  const double sign = sign_of(gear);
  const auto ahead = [&](const Vec2& p) { return Vec2(sign * p.x(), p.y()); };
  const auto take = [&](double distance) {
    if (distance >= 0.0) least = std::min(least, distance);
  };
  for (const auto& [distance, edge] : edges_) {
    if (distance > least) break;
    ++edges_compared_;
    const Vec2 p = ahead(edge.a), q = ahead(edge.b);
    for (const Ring& piece : body_.shape->pieces) {
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const Vec2 corner = ahead(piece[i]), next = ahead(piece[i + 1 < piece.size() ? i + 1 : 0]);
        take(-distance_ahead(corner, p, q));
        for (const Vec2& end : {p, q}) take(distance_ahead(end, corner, next));
      }
    }
  }
  return least;
}

}  // namespace arcway::internal
