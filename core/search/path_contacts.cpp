#include "core/search/path_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

// Lengths are in lengths of the body.
constexpr double kStep = 1.0 / 24.0;   // largest move of a point of the body between two looks at the edges
constexpr double kNearContact = 0.02;  // edges so near beside the body count: the next step may come to touch them
constexpr double kFlat = 1e-7;         // depths that differ by no more count as equal
constexpr int kSections = 16;          // number of golden sections of two steps around the deepest contact
constexpr double kGolden = 0.6180339887498949;
constexpr double kSmallTurn = 1e-3;  // turn of an arc below which series are used [rad]
constexpr double kAroundArc = 0.25;  // of an arc's length: how far it lies from five of its places at most
constexpr double kNoContact = -std::numeric_limits<double>::infinity();

// How the end of an arc moves as its curvature grows, in the frame of its start.
Vec2 end_by_curvature(double curvature, double length) {
  const double turn = curvature * length, square = length * length;
  if (std::abs(turn) < kSmallTurn) return square * Vec2(-turn / 3.0, 0.5 - turn * turn / 8.0);
  const double sine = std::sin(turn), cosine = std::cos(turn);
  return square / (turn * turn) * Vec2(turn * cosine - sine, cosine + turn * sine - 1.0);
}

}  // namespace

PathContacts::PathContacts(const Outlines& outlines, const Footprint& body)
    : outlines_(&outlines), body_(body), unit_(body.length()), around_(body.farthest()) {}

void PathContacts::look_along(const std::vector<PathSegment>& motions, const Pose& goal) {
  motions_ = motions;
  values_.clear();
  gradients_.clear();
  deepest_ = square_sum_ = 0.0;
  ends_.clear();
  for (const PathSegment& motion : motions_) ends_.push_back(end_at(motion, step_at(motion, motion.length)));
  for (std::size_t i = 0; i < motions_.size(); ++i) look_along_motion(i);
  add_end(goal);
  const auto rows = static_cast<Eigen::Index>(values_.size()), columns = static_cast<Eigen::Index>(2 * motions_.size());
  using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  residuals_.gradients = Eigen::Map<const RowMajorMatrix>(gradients_.data(), rows, columns);
  residuals_.values = Eigen::Map<const Eigen::VectorXd>(values_.data(), rows);
  residuals_.equalities = 3;
}

void PathContacts::look_along_motion(std::size_t i) {
  const PathSegment& motion = motions_[i];
  find_edges(motion);
  if (edges_.empty()) return;
  const double travel = motion.length * (1.0 + std::abs(motion.curvature) * around_);
  const int count = std::max(1, static_cast<int>(std::ceil(travel / (kStep * unit_))));
  steps_.clear();
  for (int k = 1; k <= count; ++k) steps_.push_back(step_at(motion, motion.length * k / count));
  for (const LineSegment& edge : edges_) look_at(i, edge);
}

void PathContacts::find_edges(const PathSegment& motion) {
  Box near;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) near.extend(motion.at(share * motion.length).position());
  near = near.grown(around_ + kNearContact * unit_ + kAroundArc * motion.length);
  edges_.clear();
  outlines_->visit_if([&](const Box& box) { return box.overlaps(near); },
                      [&](const Outlines::Piece& piece) {
                        for (std::size_t k = 0; k < piece.edge_count(); ++k) {
                          const LineSegment edge{piece.points[k], piece.points[k + 1]};
                          if (box_of(edge).overlaps(near)) edges_.push_back(edge);
                        }
                        return true;
                      });
}

PathContacts::Step PathContacts::step_at(const PathSegment& motion, double at) {
  const Pose pose = motion.at(at);
  return {at, pose.position(), direction_of(pose.heading)};
}

PathContacts::End PathContacts::end_at(const PathSegment& motion, const Step& step) {
  const Vec2 ahead = direction_of(motion.start.heading);
  const Vec2 bend = end_by_curvature(motion.curvature, sign_of(motion.gear) * step.at);
  return {step.place, step.ahead, bend.x() * ahead + bend.y() * perpendicular(ahead)};
}

std::optional<BodyContact> PathContacts::contact(const PathSegment& motion, const Step& step,
                                                 const LineSegment& edge) const {
  return body_contact(body_, {step.place, step.ahead, motion.curvature}, edge, kNearContact * unit_);
}

double PathContacts::depth(const PathSegment& motion, const Step& step, const LineSegment& edge) const {
  const auto at = contact(motion, step, edge);
  return at ? at->depth : kNoContact;
}

// Contacts with one edge where they are deeper than around, and where the motion ends.
void PathContacts::look_at(std::size_t i, const LineSegment& edge) {
  const PathSegment& motion = motions_[i];
  double before = kNoContact, here = kNoContact;
  std::size_t first_near = 0;  // of the steps: the edge is far from the body at those before
  for (std::size_t k = 0; k <= steps_.size(); ++k) {
    double next = kNoContact;
    if (k >= first_near && k < steps_.size()) {
      next = depth(motion, steps_[k], edge);
      if (next == kNoContact) first_near = k + 1 + steps_far_from(steps_[k], edge);
    }
    const double flat = kFlat * unit_;
    if (here > kNoContact && ((here > before + flat && here + flat >= next) || next == kNoContact)) {
      const double low = k >= 2 ? steps_[k - 2].at : 0.0, high = k < steps_.size() ? steps_[k].at : motion.length;
      const Step step = deepest(motion, edge, low, high);
      if (const auto found = contact(motion, step, edge)) add_contact(i, step, *found);
    }
    before = here;
    here = next;
  }
}

