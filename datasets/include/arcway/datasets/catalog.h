#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/datasets/driven_world.h"
#include "arcway/datasets/map_file.h"
#include "arcway/export.h"
#include "arcway/planner.h"
#include "arcway/world.h"

namespace arcway {

/// \file
/// Names of generated worlds, shared by tests, benchmarks and the tool. A name is enough to get the same world again on
/// any platform; worlds "driven/..." depend on the platform's sine and cosine.
///
///     const World world = catalog_world("clutter/star/n1000/m10/f30/s7");
///     for (const PlanRequest& query : catalog_queries("clutter/star/n1000/m10/f30/s7", 50, 1)) ...
///
/// A name is a family, its kind where it has kinds, and parts of one letter and a whole number, separated by slashes.
/// Parts may be left out, which takes their defaults, and stand in any order.

/// A family of worlds: "clutter", {"convex", "star", ...}, "clutter/KIND/nOBSTACLES/...", what it shows.
struct CatalogFamily {
  std::string_view name;
  std::vector<std::string_view> kinds;  ///< none if the family has but one
  std::string_view pattern;
  std::string_view what;
};
ARCWAY_API std::span<const CatalogFamily> catalog_families();

/// Whether the name's first part is a family of the catalog; the rest may still be wrong.
ARCWAY_API bool is_catalog_name(std::string_view name);

/// The map of a name, and its start and goal if it has them.
/// @throws std::invalid_argument naming the part that is wrong and what is expected there.
ARCWAY_API MapFile catalog_map(std::string_view name);
ARCWAY_API World catalog_world(std::string_view name);

/// A world "driven/..." with its robot, and the drive that proves that a path exists. Nothing for names of other
/// families.
/// @throws std::invalid_argument naming the part that is wrong and what is expected there.
ARCWAY_API std::optional<DrivenWorld> catalog_driven_world(std::string_view name);

/// Pose pairs for a catalog world and the paper's robot, by random_queries: the same for the same arguments.
ARCWAY_API std::vector<PlanRequest> catalog_queries(std::string_view name, std::size_t count, std::uint64_t seed);

}  // namespace arcway
