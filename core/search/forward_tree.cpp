#include "core/search/forward_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "arcway/angle.h"
#include "core/base/hash_of.h"
#include "core/search/tree_path.h"

namespace arcway::internal {

ForwardTree::ForwardTree(const Roadmap& map, const Pose& root, Direction direction, const TreePass& pass,
                         std::function<double(const Pose&)> remaining)
    : map_(&map),
      direction_(direction),
      gear_(direction == Direction::kFromStart ? Gear::kForward : Gear::kReverse),
      remaining_(std::move(remaining)),
      radii_(map.vehicle),
      body_length_(map.body.front + map.body.rear),
      far_(kTree.longest * std::max(radii_.smaller(), body_length_)),
      coarsest_(kTree.coarsest * std::max(radii_.smaller(), body_length_)),
      halvings_(pass.halvings),
      levels_(std::max(0, static_cast<int>(std::ceil(std::log2(coarsest_ / (pass.finest * body_length_)))))),
      contact_(*map.outlines, map.body, map.one_way_zones.get(), gear_),
      open_(kTree.visit * coarsest_) {
  nodes_.push_back({root, {root, 0.0, 0.0}, kRoot, 0.0});
  open_.push(0.0, kRoot);
  cells_.insert(cell_of(root, level_of(root)));
}

std::optional<std::uint32_t> ForwardTree::expand() {
  const std::optional<std::uint32_t> next =
      open_.pop([this](std::uint32_t node) { return cell_of(nodes_[node].pose, 0); });
  if (!next) return std::nullopt;
  const std::uint32_t at = *next;
  look_around(nodes_[at].pose);
  for (std::size_t i = 0; i < rays_.size(); ++i)
    if (rays_[i].first || leads_furthest(i))
      for (const double share : kTree.shares) {
        const double length = share * rays_[i].reach;
        if (length >= kTree.least * body_length_) add(at, rays_[i].curvature, length);
      }
  return at;
}

// Finds the rays from a pose.
void ForwardTree::look_around(const Pose& pose) {
  contact_.begin(pose, far_);
  rays_.clear();
  for (const double bend : kTree.bends) rays_.push_back(ray(bend / radii_.on(bend), true));
  for (int i = 0; i < halvings_; ++i) halve_steps();
}

ForwardTree::Ray ForwardTree::ray(double curvature, bool first) const {
  return {curvature, contact_(curvature, gear_) - kTree.slack * body_length_, first};
}

bool ForwardTree::leads_furthest(std::size_t i) const {
  return (i == 0 || rays_[i].reach >= rays_[i - 1].reach) &&
         (i + 1 == rays_.size() || rays_[i].reach >= rays_[i + 1].reach);
}

// Looks between the rays that lead furthest and their neighbors, where these do not lead as far.
void ForwardTree::halve_steps() {
  halved_.clear();
  for (std::size_t i = 0; i + 1 < rays_.size(); ++i) {
    halved_.push_back(rays_[i]);
    const double a = rays_[i].reach, b = rays_[i + 1].reach;
    if (leads_furthest(a >= b ? i : i + 1) && std::min(a, b) < far_ - 2.0 * kTree.slack * body_length_)
      halved_.push_back(ray(0.5 * (rays_[i].curvature + rays_[i + 1].curvature), false));
  }
  halved_.push_back(rays_.back());
  std::swap(rays_, halved_);
}

void ForwardTree::add(std::uint32_t from, double curvature, double length) {
  const PathSegment away{nodes_[from].pose, length, curvature, gear_};
  const Pose end = away.end();
  if (!cells_.insert(cell_of(end, level_of(end))).second) return;
  extent_ = std::max(extent_, (end.position() - nodes_[kRoot].pose.position()).norm());
  const double way = nodes_[from].length + length;
  nodes_.push_back({end, away.forwards(), from, way});
  open_.push(way + remaining_(end), static_cast<std::uint32_t>(nodes_.size() - 1));
}

Path ForwardTree::connection(std::uint32_t node) const {
  return direction_ == Direction::kFromStart ? path_from_root(nodes_, node) : motions_up(nodes_, node);
}

// Cells are as large as the room beside the body, so that narrow places are told apart finely, and open ones coarsely.
int ForwardTree::level_of(const Pose& pose) const {
  const double room = map_->queries.distance->closest(middle_of(map_->body, pose)).distance - 0.5 * map_->body.width();
  int level = 0;
  for (double size = coarsest_; level < levels_ && size > room; ++level) size *= 0.5;
  return level;
}

std::uint64_t ForwardTree::cell_of(const Pose& pose, int level) const {
  const Pose& root = nodes_[kRoot].pose;
  const double size = std::ldexp(coarsest_, -level);
  const double turn = std::min(size / body_length_, kTree.coarsest);
  const Vec2 ahead = direction_of(root.heading), d = pose.position() - root.position();
  const auto index = [](double value) { return static_cast<std::uint64_t>(std::llround(value)); };
  const std::array<std::uint64_t, 4> parts{index(ahead.dot(d) / size), index(cross(ahead, d) / size),
                                           index(wrap_positive(pose.heading - root.heading) / turn),
                                           static_cast<std::uint64_t>(level)};
  return hash_of(parts);
}

}  // namespace arcway::internal
