#include "core/model/world_zones.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "arcway/vehicle.h"
#include "core/model/world_checks.h"

namespace arcway {

using namespace internal;

std::shared_ptr<const World::Zones> World::Zones::of(std::vector<Zone> zones,
                                                     std::span<const std::uint32_t> keep_outs) {
  if (zones.empty()) return nullptr;
  auto result = std::make_shared<Zones>();
  result->all = std::move(zones);
  for (std::uint32_t i = 0; i < keep_outs.size(); ++i)
    if (keep_outs[i] != kNone) result->closed.push_back({keep_outs[i], i});
  std::ranges::sort(result->closed, {}, &Closed::obstacle);
  return result;
}

World World::with_zones(std::vector<Zone> zones) const {
  require_zones(zones);
  std::vector<ObstacleId> closed;
  if (zones_)
    for (const Zones::Closed& c : zones_->closed) closed.push_back(obstacle_with(c.obstacle));
  World world = closed.empty() ? *this : with_obstacles_changed(closed, {});
  world.zones_ = Zones::of(std::move(zones), {});
  return world;
}

std::span<const Zone> World::zones() const {
  return zones_ ? std::span<const Zone>(zones_->all) : std::span<const Zone>();
}

std::uint32_t World::keep_out_of(ObstacleId o) const {
  if (!zones_ || o >= obstacle_count()) return kNone;
  const auto at = std::ranges::lower_bound(zones_->closed, key_of(o), {}, &Zones::Closed::obstacle);
  return at != zones_->closed.end() && at->obstacle == key_of(o) ? at->zone : kNone;
}

World World::for_vehicle(const Vehicle& vehicle) const {
  if (!zones_) return *this;
  std::vector<bool> missing(zones_->all.size());
  std::transform(zones_->all.begin(), zones_->all.end(), missing.begin(), [&](const Zone& zone) {
    const auto* keep_out = std::get_if<KeepOut>(&zone.rule);
    return keep_out != nullptr && keep_out->is_for(vehicle.parameters().name);
  });
  auto after = std::make_shared<Zones>();
  std::vector<ObstacleId> removed;
  for (const Zones::Closed& closed : zones_->closed) {
    if (missing[closed.zone]) {
      after->closed.push_back(closed);
      missing[closed.zone] = false;
    } else {
      removed.push_back(obstacle_with(closed.obstacle));
    }
  }
  std::vector<Polygon> added;
  for (std::size_t i = 0; i < missing.size(); ++i)
    if (missing[i]) added.push_back(zones_->all[i].area);
  if (removed.empty() && added.empty()) return *this;
  World world = with_obstacles_changed(removed, added);
  auto next = static_cast<ObstacleId>(world.obstacle_count() - added.size());
  for (std::uint32_t i = 0; i < missing.size(); ++i)
    if (missing[i]) after->closed.push_back({world.key_of(next++), i});
  after->all = zones_->all;
  world.zones_ = std::move(after);
  return world;
}

World World::changed(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) const {
  World world = with_obstacles_changed(removed, added);
  if (!zones_ || zones_->closed.empty() || removed.empty()) return world;
  std::vector<bool> gone(zones_->all.size());
  for (const Zones::Closed& closed : zones_->closed) gone[closed.zone] = world.obstacle_with(closed.obstacle) == kNone;
  auto after = std::make_shared<Zones>();
  std::vector<std::uint32_t> place(gone.size());  // of each zone among those that are left
  for (std::size_t i = 0; i < gone.size(); ++i) {
    place[i] = static_cast<std::uint32_t>(after->all.size());
    if (!gone[i]) after->all.push_back(zones_->all[i]);
  }
  for (const Zones::Closed& closed : zones_->closed)
    if (!gone[closed.zone]) after->closed.push_back({closed.obstacle, place[closed.zone]});
  world.zones_ = after->all.empty() ? nullptr : std::move(after);
  return world;
}

void World::add_zones(WorldSnapshot& snapshot) const {
  if (!zones_) return;
  snapshot.zones = zones_->all;
  if (zones_->closed.empty()) return;
  snapshot.keep_outs.assign(zones_->all.size(), kNone);
  for (const Zones::Closed& closed : zones_->closed) snapshot.keep_outs[closed.zone] = obstacle_with(closed.obstacle);
}

}  // namespace arcway
