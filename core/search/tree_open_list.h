#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/base/open_list.h"

namespace arcway::internal {

/// The open list of a tree, the most promising node first. Each expansion of a node makes the other nodes of its place
/// less promising, so that a tree does not stay where it got nowhere.
class TreeOpenList {
 public:
  /// @param visit_cost  added to the estimates of a place's nodes by each expansion there.
  explicit TreeOpenList(double visit_cost) : visit_cost_(visit_cost) {}

  void push(double estimate, std::uint32_t node) { open_.push({estimate, node, 0}); }

  /// Takes the most promising node; none if the list is empty.
  /// @param place_of  maps a node to the key of its place.
  template <class PlaceOf>
  std::optional<std::uint32_t> pop(PlaceOf&& place_of) {
    while (!open_.empty()) {
      Waiting next = open_.pop();
      std::uint32_t& visits = visits_[place_of(next.node)];
      if (visits == next.visits) {
        ++visits;
        return next.node;
      }
      next.estimate += visit_cost_ * (visits - next.visits);
      next.visits = visits;
      open_.push(next);
    }
    return std::nullopt;
  }

 private:
  struct Waiting {
    double estimate;
    std::uint32_t node;
    std::uint32_t visits;  // of its place that the estimate counts
    friend bool before(const Waiting& a, const Waiting& b) {
      return a.estimate != b.estimate ? a.estimate < b.estimate : a.node < b.node;
    }
  };

  double visit_cost_;
  OpenList<Waiting> open_;
  std::unordered_map<std::uint64_t, std::uint32_t> visits_;  // by place
};

}  // namespace arcway::internal
