#pragma once

#include <optional>

#include "core/model/path.h"
#include "core/model/vehicle.h"
#include "core/model/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// The task of figure 7: eight polygonal obstacles on a field of 900 x 600 m, the robot, start and goal as the paper
/// states them. The paper does not list its obstacles' coordinates: the layout is ours.
struct PaperExample {
  World world;
  VehicleParameters robot;
  Pose start;  ///< (30, 30, 90 degrees)
  Pose goal;   ///< (850, 550, 90 degrees)
};
PaperExample paper_example();

}  // namespace arcway
