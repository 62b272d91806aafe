#include "bench/cli/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "arcway/angle.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/file_io.h"
#include "arcway/datasets/filter_mask.h"
#include "arcway/datasets/paper_example.h"
#include "arcway/datasets/robot.h"
#include "bench/cli/standard_streams.h"
#include "core/model/pose_text.h"
#include "core/roadmap/feasible_graph.h"
#include "datasets/io/nearest_word.h"
#include "datasets/io/number_text.h"
#include "datasets/io/shortened.h"

namespace arcway::internal::cli {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.push_back(trimmed(text.substr(0, at)));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

// A name that is neither a file nor of the catalog, but near one of its families.
void refuse_family(const std::string& name) {
  if (std::filesystem::exists(name)) return;
  std::vector<std::string_view> families;
  for (const CatalogFamily& family : catalog_families()) families.push_back(family.name);
  const std::string_view first = std::string_view(name).substr(0, name.find('/'));
  if (!nearest_word(first, families).empty())
    throw UsageError(name + ": no such file, and in the catalog " + unknown_word("family", first, families));
}

}  // namespace

std::string in_quotes(std::string_view text) { return "\"" + shortened(text) + "\""; }

double parse_number(std::string_view text, std::string_view what) {
  const std::optional<double> value = read_number(trimmed(text));
  if (!value) throw UsageError(std::string(what) + ": expected a finite number, got " + in_quotes(text));
  return *value;
}

std::uint64_t parse_count(std::string_view text, std::string_view what) {
  const std::string_view digits = trimmed(text);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw UsageError(std::string(what) + ": expected a whole number >= 0, got " + in_quotes(text));
  return value;
}

double parse_heading(std::string_view text, std::string_view what) {
  text = trimmed(text);
  constexpr std::string_view kDegrees = "deg";
  if (text.size() > kDegrees.size() && text.substr(text.size() - kDegrees.size()) == kDegrees) {
    text.remove_suffix(kDegrees.size());
    return std::fmod(parse_number(text, what), 360.0) / 180.0 * kPi;  // whole turns are of no matter
  }
  return parse_number(text, what);
}

Pose parse_pose(std::string_view text, std::string_view what) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 3) {
    throw UsageError(std::string(what) + ": expected X,Y,HEADING (radians, or degrees as in 90deg), got " +
                     in_quotes(text));
  }
  const std::string name(what);
  return {parse_number(parts[0], name + " x"), parse_number(parts[1], name + " y"),
          parse_heading(parts[2], name + " heading")};
}

Place parse_place(std::string_view text, std::string_view what) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() == 2) {
    const std::string name(what);
    return {{parse_number(parts[0], name + " x"), parse_number(parts[1], name + " y")}};
  }
  if (parts.size() != 3)
    throw UsageError(std::string(what) + ": expected X,Y or X,Y,HEADING (radians, or degrees as in 90deg), got " +
                     in_quotes(text));
  const Pose pose = parse_pose(text, what);
  return {pose.position(), pose.heading};
}

