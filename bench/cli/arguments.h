#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/datasets/prepared_map.h"
#include "arcway/datasets/read_map.h"
#include "arcway/planner.h"
#include "arcway/tour.h"
#include "arcway/world_change.h"
#include "core/base/stopwatch.h"

namespace arcway::internal::cli {

/// A mistake on the command line. Like every other exception it ends the tool with exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int kExitSolved = 0;
inline constexpr int kExitNoPath = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInterrupted = 130;  ///< as shells say of SIGINT

/// Action of a subcommand once the command line is read; returns the exit code. It appends to the text for standard
/// output, which is printed only if the action does not throw.
using Action = std::function<int(std::string& out)>;

/// @param process_group  processes that run the same command together; the first one prints and writes.
void add_plan_command(CLI::App& app, Action& action, const ProcessGroup& process_group);
void add_prepare_command(CLI::App& app, Action& action, const ProcessGroup& process_group);
void add_change_command(CLI::App& app, Action& action);
void add_graph_command(CLI::App& app, Action& action);
void add_generate_command(CLI::App& app, Action& action);
void add_validate_command(CLI::App& app, Action& action);
void add_convert_command(CLI::App& app, Action& action);
void add_doctor_command(CLI::App& app, Action& action);
void add_bench_command(CLI::App& app, Action& action);
void add_report_command(CLI::App& app, Action& action);
void add_figures_command(CLI::App& app, Action& action);

/// A text in quotes for messages, cut if long.
std::string in_quotes(std::string_view text);

/// Reads the whole text as one finite number, in any locale.
/// @throws UsageError naming `what` and the text.
double parse_number(std::string_view text, std::string_view what);
std::uint64_t parse_count(std::string_view text, std::string_view what);
/// Reads an angle in radians, or in degrees as in `90deg`.
double parse_heading(std::string_view text, std::string_view what);
/// Reads a pose `X,Y,H`.
Pose parse_pose(std::string_view text, std::string_view what);
/// Reads a pose `X,Y,H`, or a position `X,Y` for any heading.
Place parse_place(std::string_view text, std::string_view what);

/// Options for the implementation of geometric queries and graph builders, shared by all subcommands. They change
/// speed, not results.
struct BuildOptions {
  std::string backend;  ///< "reference" or "embree"; embree is the default where this build has it
  std::string builder = "auto";
  bool prepared = false;  ///< the reduced graph comes from a file
  std::string threads;    ///< default: all of the machine with embree, one with reference

  BuildOptions();
  void add_to(CLI::App& command);
  /// @throws UsageError unless this build has the backend and the builder, and the number of threads is valid.
  void check() const;

  /// Makes the queries on the executor's threads.
  /// @throws Canceled if its clock is over before.
  [[nodiscard]] QuerySet queries(const World& world, const Executor& executor) const;
  [[nodiscard]] std::unique_ptr<const Executor> executor() const;
  /// Backend for planners. All arguments but the world must outlive the planners' construction.
  [[nodiscard]] Backend backend_for(const World& world, const Executor& executor,
                                    const ProcessGroup& process_group) const;
  /// Builds the reduced graph; makes queries only if the builder needs them.
  [[nodiscard]] VisibilityGraph reduced_graph_of(const World& world, const Executor& executor,
                                                 const ProcessGroup& process_group = kSingleProcess) const;
  [[nodiscard]] VisibilityGraph full_graph_of(const World& world, const Executor& executor) const;

  /// Name of the builder in use: "tangent-cones", "pairwise" or "prepared".
  [[nodiscard]] std::string builder_name(const World& world) const;
  /// Number of threads, at most that of the machine.
  [[nodiscard]] std::size_t thread_count() const;
  /// Description of builder, backend and threads: "tangent-cones, embree, 2 threads".
  [[nodiscard]] std::string summary(const World& world) const;

