#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/world.h"
#include "datasets/catalogue.h"
#include "datasets/random.h"

namespace arcway {

/// A catalogue world, made once and kept.
inline const World& world_of(const std::string& name) {
  static std::map<std::string, World> worlds;
  const auto found = worlds.find(name);
  return found != worlds.end() ? found->second : worlds.emplace(name, catalogue_world(name)).first->second;
}

/// A third of the area covered by convex obstacles of 10 vertices.
inline const World& clutter_of(std::size_t edges) {
  return world_of("clutter/convex/n" + std::to_string(edges / 10) + "/m10/f30/s7");
}

}  // namespace arcway