void MapOptions::add_to(CLI::App& command, const std::string& map) {
  const std::string group = "Reading " + map;
  const auto option = [&](const char* name, std::string& value, const char* what, const char* type) {
    return command.add_option(name, value, what)->type_name(type)->group(group);
  };
  command
      .add_flag("--lonlat", lonlat,
                "Coordinates of " + map +
                    " are degrees of longitude and latitude, or Web Mercator: project them to meters on the ground "
                    "around their middle")
      ->group(group);
  command
      .add_flag("--planar", planar,
                "Coordinates of " + map + " are meters, whatever the file says or they look like: no warning")
      ->group(group);
  std::string formats;
  for (const std::string_view word : format_words()) formats.append(formats.empty() ? "" : ", ").append(word);
  option("--format", format, ("What the file is, if not what its content looks like: " + formats).c_str(), "NAME");
  option("--polygons", polygons, "What polygons without a role are: blocked, or free, with walls all around", "NAME")
      ->capture_default_str();
  option("--wall-width", wall_width, "Line strings are walls of this width [m]", "W");
  option("--curve-tolerance", curve_tolerance, "Smooth outlines become rings this near [m]; default 0.01", "E");
  option("--cell", cell, "Size of a cell [m], if the file does not say; default: 1 of MovingAI maps, 0.05 of an image",
         "S");
  option("--tolerance", tolerance, "Obstacles of a grid may grow by this many cells to save corners", "CELLS");
  option("--unknown", unknown, "What unknown cells are: blocked or free", "NAME")->capture_default_str();
  option("--free-letters", free_letters,
         "Letters of MovingAI maps that are free beside . and G; others that are not known are obstacles then",
         "LETTERS");
  command.add_flag("--swamp-free", swamp, "Swamp of MovingAI maps is free")->group(group);
  command.add_flag("--open-frame", open_frame, "The frame of a grid is no wall")->group(group);
  option("--task", task, "Task of a MovingAI scenario, from 0", "N")->capture_default_str();
  option("--heading-seed", heading_seed, "Seed of the headings of its start and goal", "N")->capture_default_str();
  option("--keepout-mask", keepout_mask, "Keep-outs from a mask of Nav2's keepout filter: cells of 100", "FILE.yaml");
  option("--speed-mask", speed_mask, "Speed limits from a mask of Nav2's speed filter", "FILE.yaml");
  option("--mask-type", mask_type, "What the limits of the speed mask are: percent of the top speed, or absolute [m/s]",
         "NAME")
      ->capture_default_str();
  option("--mask-base", mask_base, "Limit of the value 0 of the speed mask: limits are base + multiplier * value", "B")
      ->capture_default_str();
  option("--mask-multiplier", mask_multiplier, "Change of the limit by each unit of the value", "M")
      ->capture_default_str();
  option("--mask-max-speed", mask_max_speed, "The robot's top speed, of which percents are taken [m/s]", "V");
}

void MapOptions::add_masks(MapFile& map) const {
  if (mask_type != "percent" && mask_type != "absolute")
    throw UsageError("--mask-type: expected percent or absolute, got " + in_quotes(mask_type));
  const auto add = [&](const std::string& file, const FilterMaskOptions& options) {
    FilterMask mask = read_filter_mask(file, options);
    // Places of zones for messages, where the map has them.
    map.zone_places.resize(map.zones.size());
    for (Zone& zone : mask.zones) {
      map.zones.push_back(std::move(zone));
      map.zone_places.push_back(file);
    }
    map.warnings.insert(map.warnings.end(), mask.warnings.begin(), mask.warnings.end());
    map.notes.insert(map.notes.end(), mask.notes.begin(), mask.notes.end());
    map.files.insert(map.files.end(), mask.files.begin(), mask.files.end());
  };
  FilterMaskOptions options;
  if (!tolerance.empty()) options.tolerance = parse_number(tolerance, "--tolerance");
  if (!keepout_mask.empty()) add(keepout_mask, options);
  if (speed_mask.empty()) return;
  options.type = mask_type == "percent" ? FilterMaskType::kSpeedPercent : FilterMaskType::kSpeed;
  options.base = parse_number(mask_base, "--mask-base");
  options.multiplier = parse_number(mask_multiplier, "--mask-multiplier");
  if (options.type == FilterMaskType::kSpeedPercent) {
    if (mask_max_speed.empty())
      throw UsageError(
          "--speed-mask: limits in percent need the robot's top speed, --mask-max-speed V; or --mask-type absolute");
    options.max_speed = parse_number(mask_max_speed, "--mask-max-speed");
    if (!(options.max_speed > 0.0)) throw UsageError("--mask-max-speed: above 0, got " + in_quotes(mask_max_speed));
  }
  add(speed_mask, options);
}