 private:
  [[nodiscard]] std::size_t threads_asked_for() const;
};

/// The file that an argument names: itself, or for "-" a copy of standard input, which is read once.
/// @throws FileError if standard input cannot be read or copied.
std::string input_file(const std::string& name);

/// Help text of the argument that names a map.
inline constexpr const char* kMapHelp =
    "Map file (GeoJSON, WKT, SVG, ROS, MovingAI, TPCAP, plain text, prepared), or a name of the catalog: paper, "
    "clutter/star/n100; - is standard input";

/// A map as loaded: the world and, if it has them, start and goal.
struct LoadedMap {
  World world;
  std::optional<Pose> start, goal;
  CurvedWorld curved;  ///< the world with its curves; empty if it has none
  std::vector<std::string> warnings, notes;
  CoordinateFrame frame = CoordinateFrame::kUnstated;
  std::vector<std::filesystem::path> files;  ///< files that were read
  std::optional<PreparedMap> prepared;       ///< contents of a prepared map; its world is the one above
  std::vector<Polygon> added = {};           ///< obstacles to add to a prepared map once a planner holds its graphs
};

/// Makes the keep-outs of a map for a vehicle obstacles, and drops the graphs of a prepared map that has other ones.
void close_for(const Vehicle& vehicle, LoadedMap& map);

/// Options for reading map files, shared by all subcommands that read one.
struct MapOptions {
  bool lonlat = false, planar = false;
  std::string wall_width, curve_tolerance;
  std::string format, polygons = "blocked";
  std::string cell, tolerance, unknown = "blocked", free_letters;
  bool swamp = false, open_frame = false;
  std::string task = "0", heading_seed = "1";
  std::string keepout_mask, speed_mask, mask_type = "percent", mask_base = "0", mask_multiplier = "1", mask_max_speed;
  /// @param map  what the help text calls the file.
  void add_to(CLI::App& command, const std::string& map = "WORLD");
  /// @throws UsageError
  [[nodiscard]] MapReadOptions read_options() const;
  /// Adds the zones of the masks.
  /// @throws UsageError, FileError, FormatError
  void add_masks(MapFile& map) const;
};
/// Reads a map without checking it.
/// @param name  a file in one of the formats of read_map, or a world of the catalog if there is no such file.
/// @param as_written  see VectorOptions.
MapFile read_named_map(const std::string& name, const MapOptions& options, bool as_written = false);
/// Reads a map and checks it, as World does.
LoadedMap load_map(const std::string& name, const MapOptions& options);
/// Reads a robot file; the paper's robot if the name is empty.
Vehicle load_vehicle(const std::string& file);
/// Reads a robot file. If the name is empty, takes the robot that the map was prepared for, or else the paper's robot.
/// Doubtful measures become warnings of the map.
Vehicle load_vehicle(const std::string& file, LoadedMap& map);
/// Help text of `--robot`, which describes `load_vehicle`.
inline constexpr const char* kRobotHelp = "Robot (JSON, YAML); default: that of a prepared map, else the paper's";
/// Text with one line a note and one line a warning.
std::string warning_rows(const LoadedMap& map);
/// Row of the summary: "feasible graph     23 of 96 directed bitangents on 32 turn circles".
std::string feasible_row(const Planner& planner);
/// Rows of the summary: obstacles, vertices and size.
std::string world_rows(const World& world);

/// For a heading beyond a full turn, the question whether degrees were meant; else empty.
/// @param what  name of the pose, for the message.
std::string heading_warning(std::string_view what, double heading);
/// Doubtful measures of a robot, one sentence each.
std::vector<std::string> vehicle_warnings(const Vehicle& vehicle);
/// Adds doubtful measures of a robot to the map's warnings, each once.
void warn_of(const Vehicle& vehicle, LoadedMap& map);

struct NumberedRequest {
  std::uint64_t q;
  PlanRequest request;
};
/// Header of files of queries. Headings may also be given in degrees, as 90deg.
inline constexpr const char* kQueryColumns = "q,sx_m,sy_m,stheta_rad,gx_m,gy_m,gtheta_rad";
/// Reads queries with these columns, in the header also without units; lines that start with # and blank lines are
/// skipped.
/// @param warnings  gets what may not mean what its author meant.
/// @throws UsageError naming file, line and value.
std::vector<NumberedRequest> read_queries(const std::string& file, std::vector<std::string>& warnings);

/// Text of a number with a fixed number of digits after the point.
std::string fixed(double value, int digits);
/// Text of a time [s] with a unit that suits its size: "1.234 s", "12.3 ms".
std::string duration_text(double seconds);
/// Text of a count with separators: "12,345".
std::string count_text(std::uint64_t count);
std::string pose_text(const Pose& pose);
std::string place_text(const Place& place);

/// A row of the summary, "  label            value\n", with the values in one column.
std::string row(std::string_view label, std::string_view value);

}  // namespace arcway::internal::cli
