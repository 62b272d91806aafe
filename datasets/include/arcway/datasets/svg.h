#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/plan_result.h"
#include "arcway/trajectory.h"
#include "arcway/vec2.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// How a set of edges is drawn.
struct EdgeStyle {
  std::string_view color = "#5b8def";
  double width = 0.8;     ///< [px]
  double opacity = 0.35;  ///< in [0, 1]
};

/// A picture of a world in layers. Layers are groups with the ids bounds, obstacles, zones, graph, swept, path, robot,
/// numbers, axes, markers and caption, which Inkscape shows as layers. Zones are hatched, one-way zones by arrows, with
/// a legend below the map.
///
/// All but the numbers, axes, markers and the caption lie in the group "map". That has the world's meters with y up,
/// rounded to a tenth of a pixel or finer. On maps far from the origin the meters are from the view's corner. The world
/// need not outlive the picture.
class ARCWAY_API SvgPicture {
 public:
  /// @param width  of the map in the picture [px]; the height follows.
  explicit SvgPicture(const World& world, double width = 1200.0);
  /// @param view  part of the map to show, enlarged by a border.
  SvgPicture(const World& world, const Box& view, double width = 1200.0);

  /// Edges in one path element, as group `id`; of more than 50,000 an even sample, as readers choke on them.
  /// @return one in how many is drawn.
  std::size_t add_edges(std::span<const LineSegment> edges, const EdgeStyle& style = {}, std::string_view id = "graph");
  /// Draws the path, the body's outlines along it, dots where the gear changes, and the poses at its ends. Segments
  /// driven backwards are blue and dashed, as a line below the map then says. After alternatives the path has one
  /// color, and dashes alone tell the gears apart.
  /// @param text  below the map, before those of alternatives.
  void add_path(std::span<const PathSegment> path, const Body& body, std::string_view text = {});
  /// Draws an alternative path in the next color of a palette that color-blind people can tell apart. Segments driven
  /// backwards are dashed. Its color and a text appear below the map. Call it before adding the path.
  void add_alternative(std::span<const PathSegment> path, const Body& body, std::string_view text);
  /// Draws the area that the body sweeps along the path, below the path: exact on lines, within half a pixel on arcs.
  void add_swept_area(std::span<const PathSegment> path, const Body& body);
  /// Draws the path in colors of the speed in place of add_path's line, with a legend below the map. Call it after
  /// add_path. Steps of color are at most a fortieth of the highest speed.
  void add_speeds(const Trajectory& trajectory);
  /// Marks meters along the left and the lower edge, and draws a scale bar.
  void add_axes();
  /// Writes the number of each obstacle in its middle, counted from 0; of more than 2,000 of none.
  void add_obstacle_numbers(const World& world);
  /// Outlines of the body.
  void add_bodies(std::span<const Pose> poses, const Body& body);
  /// Start and goal when there is no path.
  void add_poses(const Pose& start, const Pose& goal, const Body& body);
  /// Draws a waypoint among the markers, with a text beside it.
  void add_place(const Vec2& place, std::string_view text);
  /// Draws a gap from one point to another among the markers, with a text beside it.
  void add_gap(const Vec2& a, const Vec2& b, std::string_view text);
  /// Draws the surroundings of a place once more, magnified, in the corner of the map that the path covers least.
  /// @param side  of the square that is shown [m], > 0.
  /// @param text  above the inset.
  void add_inset(const Vec2& place, double side, std::string_view text = {});
  /// All layers but the caption.
  static std::span<const std::string_view> layers();
  /// Empties all layers but these.
  /// @throws std::invalid_argument naming one that there is not.
  void show(std::span<const std::string> layers);
  /// A text below the map, on as many lines as it takes.
  void add_caption(std::string_view text);
  /// Title and description for readers that do not see the picture.
  void set_title(std::string_view title, std::string_view description = {});

  /// The document, newline at its end.
  [[nodiscard]] std::string str() const;

 private:
  void add_map(const World& world);
  void add_zones(const World& world);
  void add_ring(std::string& out, std::span<const Vec2> ring) const;
  void add_rings(std::string& out, const Polygon& polygon) const;
  struct Colors {
    std::string_view forward, reverse;
  };
  void add_line(std::span<const PathSegment> path, const Body& body, const Colors& colors);
  /// Segments of one gear as one line.
  void add_run(std::span<const PathSegment> run, bool bodies, const Colors& colors);
  /// The body at a pose, lengthened to the front.
  void add_outline(std::string& out, const Pose& pose, const Body& body, double ahead) const;
  void add_dot(const Vec2& at, std::string_view color, double radius);
  void add_marker(const Pose& pose, const Body& body, std::string_view color, std::string_view label);
  /// A mark of an axis: a short line and a text in meters.
  void add_tick(const Vec2& at, const Vec2& line, double meters);
  /// What lies below the map.
  void append_captions(std::string& out, const std::vector<std::string>& captions) const;
  void append_inset(std::string& out) const;
  /// The left upper corner of the place for an inset of this size [px].
  [[nodiscard]] Vec2 corner_for_inset(double size) const;
  /// Lines of a text that fit below the map.
  [[nodiscard]] std::vector<std::string> wrapped(std::string_view text) const;
  /// A text beside a point of the picture, and within it.
  void add_label(const Vec2& beside, std::string_view color, std::string_view text);
  /// Attributes of a line within the group "map".
  [[nodiscard]] std::string stroke(std::string_view color, double pixels) const;
  [[nodiscard]] Vec2 to_picture(const Vec2& p) const;
  /// Within the group "map".
  void append_point(std::string& out, const Vec2& p) const;

  Box view_;
  double scale_ = 1.0;
  double width_ = 0.0, height_ = 0.0;
  Vec2 origin_{0.0, 0.0};  // origin of the picture's meters
  double parts_ = 10.0;    // parts of a meter that coordinates are rounded to
  std::string bounds_, obstacles_, zones_, graph_, swept_, path_, robot_, numbers_, axes_, markers_;
  std::string legend_;  // of speeds, below the captions
  std::vector<std::string> captions_;
  std::vector<std::string> zone_legends_;  // one a role
  struct Inset {
    Vec2 place;   // [m]
    double side;  // [m]
    std::string text;
  };
  std::optional<Inset> inset_;
  std::vector<Vec2> driven_;  // points of the path [px]
  std::size_t alternatives_ = 0;
  bool backwards_ = false;  // some path is driven so
  std::string title_, description_;
};

/// Writes a picture of a plan in its world: the path in colors of speed, the swept area, axes. Without a path it shows
/// start, goal and the reason. SvgPicture draws other choices.
/// @throws FileError if the file cannot be written; std::invalid_argument if no planner made the result.
ARCWAY_API void write_svg(const std::filesystem::path& path, const PlanResult& result);

}  // namespace arcway
