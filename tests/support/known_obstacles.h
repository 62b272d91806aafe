#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/world.h"

namespace arcway::internal::test {

/// The obstacles of a world without zones, and what World::changed makes of them by what it documents.
class KnownObstacles {
 public:
  explicit KnownObstacles(const std::vector<Polygon>& polygons) {
    for (const Polygon& polygon : polygons) append(polygon);
  }

  struct Known {
    Polygon polygon;
    ObstacleKey key;
    std::size_t birth;  // another one for each obstacle
  };

  /// @param removed  ascending.
  void change(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) {
    std::vector<ObstacleId> left(removed.begin(), removed.end());
    std::vector<Polygon> behind;
    for (const Polygon& polygon : added) {
      if (const std::optional<ObstacleId> place = take_place(polygon, left)) {
        all_[*place].polygon = polygon;
        all_[*place].birth = births_++;
      } else {
        behind.push_back(polygon);
      }
    }
    for (auto o = left.rbegin(); o != left.rend(); ++o) all_.erase(all_.begin() + *o);
    for (const Polygon& polygon : behind) append(polygon);
  }

  [[nodiscard]] const std::vector<Known>& all() const { return all_; }
  [[nodiscard]] std::vector<Polygon> polygons() const {
    std::vector<Polygon> polygons;
    for (const Known& known : all_) polygons.push_back(known.polygon);
    return polygons;
  }
  /// The id of an obstacle now; kNone if it is gone.
  [[nodiscard]] ObstacleId id_of(std::size_t birth) const {
    for (ObstacleId o = 0; o < all_.size(); ++o)
      if (all_[o].birth == birth) return o;
    return kNone;
  }

 private:
  static bool have_equal_rings(const Polygon& a, const Polygon& b) {
    if (a.outer.size() != b.outer.size() || a.holes.size() != b.holes.size()) return false;
    for (std::size_t h = 0; h < a.holes.size(); ++h)
      if (a.holes[h].size() != b.holes[h].size()) return false;
    return true;
  }
  // The first removed obstacle in whose place a polygon may be. It is taken out of the list.
  std::optional<ObstacleId> take_place(const Polygon& polygon, std::vector<ObstacleId>& removed) const {
    for (std::size_t i = 0; i < removed.size(); ++i) {
      const ObstacleId o = removed[i];
      if (!have_equal_rings(all_[o].polygon, polygon)) continue;
      removed.erase(removed.begin() + static_cast<std::ptrdiff_t>(i));
      return o;
    }
    return std::nullopt;
  }
  void append(const Polygon& polygon) { all_.push_back({polygon, next_key_++, births_++}); }

  std::vector<Known> all_;
  ObstacleKey next_key_ = 0;
  std::size_t births_ = 0;
};

}  // namespace arcway::internal::test
