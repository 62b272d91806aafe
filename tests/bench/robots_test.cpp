#include "bench/robots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "arcway/datasets/robot.h"
#include "bench/vehicle_worlds.h"

namespace arcway::internal::bench {
namespace {

const std::filesystem::path kRobots = std::filesystem::path(ARCWAY_SOURCE_DIR) / "bench/robots";

TEST(KeptVehicles, AreTheRobotsOfTheTool) {
  for (const auto& vehicles : {real_vehicles(), vehicles_of_other_outlines()}) {
    for (const KeptVehicle& kept : vehicles) {
      const std::string file = std::string(kept.name) + ".json";
      EXPECT_EQ(read_robot_file(kRobots / file), kept.parameters) << file << " should be " << to_json(kept.parameters);
    }
  }
  EXPECT_EQ(read_robot_file(kRobots / "paper.json"), VehicleParameters());
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kRobots)) files += entry.is_regular_file();
  EXPECT_EQ(files, real_vehicles().size() + vehicles_of_other_outlines().size() + 1);
}

/// Radius of the circle of the front axle's middle [m].
double front_axle_radius(const KeptVehicle& kept) {
  return std::hypot(kept.parameters.wheelbase, kept.vehicle().min_turning_radius());
}

TEST(KeptVehicles, TurnAsTheirSourcesSay) {
  EXPECT_NEAR(amr().vehicle().min_turning_radius(), 0.5, 1e-3);
  EXPECT_NEAR(forklift().vehicle().min_turning_radius(), 0.6, 1e-3);
  const double front = car().parameters.wheelbase + 0.94, half_width = 0.5 * car().parameters.width;
  EXPECT_NEAR(std::hypot(front, car().vehicle().min_turning_radius() + half_width), 5.85, 0.01);
  EXPECT_NEAR(front_axle_radius(truck()), 11.6, 0.01);
  EXPECT_NEAR(front_axle_radius(tractor()), 4.3, 0.01);
  EXPECT_NEAR(front_axle_radius(bus()), 11.5, 0.01);
}

TEST(KeptVehicles, OfOtherOutlinesReachAsTheirSourcesSay) {
  EXPECT_NEAR(bus().vehicle().footprint().front, 9.7, 1e-12);
  EXPECT_NEAR(bus().vehicle().footprint().rear, 2.4, 1e-12);
  EXPECT_NEAR(overhang_car().vehicle().footprint().length(), car().parameters.length, 1e-12);
  EXPECT_NEAR(loaded_forklift().vehicle().footprint().length(), forklift().parameters.length, 1e-12);
  EXPECT_EQ(mowing_tractor().vehicle().footprint().right, 3.6);
  EXPECT_EQ(mowing_tractor().vehicle().footprint().front, tractor().vehicle().footprint().front);
  EXPECT_NEAR(cut_amr().vehicle().footprint().width(), amr().parameters.width, 1e-12);
}

TEST(KeptVehicles, AreTheFasterTheWiderTheyTurn) {
  for (const KeptVehicle& kept : real_vehicles()) {
    const Vehicle vehicle = kept.vehicle();
    const double tightest = vehicle.min_turning_radius();
    EXPECT_LT(vehicle.turn_speed(tightest), vehicle.turn_speed(2.0 * tightest)) << kept.name;
    const double lateral = std::pow(vehicle.turn_speed(tightest), 2) / tightest;
    EXPECT_LE(lateral, 2.0 + 1e-9) << kept.name << ": more than a fifth of g";
  }
}

TEST(WorldsForVehicles, AreTheCatalogsForThePapersRobot) {
  const std::string name = "clutter/star/n20/m6/f30";
  const World world = world_for(Vehicle(), name), catalog = catalog_world(name);
  EXPECT_TRUE(std::ranges::equal(world.vertices(), catalog.vertices()));
  const auto ours = queries_for(Vehicle(), world, 3, 1), theirs = catalog_queries(name, 3, 1);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_EQ(ours[i].start.position(), theirs[i].start.position());
    EXPECT_EQ(ours[i].goal.heading, theirs[i].goal.heading);
  }
}

TEST(WorldsForVehicles, GrowWithTheTurningCircle) {
  const std::string name = "clutter/convex/n20/m6/f30";
  const World catalog = catalog_world(name);
  const Vec2 side = catalog.box().max - catalog.box().min;
  for (const KeptVehicle& kept : real_vehicles()) {
    const World world = world_for(kept.vehicle(), name);
    const double scaled = (world.box().max - world.box().min).maxCoeff();
    EXPECT_NEAR(scaled / outer_turning_radius(kept.vehicle()), side.maxCoeff() / outer_turning_radius(Vehicle()), 1e-9)
        << kept.name;
  }
  EXPECT_GT(world_scale(truck().vehicle()), 5.0);
  EXPECT_LT(world_scale(amr().vehicle()), 0.5);
}

}  // namespace
}  // namespace arcway::internal::bench
