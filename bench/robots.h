#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/vehicle.h"

namespace arcway::internal::bench {

/// A vehicle that studies plan for, with its name in benchmarks and reports. bench/robots/NAME.json is the same robot
/// for the tool.
struct KeptVehicle {
  std::string_view name;
  std::string_view what;
  VehicleParameters parameters;
  [[nodiscard]] Vehicle vehicle() const { return Vehicle(parameters); }
};

/// Sources of the numbers of the kept vehicles:
///
/// - NEO: Neobotix, MP-500, Mechanical Properties (neobotix-docs.de).
/// - JH: Jungheinrich, EFG 316k, technical data in line with VDI 2198, 07/2010.
/// - FGSV: FGSV 287, Bemessungsfahrzeuge und Schleppkurven, 2001: the passenger car.
/// - AASHTO: A Policy on Geometric Design of Highways and Streets, 2004, exhibits 2-1 and 2-2: the single-unit truck
///   SU, the city transit bus CITY-BUS and the farm tractor TR.
/// - StVO: German road traffic regulations, section 3 (3): 50 km/h in towns.
/// - EU: Regulation (EU) 167/2013, article 4: 40 km/h for tractors of the index a.
/// - ISO: ISO 15622, adaptive cruise control: accelerates by at most 2 m/s^2.
///
/// **Bodies.** The body of a real vehicle of the studies is a rectangle of the true length and width, with its center
/// midway between the axles. Real bodies reach further ahead of one axle than behind the other; the difference is
/// stated. The vehicles of other outlines have their true ones.
///
/// **Turns.** The speed in turns follows from the lateral acceleration. That of road vehicles is 2 m/s^2, between
/// AASHTO's side friction factors of 0.23 for 40 km/h and 0.17 for 60 km/h. That of the AMR and the forklift is 1
/// m/s^2, which is our assumption for loads that are not lashed.
///
/// **Margins.** The safety margin is the default of 1 mm for all. It is no driver's clearance.

/// A mobile robot for pallets and boxes.
inline KeptVehicle amr() {
  return {.name = "amr",
          .what = "AMR of 1 m/s",
          .parameters = {.length = 0.823,  // NEO
                         .width = 0.592,   // NEO
                         // Our assumption, with the angle: a turning radius of 0.5 m. Two driven wheels steer, which
                         // can turn it on the spot. Their axle is the middle here. NEO: 0.116 m ahead of it.
                         .wheelbase = 0.5,
                         .steering = Steering::kSymmetric,
                         .max_steering_angle = 0.4636,
                         .max_speed = 1.0,  // our assumption, for halls with people; NEO: at most 1.5
                         .turn_speed = LateralAccelerationLimit{1.0},
                         .max_acceleration = 0.8}};  // our assumption; NEO: at most 2.4
}

/// A counterbalanced forklift for 1.6 t, its forks included.
inline KeptVehicle forklift() {
  return {.name = "forklift",
          .what = "forklift for 1.6 t",
          .parameters = {.length = 3.14,    // JH: l1. Reaches 1.49 ahead of the axles and 0.25 behind; here 0.87 each
                         .width = 1.06,     // JH: b1
                         .wheelbase = 1.4,  // JH: y
                         .steering = Steering::kRear,
                         .max_steering_angle = 1.166,  // our assumption: the front axle's middle turns by 0.6 m
                         .max_speed = 2.8,             // our assumption: 10 km/h in a hall
                         .turn_speed = LateralAccelerationLimit{1.0},
                         .max_acceleration = 0.7}};  // our assumption, with a load
}

/// A passenger car in a town.
inline KeptVehicle car() {
  return {.name = "car",
          .what = "passenger car",
          .parameters = {.length = 4.74,    // FGSV. Reaches 0.94 ahead of the axles and 1.10 behind; here 1.02 each
                         .width = 1.76,     // FGSV
                         .wheelbase = 2.7,  // FGSV
                         .max_steering_angle = 0.63,  // FGSV: an outer turning radius of 5.85, 3.70 at the rear axle
                         .max_speed = 13.9,           // StVO
                         .turn_speed = LateralAccelerationLimit{2.0},
                         .max_acceleration = 2.0}};  // ISO
}

/// A truck of two axles, for deliveries in towns.
inline KeptVehicle truck() {
  return {.name = "truck",
          .what = "single-unit truck",
          .parameters = {.length = 9.2,     // AASHTO. Reaches 1.2 ahead of the axles and 1.8 behind; here 1.55 each
                         .width = 2.4,      // AASHTO
                         .wheelbase = 6.1,  // AASHTO
                         // AASHTO: the front axle's middle turns by 11.6 m, the rear axle's by 9.87 m.
                         .max_steering_angle = 0.5537,
                         .max_speed = 13.9,  // StVO
                         .turn_speed = LateralAccelerationLimit{2.0},
                         .max_acceleration = 0.8}};  // our assumption
}

/// A farm tractor without a wagon.
inline KeptVehicle tractor() {
  return {.name = "tractor",
          .what = "farm tractor",
          .parameters = {.length = 4.9,     // AASHTO, which has no overhangs; here 0.9 each
                         .width = 2.4,      // AASHTO: 2.4 to 3.1
                         .wheelbase = 3.1,  // AASHTO
                         // AASHTO: the front axle's middle turns by 4.3 m, the rear axle's by 2.98 m.
                         .max_steering_angle = 0.805,
                         .max_speed = 11.1,  // EU
                         .turn_speed = LateralAccelerationLimit{2.0},
                         .max_acceleration = 1.0}};  // our assumption
}

/// The vehicles that studies show first.
inline const std::vector<KeptVehicle>& real_vehicles() {
  static const std::vector<KeptVehicle> vehicles{amr(), forklift(), car(), truck(), tractor()};
  return vehicles;
}

/// The passenger car with its true overhangs.
inline KeptVehicle overhang_car() {
  KeptVehicle kept = car();
  kept.name = "overhang_car", kept.what = "car with its overhangs";
  kept.parameters.length = VehicleParameters{}.length;
  kept.parameters.front_overhang = 0.94;  // FGSV
  kept.parameters.rear_overhang = 1.10;   // FGSV
  return kept;
}

/// A city bus.
inline KeptVehicle bus() {
  return {.name = "bus",
          .what = "city bus",
          .parameters = {.width = 2.6,                  // AASHTO: CITY-BUS
                         .wheelbase = 7.6,              // AASHTO
                         .max_steering_angle = 0.7221,  // AASHTO: the front axle's middle turns by 11.5 m
                         .max_speed = 13.9,             // StVO
                         .turn_speed = LateralAccelerationLimit{1.0},  // our assumption, for people who stand
                         .max_acceleration = 1.0,                      // our assumption, for the same
                         .front_overhang = 2.1,                        // AASHTO
                         .rear_overhang = 2.4}};                       // AASHTO
}

/// A vehicle with polygons in place of its length and width, and another name.
inline KeptVehicle with_footprint(KeptVehicle kept, std::string_view name, std::string_view what,
                                  std::vector<Ring> footprint) {
  kept.name = name, kept.what = what;
  kept.parameters.length = VehicleParameters{}.length, kept.parameters.width = VehicleParameters{}.width;
  kept.parameters.footprint = std::move(footprint);
  return kept;
}

/// The forklift with a pallet of 1.2 m x 0.8 m on its forks, about its front axle. The forks begin 0.34 m ahead of that
/// and end at 1.49 m, JH. The pallet's place is our assumption.
inline KeptVehicle loaded_forklift() {
  return with_footprint(forklift(), "loaded_forklift", "forklift with a pallet",
                        {{{-1.65, -0.53},
                          {0.34, -0.53},
                          {0.34, -0.6},
                          {1.14, -0.6},
                          {1.14, -0.35},
                          {1.49, -0.35},
                          {1.49, -0.25},
                          {1.14, -0.25},
                          {1.14, 0.25},
                          {1.49, 0.25},
                          {1.49, 0.35},
                          {1.14, 0.35},
                          {1.14, 0.6},
                          {0.34, 0.6},
                          {0.34, 0.53},
                          {-1.65, 0.53}}});
}

/// The tractor with a mower to the right behind it, about its rear axle. The mower is our assumption.
inline KeptVehicle mowing_tractor() {
  return with_footprint(
      tractor(), "mowing_tractor", "tractor with a mower",
      {{{-0.9, -1.2}, {4.0, -1.2}, {4.0, 1.2}, {-0.9, 1.2}}, {{-1.9, -3.6}, {-0.9, -3.6}, {-0.9, 0.4}, {-1.9, 0.4}}});
}

/// The AMR with its corners cut by 0.15 m, which is our assumption.
inline KeptVehicle cut_amr() {
  return with_footprint(amr(), "cut_amr", "AMR with cut corners",
                        {{{-0.2615, -0.296},
                          {0.2615, -0.296},
                          {0.4115, -0.146},
                          {0.4115, 0.146},
                          {0.2615, 0.296},
                          {-0.2615, 0.296},
                          {-0.4115, 0.146},
                          {-0.4115, -0.146}}});
}

/// Vehicles whose bodies are not centered rectangles.
inline const std::vector<KeptVehicle>& vehicles_of_other_outlines() {
  static const std::vector<KeptVehicle> vehicles{overhang_car(), bus(), loaded_forklift(), mowing_tractor(), cut_amr()};
  return vehicles;
}

/// The paper's robot with limits on its acceleration, sideways and along [m/s^2]: wider turns are faster, so that
/// circles of several radii matter.
struct GentleRobot {
  int lateral_acceleration, acceleration;
  [[nodiscard]] std::string name() const {
    return "lateral" + std::to_string(lateral_acceleration) + "_along" + std::to_string(acceleration);
  }
  [[nodiscard]] Vehicle vehicle() const {
    return Vehicle(
        {.turn_speed = LateralAccelerationLimit{1.0 * lateral_acceleration}, .max_acceleration = 1.0 * acceleration});
  }
};
inline constexpr GentleRobot kGentleRobots[] = {{2, 2}, {4, 2}, {8, 4}};

/// A robot for rooms, of the size of a vacuum cleaner: for grid maps of cells of 1 m.
inline Vehicle small_robot() {
  return Vehicle({.length = 0.3,
                  .width = 0.2,
                  .wheelbase = 0.2,
                  .max_steering_angle = 0.75,
                  .max_speed = 0.5,
                  .turn_speed = ConstantTurnSpeed{0.3},
                  .max_acceleration = 1.0});
}

/// A passenger car in a town.
inline Vehicle town_car() {
  return Vehicle({.length = 4.72,
                  .width = 1.94,
                  .wheelbase = 2.8,
                  .max_steering_angle = 0.75,
                  .max_speed = 14.0,
                  .turn_speed = ConstantTurnSpeed{4.0},
                  .max_acceleration = 2.0});
}

/// A boat of 12 m with its rudder at the stern.
inline Vehicle boat() {
  return Vehicle({.length = 12.0,
                  .width = 4.0,
                  .wheelbase = 10.0,
                  .steering = Steering::kRear,
                  .max_steering_angle = 0.6,
                  .max_speed = 10.0,
                  .turn_speed = ConstantTurnSpeed{5.0},
                  .max_acceleration = 0.5});
}

/// A robot whose turns of any radius are as fast as its tightest ones. The given robot can drive all of its paths, and
/// wider turns bring it nothing.
inline Vehicle without_faster_turns(const Vehicle& vehicle) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.turn_speed = ConstantTurnSpeed{vehicle.turn_speed(vehicle.min_turning_radius())};
  return Vehicle(parameters);
}

}  // namespace arcway::internal::bench
