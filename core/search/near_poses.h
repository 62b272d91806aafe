#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "arcway/path.h"
#include "arcway/vec2.h"
#include "core/base/hash_of.h"

namespace arcway::internal {

/// A pose of a tree that is near another.
struct NearPose {
  double distance;  ///< by some measure [m]
  std::uint32_t node;
  friend bool operator<(const NearPose& a, const NearPose& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.node < b.node;
  }
};

/// A spatial index of a tree's poses, for those near another pose.
class NearPoses {
 public:
  struct Entry {
    std::uint32_t node;
    Pose pose;
    Vec2 ahead;
  };

  /// @param cell  distance within which poses are found at least [m].
  explicit NearPoses(double cell) : cell_(cell) {}
  void add(std::uint32_t node, const Pose& pose) {
    cells_[key(index(pose.x), index(pose.y))].push_back({node, pose, direction_of(pose.heading)});
  }
  /// Calls visit(entry) for all poses within `cell`, and some further away.
  template <class Visit>
  void visit(const Pose& near, Visit&& visit) const {
    for (const std::int64_t dx : {-1, 0, 1})
      for (const std::int64_t dy : {-1, 0, 1}) {
        const auto found = cells_.find(key(index(near.x) + dx, index(near.y) + dy));
        if (found == cells_.end()) continue;
        for (const Entry& entry : found->second) visit(entry);
      }
  }

 private:
  [[nodiscard]] std::int64_t index(double x) const { return std::llround(x / cell_); }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    const std::array<std::uint64_t, 2> parts{static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y)};
    return hash_of(parts);
  }
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<Entry>> cells_;
};

}  // namespace arcway::internal
