#pragma once

#include <optional>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// The task of figure 7: eight polygonal obstacles on a field of 900 x 600 m, the robot, start and goal as the paper
/// states them. The paper does not list its obstacles' coordinates: the layout is ours.
struct PaperExample {
  World world;
  VehicleParameters robot;
  Pose start;  ///< (30, 30, 90 degrees)
  Pose goal;   ///< (850, 550, 90 degrees)
};
ARCWAY_API PaperExample paper_example();

}  // namespace arcway
