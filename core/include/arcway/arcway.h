#pragma once

/// \file
/// Includes all public headers of core.

/// \mainpage
/// arcway plans the fastest smooth path of a car-like vehicle among polygons. Begin with arcway::World,
/// arcway::Vehicle and arcway::Planner. arcway::accel_backend makes planners fast, arcway::read_map reads maps, and
/// arcway::Validator checks paths.

#include "arcway/alternatives.h"
#include "arcway/angle.h"
#include "arcway/backend.h"
#include "arcway/body_shape.h"
#include "arcway/bottleneck.h"
#include "arcway/closed_spline.h"
#include "arcway/curved_plan.h"
#include "arcway/distance_query.h"
#include "arcway/evading_plan.h"
#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/feasible_graph_snapshot.h"
#include "arcway/graph_mode.h"
#include "arcway/heading_set.h"
#include "arcway/heuristic.h"
#include "arcway/moving_obstacle.h"
#include "arcway/path.h"
#include "arcway/plan_batch.h"
#include "arcway/plan_result.h"
#include "arcway/planner.h"
#include "arcway/polygon.h"
#include "arcway/prepared_graph.h"
#include "arcway/process_group.h"
#include "arcway/progress.h"
#include "arcway/query_set.h"
#include "arcway/refine_options.h"
#include "arcway/replan.h"
#include "arcway/snapshot.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/text.h"
#include "arcway/time_model.h"
#include "arcway/tour.h"
#include "arcway/trajectory.h"
#include "arcway/turning_radii.h"
#include "arcway/validation.h"
#include "arcway/vec2.h"
#include "arcway/vehicle.h"
#include "arcway/version.h"
#include "arcway/visibility_graph.h"
#include "arcway/visibility_query.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
