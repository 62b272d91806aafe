#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "arcway/datasets/map_file.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/vehicle.h"

namespace arcway {

/// Where the obstacles beside a drive come from.
enum class DrivenKind {
  kScattered,  ///< random polygons in the box around the drive
  kHugging,    ///< random polygons slid towards the drive until they are as near as allowed
  kCarved,     ///< all is solid but the square cells that the vehicle comes near; rows of cells are rectangles
  kRooms       ///< thin walls along x and y, open where the vehicle passes
};
inline constexpr DrivenKind kDrivenKinds[] = {DrivenKind::kScattered, DrivenKind::kHugging, DrivenKind::kCarved,
                                              DrivenKind::kRooms};
/// "scattered", "hugging", "carved", "rooms".
ARCWAY_API const char* name_of(DrivenKind kind);

struct DrivenRobot {
  std::string_view name;  ///< "car", ...
  VehicleParameters parameters;
};
/// Nine vehicles with turning radii from 9 cm to 30 m: front, rear and symmetric steering, one or several radii. Behind
/// them some of the same with bodies that are no rectangles centered between the axles.
ARCWAY_API std::span<const DrivenRobot> driven_robots();
/// How many of them are such rectangles: the first ones.
inline constexpr std::size_t kDrivenRectangles = 9;

struct DrivenParameters {
  DrivenKind kind = DrivenKind::kScattered;
  std::size_t robot = 6;    ///< number in driven_robots(), from 1
  bool both_gears = false;  ///< the drive has at least one change of gear; otherwise it is forwards all the way
  double clearance = 0.05;  ///< distance of the bare body from obstacles and bounds along the drive [m], 1e-4 to 10
  std::uint64_t seed = 1;
};

/// A map with a path that is known to be free.
struct DrivenWorld {
  MapFile map;  ///< with bounds, start and goal
  VehicleParameters robot;
  Path drive;  ///< from start to goal
};

/// A random drive of the vehicle, of arcs within its steering limits and lines, with obstacles and bounds around it.
/// These keep at least the clearance from the area that the body sweeps. The clearance is decided by bisection of the
/// motion (generators/drive_clearance.h), never sampled. The result is the same for the same parameters; headings and
/// positions along arcs are those of the platform's sine and cosine. Takes some 10 ms; hugging obstacles some 0.1 s.
/// @throws std::invalid_argument naming the parameter, its value and its limit.
ARCWAY_API DrivenWorld generate_driven_world(const DrivenParameters& parameters);

/// The drive as fast as the robot may take it, as a solved plan: what plan_to_json writes and the validator takes.
ARCWAY_API PlanResult plan_of_drive(const DrivenWorld& world);

}  // namespace arcway
