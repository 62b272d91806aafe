#pragma once

#include <functional>
#include <string>
#include <vector>

#include "arcway/backend.h"
#include "arcway/planner.h"

namespace arcway::internal::figures {

/// A figure of the paper as an SVG document, its numbers in the caption.
struct Figure {
  std::string name;  ///< name of the file, without extension
  std::string svg;
  std::string caption;  ///< lines end at '\n'
};

/// Everything is computed when it is called, on the paper's example and its robot.
Figure visibility_graphs(const Planner& planner);                                  ///< figure 1
Figure vehicle_model(const Vehicle& vehicle);                                      ///< figure 2
Figure radial_sets(const Planner& planner, const PlanResult& plan);                ///< figure 3
Figure minimum_distance_pairs(const Planner& planner, const PlanResult& plan);     ///< figure 4
Figure swept_turn(const Vehicle& vehicle, const std::string& name);                ///< figure 5, of a turn to the left
Figure speed_profiles(const Vehicle& vehicle);                                     ///< figure 6
Figure feasible_graph_and_motion(const Planner& planner, const PlanResult& plan);  ///< figure 7

/// The vehicles of bench::vehicles_of_other_outlines() side by side, with what they sweep in their tightest turns.
Figure vehicle_gallery();

/// A drive through a map in which obstacles walk about, vanish and come back: as an animation of SVG elements alone,
/// and as a row of moments. The plans have no time limit, so that the figures depend on nothing but their backend's
/// answers.
/// @param make_backend  one that can be changed.
struct LiveFigures {
  Figure animation, moments;
};
LiveFigures live_drive(const std::function<Backend(const World&)>& make_backend);

/// A number with a fixed count of digits after the point.
std::string digits(double value, int count);

}  // namespace arcway::internal::figures
