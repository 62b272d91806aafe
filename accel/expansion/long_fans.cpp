#include "accel/expansion/long_fans.h"

#include "arcway/executor.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

LongFans::LongFans(const SightMap& map, std::uint32_t least, const StopClock& clock) {
  StopTicker ticker(clock);
  const std::span<const SightMap::Door> doors = map.doors();
  const auto count = static_cast<std::uint32_t>(doors.size());
  const auto left_end = [&](std::uint32_t door) { return doors[Triangulation::next(door)].site; };
  const auto right_end = [&](std::uint32_t door) { return doors[Triangulation::previous(door)].site; };
  std::vector<std::uint32_t> degree(map.sites().size(), 0);
  for (std::uint32_t door = 0; door < count; ++door) {
    end_if_over(ticker);
    ++degree[left_end(door)];
  }

  std::vector<bool> is_taken(count, false);
  std::vector<std::uint32_t> fan;
  // From a door on, around its left end, up to a wall or half a turn.
  const auto follow = [&](std::uint32_t door) {
    while (door != kNone && !is_taken[door]) {
      const std::uint32_t pivot = left_end(door), first_site = right_end(door);
      fan.clear();
      for (; door != kNone && !is_taken[door]; door = doors[door].left) {
        end_if_over(ticker);
        if (orientation(map.sites()[pivot], map.sites()[first_site], doors[door].apex) <= 0) break;
        is_taken[door] = true;
        fan.push_back(door);
      }
      if (fan.empty()) return;
      if (fan.size() >= least) add_fan(map, fan, ticker);
    }
  };
  const auto is_long = [&](std::uint32_t door) {
    end_if_over(ticker);
    return degree[left_end(door)] >= least;
  };
  for (std::uint32_t door = 0; door < count; ++door)  // behind walls first
    if (is_long(door) && doors[Triangulation::next(door)].left == kNone) follow(door);
  for (std::uint32_t door = 0; door < count; ++door)
    if (is_long(door)) follow(door);
  if (fans_.empty()) return;
  place_.assign(count, kNone);
  for (std::uint32_t i = 0; i < doors_.size(); ++i) place_[doors_[i]] = i;
}

void LongFans::add_fan(const SightMap& map, std::span<const std::uint32_t> doors, StopTicker& ticker) {
  const Fan fan{map.doors()[Triangulation::next(doors.front())].site, static_cast<std::uint32_t>(doors_.size()),
                static_cast<std::uint32_t>(doors.size()), static_cast<std::uint32_t>(hull_starts_.size() - 1)};
  doors_.insert(doors_.end(), doors.begin(), doors.end());
  fan_of_.insert(fan_of_.end(), doors.size(), static_cast<std::uint32_t>(fans_.size()));
  rim_.push_back(map.doors()[Triangulation::previous(doors.front())].site);
  for (const std::uint32_t door : doors) rim_.push_back(map.doors()[door].site);
  fans_.push_back(fan);
  add_hulls(map, fans_.back(), ticker);
}

// A corner is on the side of a hull that faces the pivot if it is on the pivot's side of the line between its
// neighbors.
void LongFans::add_hulls(const SightMap& map, const Fan& fan, StopTicker& ticker) {
  const std::span<const Vec2> sites = map.sites();
  std::vector<std::uint32_t> chain;
  const auto append = [&](std::uint32_t site) {
    while (chain.size() >= 2 && orientation(sites[chain[chain.size() - 2]], sites[chain.back()], sites[site]) >= 0)
      chain.pop_back();
    chain.push_back(site);
  };
  for (std::uint32_t level = 0; level < levels(fan); ++level) {
    for (std::uint32_t block = 0; block < blocks(fan, level); ++block) {
      end_if_over(ticker);
      chain.clear();
      if (level == 0) {
        for (std::uint32_t i = 0; i < kLeaf; ++i) append(site(fan, block * kLeaf + i));
      } else {
        for (const std::uint32_t half : {2 * block, 2 * block + 1})
          for (const std::uint32_t s : hull(fan, level - 1, half)) append(s);
      }
      hull_sites_.insert(hull_sites_.end(), chain.begin(), chain.end());
      hull_starts_.push_back(static_cast<std::uint32_t>(hull_sites_.size()));
    }
  }
}

}  // namespace arcway::internal
