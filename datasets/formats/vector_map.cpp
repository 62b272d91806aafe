#include "datasets/formats/vector_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "arcway/angle.h"
#include "arcway/polygon.h"
#include "core/model/pose_text.h"

namespace arcway::internal::detail {
namespace {

constexpr std::size_t kMostCurveVertices = 1'000'000;

}  // namespace

void VectorMapBuilder::fail(const std::string& place, const std::string& message) const {
  throw FormatError(name_ + (place.empty() ? "" : ": " + place) + ": " + message);
}

void VectorMapBuilder::warn(const std::string& place, const std::string& message) {
  map_.warnings.push_back(name_ + (place.empty() ? "" : ": " + place) + ": " + message);
}

Ring VectorMapBuilder::ring(Ring positions, bool closed, const std::string& place) {
  const std::size_t given = positions.size();
  if (options_.as_written) {
    if (closed && positions.size() > 1 && positions.front() == positions.back()) positions.pop_back();
    return positions;
  }
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  if (positions.size() > 1 && positions.front() == positions.back()) {
    positions.pop_back();
  } else if (closed && positions.size() > 2) {
    warn(place, "ring is not closed; closed");
  }
  if (positions.size() < 3)
    fail(place, "needs at least 3 different positions, found " + std::to_string(positions.size()) + " in " +
                    std::to_string(given) + " positions");
  return positions;
}

Ring VectorMapBuilder::curved_ring(std::vector<CubicBezier>& pieces, int wanted, const std::string& place) {
  // The tolerance is in meters, and so is what bends: projected afterwards it would be neither.
  if (options_.lonlat) fail(place, "curves need planar coordinates in meters, not longitude and latitude");
  try {
    Ring ring = circumscribed_ring(pieces, options_.curve_tolerance);
    curve_vertices_ += ring.size();
    if (curve_vertices_ > kMostCurveVertices)
      fail(place, "the curves so far have " + std::to_string(curve_vertices_) + " vertices within the tolerance of " +
                      shortest_text(options_.curve_tolerance) + " m; at most " + std::to_string(kMostCurveVertices) +
                      " are taken");
    const int found = ring.size() < 3 ? 0 : winding(ring);
    if (found == 0) fail(place, "the curve encloses no area");
    if (found == wanted) return ring;
    std::reverse(pieces.begin(), pieces.end());
    for (CubicBezier& piece : pieces) std::reverse(piece.p.begin(), piece.p.end());
    return circumscribed_ring(pieces, options_.curve_tolerance);
  } catch (const std::invalid_argument& error) {
    fail(place, error.what());
  }
}

void VectorMapBuilder::add_obstacle(Polygon polygon, std::string place, Curves curves) {
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (!curves[i].empty()) map_.curves.push_back({map_.obstacles.size(), i, std::move(curves[i])});
  map_.obstacles.push_back(std::move(polygon));
  map_.places.push_back(std::move(place));
}

void VectorMapBuilder::add_polygon(Polygon polygon, std::string place, Curves curves) {
  if (!options_.free_polygons) return add_obstacle(std::move(polygon), std::move(place), std::move(curves));
  free_.push_back({std::move(polygon), std::move(place), std::move(curves)});
}

void VectorMapBuilder::set_bounds(Polygon free_space, const std::string& place, Curves curves) {
  if (map_.bounds) fail(place, "second bounds; the first are in " + map_.bounds_place);
  map_.bounds = std::move(free_space.outer);
  map_.bounds_place = place;
  curves.resize(1 + free_space.holes.size());
  if (!curves[0].empty()) map_.curves.push_back({CurvedRing::kBounds, 0, std::move(curves[0])});
  for (std::size_t i = 0; i < free_space.holes.size(); ++i)
    add_obstacle({std::move(free_space.holes[i]), {}}, place + ", ring " + std::to_string(i + 1),
                 {std::move(curves[i + 1])});
}

void VectorMapBuilder::add_line(std::vector<Vec2> positions, const std::string& place) {
  if (!(options_.wall_width > 0.0)) {
    passes_lines_ = true;
    return pass_over(place, "LineString");
  }
  lines_.emplace_back(std::move(positions), place);
}

void VectorMapBuilder::pass_over(const std::string& place, std::string_view type) {
  if (passed_over_++ == 0) passed_place_ = place + " (" + std::string(type) + ")";
}

MapFile VectorMapBuilder::finish() {
  for (const auto& [what, pose] : {std::pair{"start", &map_.start}, {"goal", &map_.goal}})
    if (*pose && std::abs((*pose)->heading) > kTwoPi)
      warn(what, "heading is " + shortest_text((*pose)->heading) + " rad, more than a full turn: are these degrees? " +
                     "Headings of files are in radians");
  settle_coordinates();
  enclose_free_space();
  add_walls();
  if (passed_over_ > 0) {
    const std::string which =
        std::to_string(passed_over_) +
        (passed_over_ == 1 ? " geometry that is not a polygon" : " geometries that are not polygons, the first one") +
        " in " + passed_place_;
    const std::string advice = passes_lines_ ? "; with a wall width line strings are walls (--wall-width)" : "";
    if (map_.obstacles.empty() && !map_.bounds) fail("", "no polygons, but " + which + advice);
    warn("", "passed over " + which + advice);
  }
  return std::move(map_);
}

void VectorMapBuilder::add_walls() {
  for (const auto& [line, place] : lines_) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2 along = line[i] - line[i - 1];
      const double length = along.norm();
      if (length == 0.0) continue;
      const Vec2 u = along * (0.5 * options_.wall_width / length), n = perpendicular(u);
      add_obstacle({{line[i - 1] - u - n, line[i] + u - n, line[i] + u + n, line[i - 1] - u + n}, {}},
                   place + ", line segment " + std::to_string(i - 1));
    }
  }
  lines_.clear();
}

}  // namespace arcway::internal::detail