// A number of steps in which the body does not get as far as an edge. Some less than that, for rounding.
std::size_t PathContacts::steps_far_from(const Step& step, const LineSegment& edge) const {
  const double away = distance_beside(body_, step.place, step.ahead, edge) - kNearContact * unit_;
  const double steps = away / (kStep * unit_);
  return steps < 2.0 ? 0 : static_cast<std::size_t>(steps) - 1;
}

PathContacts::Step PathContacts::deepest(const PathSegment& motion, const LineSegment& edge, double low,
                                         double high) const {
  Step end = step_at(motion, high);
  const auto depth_at = [&](double at) { return depth(motion, step_at(motion, at), edge); };
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = depth_at(a), at_b = depth_at(b);
  for (int i = 0; i < kSections; ++i) {
    if (at_a >= at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - kGolden * (high - low);
      at_a = depth_at(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + kGolden * (high - low);
      at_b = depth_at(b);
    }
  }
  const double best = at_a >= at_b ? a : b;
  if (depth(motion, end, edge) > std::max(at_a, at_b)) return end;
  return step_at(motion, best);
}

// How a value of a later pose changes with the curvature and with the length of a motion. Backwards, lengths are
// negative.
// Many parameters because they are the part of the motion, its end, and the value's two derivatives.
std::array<double, 2> PathContacts::by_motion(const PathSegment& motion, double length, const End& end,
                                              const Vec2& place, const Vec2& by_place, double by_turn) const {
  const double turned = by_place.dot(perpendicular(Vec2(place - end.place))) + by_turn;
  const double sign = sign_of(motion.gear);
  return {(by_place.dot(end.by_curvature) + turned * sign * length) / (unit_ * unit_),
          sign * (by_place.dot(end.ahead) + turned * motion.curvature)};
}

void PathContacts::add_contact(std::size_t i, const Step& step, const BodyContact& contact) {
  const std::size_t first = gradients_.size();
  gradients_.resize(first + 2 * motions_.size(), 0.0);
  const auto add = [&](std::size_t j, double length, const End& end, double share) {
    const auto [by_curvature, by_length] =
        by_motion(motions_[j], length, end, step.place, contact.by_place, contact.by_turn);
    gradients_[first + 2 * j] = by_curvature;
    gradients_[first + 2 * j + 1] = share * by_length;
  };
  for (std::size_t j = 0; j < i; ++j) add(j, motions_[j].length, ends_[j], 1.0);
  // A place on the motion itself keeps its share of the length.
  add(i, step.at, end_at(motions_[i], step), motions_[i].length > 0.0 ? step.at / motions_[i].length : 0.0);
  const double depth = contact.depth / unit_;
  values_.push_back(depth);
  deepest_ = std::max(deepest_, depth);
  if (depth > 0.0) square_sum_ += depth * depth;
}

void PathContacts::add_end(const Pose& goal) {
  const Pose end = motions_.back().end();
  const Vec2 off = (end.position() - goal.position()) / unit_;
  const Eigen::Vector3d rest(off.x(), off.y(), wrap_signed(end.heading - goal.heading));
  const auto by = end_gradients(motions_);
  for (Eigen::Index row = 0; row < 3; ++row) {
    values_.push_back(kEndWeight * rest(row));
    for (Eigen::Index i = 0; i < by.cols(); ++i) gradients_.push_back(kEndWeight * by(row, i));
  }
  off_goal_ = rest.cwiseAbs().maxCoeff();
  square_sum_ += kEndWeight * kEndWeight * rest.squaredNorm();
}

Eigen::Matrix<double, 3, Eigen::Dynamic> PathContacts::end_gradients(const std::vector<PathSegment>& motions) const {
  Eigen::Matrix<double, 3, Eigen::Dynamic> by(3, static_cast<Eigen::Index>(2 * motions.size()));
  const Vec2 place = motions.back().end().position();
  for (std::size_t j = 0; j < motions.size(); ++j) {
    const PathSegment& m = motions[j];
    const End end = end_at(m, step_at(m, m.length));
    const auto x = by_motion(m, m.length, end, place, Vec2(1.0, 0.0), 0.0);
    const auto y = by_motion(m, m.length, end, place, Vec2(0.0, 1.0), 0.0);
    const auto turn = by_motion(m, m.length, end, place, Vec2(0.0, 0.0), unit_);
    for (const std::size_t k : {0, 1})
      by.col(static_cast<Eigen::Index>(2 * j + k)) = Eigen::Vector3d(x[k], y[k], turn[k]);
  }
  return by;
}

}  // namespace arcway::internal
