#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/closed_spline.h"
#include "arcway/datasets/map_file.h"
#include "arcway/datasets/vector_options.h"
#include "datasets/formats/coordinate_system.h"

namespace arcway::internal::detail {

/// Gathers what a reader of polygons finds. Private to datasets/*.cpp.
class VectorMapBuilder {
 public:
  /// @param name  of the source, for messages.
  VectorMapBuilder(std::string_view name, const VectorOptions& options) : name_(name), options_(options) {}

  /// Drops consecutive repetitions and the closing position; as_written, one closing position alone where the format
  /// wants one.
  /// @param closed  whether the format repeats the first position at the end; warns if it is not there.
  /// @throws FormatError if fewer than three different positions are left.
  Ring ring(Ring positions, bool closed, const std::string& place);
  /// A ring around a closed chain of cubics. The obstacle lies to the left of a counter-clockwise chain if `wanted` is
  /// +1, and to the left of a clockwise one if -1. A chain that runs the other way is reversed.
  /// @throws FormatError if it has no area or no ring can be made.
  Ring curved_ring(std::vector<CubicBezier>& pieces, int wanted, const std::string& place);
  /// The curve of each ring, outer ring first; empty for none. Nothing: no curves.
  using Curves = std::vector<std::vector<CubicBezier>>;
  void add_obstacle(Polygon polygon, std::string place, Curves curves = {});
  /// A polygon that the file says nothing of: an obstacle, or free space, as the options say.
  void add_polygon(Polygon polygon, std::string place, Curves curves = {});
  /// The winding of the outer ring of such a polygon that has blocked ground on the left, for curved_ring.
  [[nodiscard]] int outer_winding() const { return options_.free_polygons ? -1 : 1; }
  /// The outer ring is the bounds, the holes are obstacles.
  /// @throws FormatError if there are bounds already.
  void set_bounds(Polygon free_space, const std::string& place, Curves curves = {});
  void add_line(std::vector<Vec2> positions, const std::string& place);
  /// A geometry that is no obstacle.
  void pass_over(const std::string& place, std::string_view type);
  /// Coordinates are meters, however much they look like degrees.
  void set_planar() { system_unit_ = CoordinateUnit::kMeters; }
  /// The file names a coordinate system: see coordinate_unit.
  void set_system(std::string_view name);
  void warn(const std::string& place, const std::string& message);
  [[noreturn]] void fail(const std::string& place, const std::string& message) const;

  /// Start, goal and notes are the reader's.
  MapFile& map() { return map_; }
  /// Builds walls, projects, warns of degrees.
  MapFile finish();

 private:
  struct FreePolygon {
    Polygon polygon;
    std::string place;
    Curves curves;
  };
  template <class Visit>
  void visit_positions(Visit visit);
  void enclose_free_space();  // in free_space.cpp
  void settle_coordinates();  // in vector_map_coordinates.cpp, as what follows
  void warn_of_system(const Box& box);
  void project();
  void add_walls();

  std::string name_;
  VectorOptions options_;
  MapFile map_;
  std::string system_;                         // as the file names it
  std::optional<CoordinateUnit> system_unit_;  // none if the file says nothing
  std::vector<std::pair<std::vector<Vec2>, std::string>> lines_;
  std::vector<FreePolygon> free_;
  std::size_t curve_vertices_ = 0;
  std::size_t passed_over_ = 0;
  bool passes_lines_ = false;  // lines among them
  std::string passed_place_;
};

}  // namespace arcway::internal::detail