MapReadOptions MapOptions::read_options() const {
  const auto at_least_zero = [](const std::string& text, const char* what) {
    const double value = parse_number(text, what);
    if (value < 0.0) throw UsageError(std::string(what) + ": at least 0, got " + in_quotes(text));
    return value;
  };
  MapReadOptions options;
  if (lonlat && planar) throw UsageError("--planar: coordinates are either meters or degrees; leave out --lonlat");
  if (!format.empty()) options.format = format_of_word(format);
  if (!format.empty() && !options.format)
    throw UsageError("--format: " + unknown_word("format", format, format_words()));
  if (polygons != "blocked" && polygons != "free")
    throw UsageError("--polygons: expected blocked or free, got " + in_quotes(polygons));
  options.vector.free_polygons = polygons == "free";
  if (!free_letters.empty()) options.grid.free_letters = free_letters;
  options.vector.lonlat = lonlat;
  options.vector.planar = planar;
  if (!wall_width.empty()) options.vector.wall_width = at_least_zero(wall_width, "--wall-width");
  if (!curve_tolerance.empty()) {
    options.vector.curve_tolerance = parse_number(curve_tolerance, "--curve-tolerance");
    if (!(options.vector.curve_tolerance > 0.0))
      throw UsageError("--curve-tolerance: above 0, got " + in_quotes(curve_tolerance));
  }
  if (!cell.empty()) {
    options.grid.cell_size = parse_number(cell, "--cell");
    if (!(*options.grid.cell_size > 0.0)) throw UsageError("--cell: above 0, got " + in_quotes(cell));
  }
  if (!tolerance.empty()) options.grid.tolerance = at_least_zero(tolerance, "--tolerance");
  if (unknown != "blocked" && unknown != "free")
    throw UsageError("--unknown: expected blocked or free, got " + in_quotes(unknown));
  options.grid.unknown_is_free = unknown == "free";
  options.grid.swamp_is_free = swamp;
  options.grid.walled = !open_frame;
  options.task = parse_count(task, "--task");
  options.heading_seed = parse_count(heading_seed, "--heading-seed");
  return options;
}

std::string input_file(const std::string& name) {
  if (name != "-") return name;
  static const std::string copy = copy_of_standard_input();
  return copy;
}

MapFile read_named_map(const std::string& given, const MapOptions& options, bool as_written) {
  const std::string name = input_file(given);
  MapReadOptions read_options = options.read_options();
  read_options.vector.as_written = as_written;
  const bool is_file = std::filesystem::is_regular_file(name), generated = is_catalog_name(name) && !is_file;
  if (!is_file && !generated && name.find('.') == std::string::npos) refuse_family(name);
  MapFile map = generated ? catalog_map(name) : read_map(name, read_options);
  options.add_masks(map);
  return map;
}

void close_for(const Vehicle& vehicle, LoadedMap& map) {
  const World closed = map.world.for_vehicle(vehicle);
  if (closed.vertices().data() == map.world.vertices().data()) return;
  map.world = closed;
  if (!map.prepared) return;
  map.prepared.reset();
  map.notes.push_back("the map was prepared for a robot with other keep-outs; its graphs are built anew");
}

LoadedMap load_map(const std::string& given, const MapOptions& options) {
  const std::string name = input_file(given);
  if (is_prepared_map_file(name)) {
    PreparedMap map = read_prepared_map_file(name);
    LoadedMap loaded{map.world, map.start, map.goal, {}, {}, {}, CoordinateFrame::kMeters, {name}, std::move(map)};
    if (options.lonlat || options.polygons == "free")
      loaded.warnings.push_back(name +
                                ": a prepared map has obstacles in meters; --lonlat and --polygons are not used");
    if (!options.keepout_mask.empty() || !options.speed_mask.empty())
      throw UsageError(name +
                       ": a prepared map has its zones; give --keepout-mask and --speed-mask to `arcway prepare`");
    return loaded;
  }
  MapFile map = read_named_map(name, options);
  World world = to_world(map, name);
  CurvedWorld curved;
  if (!map.curves.empty()) curved = {std::move(map.obstacles), std::move(map.bounds), std::move(map.curves)};
  return {std::move(world),
          map.start,
          map.goal,
          std::move(curved),
          std::move(map.warnings),
          std::move(map.notes),
          map.frame,
          std::move(map.files),
          std::nullopt};
}

