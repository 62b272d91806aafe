#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/paper_example.h"
#include "bench/cli/arguments.h"
#include "bench/cli/draw_live_drive.h"
#include "bench/cli/output_files.h"
#include "bench/figures/figures.h"
#include "bench/robots.h"

namespace arcway::internal::cli {
namespace {

int draw_figures(const std::string& folder, std::string& out) {
  const PaperExample example = paper_example();
  const Planner planner(example.world, Vehicle(example.robot));
  const PlanResult plan = planner.plan({.start = example.start, .goal = example.goal});
  if (!plan.solved()) {
    out = plan.reason + "\n";
    return kExitNoPath;
  }
  make_folders(folder);
  const figures::LiveFigures live = draw_live_drive();
  const std::vector<figures::Figure> figures = {
      figures::visibility_graphs(planner),
      figures::vehicle_model(planner.vehicle()),
      figures::radial_sets(planner, plan),
      figures::minimum_distance_pairs(planner, plan),
      figures::swept_turn(planner.vehicle(), "figure5"),
      figures::swept_turn(bench::mowing_tractor().vehicle(), "figure5_tractor"),
      figures::speed_profiles(planner.vehicle()),
      figures::feasible_graph_and_motion(planner, plan),
      figures::vehicle_gallery(),
      live.animation,
      live.moments};
  const auto target = [&](const figures::Figure& figure) {
    return (std::filesystem::path(folder) / (figure.name + ".svg")).string();
  };
  std::vector<std::string> targets;
  for (const figures::Figure& figure : figures) targets.push_back(target(figure));
  OutputFiles files(targets);
  for (const figures::Figure& figure : figures) {
    files.add(target(figure), figure.svg);
    std::string caption = figure.caption;
    for (char& c : caption) c = c == '\n' ? ' ' : c;
    out += row(figure.name, caption);
  }
  files.write();
  out += files.summary();
  return kExitSolved;
}

}  // namespace

void add_figures_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "figures",
      "Draw the paper's figures 1 to 7, figure 5 of a tractor with a mower, a gallery of bodies, and a drive");
  const auto folder = std::make_shared<std::string>();
  command
      ->add_option(
          "--out", *folder,
          "Folder for figure1.svg to figure7.svg, figure5_tractor.svg, bodies.svg, live.svg and live_moments.svg")
      ->required();
  command->callback([&action, folder] { action = [folder](std::string& out) { return draw_figures(*folder, out); }; });
}

}  // namespace arcway::internal::cli
