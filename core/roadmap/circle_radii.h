#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "core/model/side_radii.h"

namespace arcway::internal {

/// The radii of turn circles [m]: as many to the left as to the right, none smaller than the one before.
class CircleRadii {
 public:
  CircleRadii() = default;
  /// As many radii to both sides, and equal ones.
  CircleRadii(std::vector<double> to_both_sides) : left_(to_both_sides), right_(std::move(to_both_sides)) {}
  CircleRadii(std::initializer_list<double> to_both_sides) : CircleRadii(std::vector<double>(to_both_sides)) {}
  /// The radii of a vehicle. Those to its tighter side are given, ascending. Those to the other side reach from its
  /// smallest radius to the largest of them all, spread in proportion.
  CircleRadii(const Vehicle& vehicle, const std::vector<double>& tighter);

  [[nodiscard]] std::size_t size() const { return left_.size(); }
  [[nodiscard]] std::span<const double> of(Side side) const { return side == Side::kLeft ? left_ : right_; }
  [[nodiscard]] SideRadii operator[](std::size_t i) const { return {left_[i], right_[i]}; }
  [[nodiscard]] SideRadii front() const { return (*this)[0]; }
  /// The smallest ones.
  [[nodiscard]] CircleRadii first(std::size_t count) const;
  /// The number of radii, from the first, up to the first ones that lead around vertices to both sides; all of them if
  /// none do.
  /// @param grown_body  the body grown by the safety margin.
  [[nodiscard]] std::size_t tightest(const Footprint& grown_body) const;
  friend bool operator==(const CircleRadii&, const CircleRadii&) = default;

 private:
  std::vector<double> left_, right_;
};

/// Whether circles of these radii lead around vertices to both sides. On a circle of at most the body's reach to its
/// side the body covers the center, where the vertex would be.
bool lead_round_vertices(const Footprint& grown_body, const SideRadii& radii);

}  // namespace arcway::internal