Vehicle load_vehicle(const std::string& file) {
  if (file.empty()) return Vehicle(paper_example().robot);
  const VehicleParameters parameters = read_robot_file(input_file(file));
  try {
    return Vehicle(parameters);
  } catch (const std::invalid_argument& error) {
    throw UsageError(file + ": " + error.what());
  }
}

Vehicle load_vehicle(const std::string& file, LoadedMap& map) {
  const bool of_map = file.empty() && map.prepared && map.prepared->robot;
  Vehicle vehicle = of_map ? Vehicle(map.prepared->robot->parameters) : load_vehicle(file);
  warn_of(vehicle, map);
  return vehicle;
}

std::string warning_rows(const LoadedMap& map) {
  std::string text;
  for (const std::string& note : map.notes) text += row("read", note);
  for (const std::string& warning : map.warnings) text += row("warning", warning);
  return text;
}

std::string feasible_row(const Planner& planner) {
  const FeasibleGraphCounts counts = planner.feasible_graph().counts();
  const bool lazy = planner.feasible_graph().finished() == nullptr;
  return row("feasible graph", count_text(counts.kept) + " of " + count_text(counts.candidates) +
                                   " directed bitangents on " + count_text(counts.circles) + " turn circles" +
                                   (lazy ? ", found as the search needed them" : ""));
}

std::string world_rows(const World& world) {
  std::string text = row("obstacles", count_text(world.obstacle_count()));
  text += row("vertices", count_text(world.vertices().size()) + " (" + count_text(world.graph_vertex_count()) +
                              " convex and free)");
  const Box& box = world.box();
  if (!box.empty()) {
    text += row("extent", fixed(box.max.x() - box.min.x(), 3) + " x " + fixed(box.max.y() - box.min.y(), 3) + " m" +
                              (world.has_bounds() ? ", bounded" : ", unbounded") + ": (" + fixed(box.min.x(), 3) +
                              ", " + fixed(box.min.y(), 3) + ") to (" + fixed(box.max.x(), 3) + ", " +
                              fixed(box.max.y(), 3) + ")");
  }
  return text;
}

std::string heading_warning(std::string_view what, double heading) {
  if (std::abs(heading) <= kTwoPi) return "";
  return std::string(what) + " heading is " + shortest_text(heading) + " rad, more than a full turn: did you mean " +
         shortest_text(heading) + "deg?";
}

std::vector<std::string> vehicle_warnings(const Vehicle& vehicle) {
  constexpr double kLongest = 3.0;  // bodies by their wheelbase: that of a long bus is 2.1
  const VehicleParameters& p = vehicle.parameters();
  if (p.front_overhang || !p.footprint.empty()) return {};
  const std::string measures = "the robot's wheelbase of " + shortest_text(p.wheelbase) + " m ";
  std::vector<std::string> warnings;
  if (p.wheelbase > p.length)
    warnings.push_back(measures + "is longer than its body of " + shortest_text(p.length) +
                       " m: its axles lie outside of the body; are length and wheelbase swapped?");
  if (p.length > kLongest * p.wheelbase)
    warnings.push_back(measures + "is less than a third of its body of " + shortest_text(p.length) +
                       " m, which reaches " + shortest_text(0.5 * (p.length - p.wheelbase)) +
                       " m beyond each axle; are both given, in meters?");
  return warnings;
}

