#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/world.h"
#include "core/planner/planner.h"
#include "datasets/generators/driven_world.h"
#include "datasets/map/map_file.h"

namespace [[gnu::visibility("default")]] arcway {

/// \file
/// Names of generated worlds, shared by tests, benchmarks and the tool: a name is all that it takes to have the same
/// world again, on any platform (worlds "driven/..." up to the platform's sine and cosine).
///
///     const World world = catalogue_world("clutter/star/n1000/m10/f30/s7");
///     for (const PlanRequest& query : catalogue_queries("clutter/star/n1000/m10/f30/s7", 50, 1)) ...
///
/// A name is a family, its kind where it has kinds, and parts of one letter and a whole number, separated by
/// slashes. Parts may be left out, which takes their defaults, and stand in any order.

/// A family of worlds: "clutter", {"convex", "star", ...}, "clutter/KIND/nOBSTACLES/...", what it shows.
struct CatalogueFamily {
  std::string_view name;
  std::vector<std::string_view> kinds;  ///< none if the family has but one
  std::string_view pattern;
  std::string_view what;
};
std::span<const CatalogueFamily> catalogue_families();

/// Whether the name's first part is a family of the catalogue; the rest may still be wrong.
bool is_catalogue_name(std::string_view name);

/// The map of a name, and its start and goal if it has them.
/// @throws std::invalid_argument naming the part that is wrong and what is expected there.
MapFile catalogue_map(std::string_view name);
World catalogue_world(std::string_view name);

/// The whole of a world "driven/...": map, robot, and the drive that proves that a way exists. Nothing for the names of
/// other families.
/// @throws std::invalid_argument as above.
std::optional<DrivenWorld> catalogue_driven_world(std::string_view name);

/// Pose pairs for a catalogue world and the paper's robot, by random_queries: the same for the same arguments.
std::vector<PlanRequest> catalogue_queries(std::string_view name, std::size_t count, std::uint64_t seed);

}  // namespace arcway