void warn_of(const Vehicle& vehicle, LoadedMap& map) {
  for (std::string& warning : vehicle_warnings(vehicle))
    if (std::ranges::find(map.warnings, warning) == map.warnings.end()) map.warnings.push_back(std::move(warning));
}

std::vector<NumberedRequest> read_queries(const std::string& file, std::vector<std::string>& warnings) {
  const std::string text = read_file(input_file(file));
  std::string_view rest = text;
  if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);
  constexpr std::array<std::string_view, 7> kColumns = {"q", "sx", "sy", "stheta", "gx", "gy", "gtheta"};
  constexpr std::array<std::string_view, 7> kWithUnits = {"q",    "sx_m", "sy_m",      "stheta_rad",
                                                          "gx_m", "gy_m", "gtheta_rad"};
  constexpr std::string_view kHeader = kQueryColumns;
  std::vector<NumberedRequest> queries;
  bool header_seen = false;
  std::size_t turns = 0;  // headings beyond a full turn
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.empty() || line.front() == '#') continue;
    const std::string where = file + ":" + std::to_string(line_number);
    const std::vector<std::string_view> fields = split(line, ',');
    if (!header_seen) {
      if (!std::ranges::equal(fields, kColumns) && !std::ranges::equal(fields, kWithUnits)) {
        throw UsageError(where + ": expected the header " + std::string(kHeader) + ", got " + in_quotes(line));
      }
      header_seen = true;
      continue;
    }
    if (fields.size() != kColumns.size()) {
      throw UsageError(where + ": expected 7 fields (" + std::string(kHeader) + "), got " +
                       std::to_string(fields.size()) + ": " + in_quotes(line));
    }
    const auto what = [&](std::size_t column) { return where + ": " + std::string(kColumns[column]); };
    const auto number = [&](std::size_t column) { return parse_number(fields[column], what(column)); };
    const auto heading = [&](std::size_t column) { return parse_heading(fields[column], what(column)); };
    queries.push_back({parse_count(fields[0], what(0)),
                       {.start = {number(1), number(2), heading(3)}, .goal = {number(4), number(5), heading(6)}}});
    for (const auto& [column, pose] : {std::pair{3, &queries.back().request.start}, {6, &queries.back().request.goal}})
      if (std::string warning = heading_warning(what(static_cast<std::size_t>(column)), pose->heading);
          !warning.empty() && turns++ == 0)
        warnings.push_back(std::move(warning));
  }
  if (turns > 1) warnings.back() += " " + count_text(turns - 1) + " more of this file are beyond a full turn";
  if (!header_seen) throw UsageError(file + ": no queries; expected the header " + std::string(kHeader));
  return queries;
}

std::string fixed(double value, int digits) {
  if (!std::isfinite(value)) return shortest_text(value);
  std::array<char, 384> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  return {buffer.data(), end};
}

std::string duration_text(double seconds) {
  return seconds < 1.0 ? fixed(1e3 * seconds, 3) + " ms" : fixed(seconds, 3) + " s";
}

std::string count_text(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3;) {
    at -= 3;
    text.insert(at, ",");
  }
  return text;
}

std::string pose_text(const Pose& pose) {
  return "(" + fixed(pose.x, 3) + ", " + fixed(pose.y, 3) + "), heading " + fixed(pose.heading, 4) + " rad";
}

std::string place_text(const Place& place) {
  if (place.heading) return pose_text({place.position.x(), place.position.y(), *place.heading});
  return "(" + fixed(place.position.x(), 3) + ", " + fixed(place.position.y(), 3) + "), any heading";
}

std::string row(std::string_view label, std::string_view value) {
  constexpr std::size_t kColumn = 22;
  std::string text = "  " + std::string(label);
  text.append(text.size() < kColumn ? kColumn - text.size() : 1, ' ');
  return text + std::string(value) + "\n";
}

}  // namespace arcway::internal::cli
